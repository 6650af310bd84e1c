// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_FINITE_LENGTHS_H
#define PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_FINITE_LENGTHS_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <algorithm>

namespace parallel_aspects {

// Interval arithmetic needs finite operands: with lengths below `longest` [m], which each proof chooses for
// itself, no product comes near the largest double.

inline bool is_usable(const Eigen::Vector3d& point, double longest) noexcept {
  return point.allFinite() && point.cwiseAbs().maxCoeff() < longest;
}

/// The orientation need not be normalised, but nearly so.
inline bool is_usable(const Pose& pose, double longest) noexcept {
  const double squared_norm = pose.orientation.squaredNorm();
  return is_usable(pose.position, longest) && squared_norm > 0.25 && squared_norm < 4.0;
}

inline bool is_usable(const Manipulator& manipulator, double longest) noexcept {
  return manipulator.size() < longest &&
         std::all_of(manipulator.legs().begin(), manipulator.legs().end(), [longest](const Leg& leg) {
           return is_usable(leg.anchor, longest) && is_usable(leg.base_point(), longest);
         });
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_FINITE_LENGTHS_H
