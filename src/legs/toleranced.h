// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_LEGS_TOLERANCED_H
#define PARALLEL_ASPECTS_LEGS_TOLERANCED_H

#include "interval/interval.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>

// Numbers of a leg, enclosed for every robot that is built within `Leg::tolerance`. A proof that takes them
// from here holds for each of these robots. All of it needs a live `RoundingUpward`.

namespace parallel_aspects {

/// A length of the leg [m].
Interval toleranced_length(double length, const Leg& leg) noexcept;

/// `Leg::base_point` in the task frame [m].
std::array<Interval, 3> toleranced_base(const Leg& leg) noexcept;

/// `Leg::anchor` in the platform frame [m].
std::array<Interval, 3> toleranced_anchor(const Leg& leg) noexcept;

/// At least `Leg::longest_reach`, from the base point of each of these robots [m]; may be infinite.
double toleranced_reach(const Leg& leg) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_LEGS_TOLERANCED_H
