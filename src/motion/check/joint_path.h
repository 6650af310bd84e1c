// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHECK_JOINT_PATH_H
#define PARALLEL_ASPECTS_MOTION_CHECK_JOINT_PATH_H

#include "interval/interval.h"
#include "parallel_aspects/motion/check_trajectory.h"

#include <array>

namespace parallel_aspects {

/// The actuated joints between two waypoints: a polynomial of s in [0, 1] for each, in enclosures of its
/// coefficients. Needs a live `RoundingUpward`.
class JointPath {
 public:
  JointPath(const JointWaypoint& from, const JointWaypoint& to) noexcept;

  /// Encloses the value of a joint at s [rad or m].
  Interval value(std::size_t leg, double s) const noexcept;

  /// Encloses its derivative over a range of s [rad or m].
  Interval slope(std::size_t leg, const Interval& s) const noexcept;

  /// Encloses its second derivative over a range of s [rad or m].
  Interval second(std::size_t leg, const Interval& s) const noexcept;

  /// At least how far a joint is from its chord between two s [rad or m].
  double bend(std::size_t leg, double begin, double end) const noexcept;

 private:
  using Coefficients = std::array<Interval, 6>;  // of 1, s, ..., s^5

  std::array<Coefficients, max_legs> coefficients_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHECK_JOINT_PATH_H
