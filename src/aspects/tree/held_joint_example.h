// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_HELD_JOINT_EXAMPLE_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_HELD_JOINT_EXAMPLE_H

#include "parallel_aspects/model/manipulator.h"

#include <cstddef>
#include <string>

namespace parallel_aspects {

/// The actuated joint of this leg with a value at which it can be held, in few digits and in quotes, for
/// messages: "strut_1_joint=19". Empty where there is none, as of an actuated elbow.
std::string example_of_held_joint(const Manipulator& manipulator, std::size_t leg);

/// That of the first leg that has one; empty where none has.
std::string example_of_held_joint(const Manipulator& manipulator);

/// The actuated joint of this leg with a range of values, within its limits, likewise:
/// "strut_1_joint=10:32".
std::string example_of_held_range(const Manipulator& manipulator, std::size_t leg);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_HELD_JOINT_EXAMPLE_H
