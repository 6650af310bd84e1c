// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_CUSP_ASPECT_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_CUSP_ASPECT_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/model/pose.h"

#include <vector>

namespace parallel_aspects {

/// Where paths around a cusp run.
struct BesideCusp {
  int aspect = 0;  ///< see `Cusp`
  /// Poses of it, each with another one of the same actuated values that a small loop around the cusp leads
  /// to; they lie ever farther from the cusp.
  std::vector<Pose> poses;
};

/// In the map of the slice in SE2 that has the cusp.
///
/// det A vanishes along a curve through an ordinary cusp, and there the kernel is its tangent. So of the
/// actuated values of a pose next to the cusp, across the curve on one of its sides, there are two more
/// solutions on the other side, one towards either end of the curve, and a loop exchanges these two.
BesideCusp look_beside(const AspectMap& map, const Cusp& cusp);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_CUSP_ASPECT_H
