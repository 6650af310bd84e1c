// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHECK_UNASSEMBLED_H
#define PARALLEL_ASPECTS_MOTION_CHECK_UNASSEMBLED_H

#include "interval/interval.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>

namespace parallel_aspects {

/// Whether it is proved that no pose at all goes with any joint values in `q`: in T1, T2 and T3, where each
/// leg keeps the operational point on a sphere, and these have no common point. False in other task spaces.
/// Needs a live `RoundingUpward`.
bool proved_unassembled(const Manipulator& manipulator, const std::array<Interval, max_legs>& q) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHECK_UNASSEMBLED_H
