// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_ANCHOR_DISTANCE_H
#define PARALLEL_ASPECTS_MODEL_ANCHOR_DISTANCE_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <cmath>

namespace parallel_aspects {

/// How far two poses are apart: root mean square displacement of the anchors [m], in floating point.
inline double anchor_distance(const Manipulator& manipulator, const Pose& a, const Pose& b) noexcept {
  double sum = 0.0;
  for (const Leg& leg : manipulator.legs())
    sum += (a.transform(leg.anchor) - b.transform(leg.anchor)).squaredNorm();
  return std::sqrt(sum / static_cast<double>(manipulator.leg_count()));
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_ANCHOR_DISTANCE_H
