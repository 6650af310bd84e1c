// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_LINK_PAIRS_H
#define PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_LINK_PAIRS_H

#include "parallel_aspects/model/manipulator.h"

namespace parallel_aspects {

/// Of the size of the robot: points that are closer are one joint.
inline constexpr double joint_tolerance = 1e-9;

/// Whether these links are tested for collision: they are not of one leg, not joined to each other, and not
/// ignored. The robot must have the constraint of self-collision.
bool can_collide(const Manipulator& manipulator, const LinkName& one, const LinkName& other) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_LINK_PAIRS_H
