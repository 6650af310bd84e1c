// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_VALUE_STRIPS_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_VALUE_STRIPS_H

#include "aspects/cusps/held_slice.h"
#include "aspects/solutions/joint_ranges.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <functional>
#include <optional>

namespace parallel_aspects {

/// Values of both joints that move: a rectangle and, if `normal` is not zero, what of it has normal . q in
/// `along`.
struct ValueStrip {
  std::array<std::optional<Interval>, 2> values;  ///< angles to whole turns; nothing stands for all values
  std::array<double, 2> normal{};
  Interval along;
  /// Signs of B_jj of the poses, and of the leg whose joint is held; 0 where there may be both.
  SlicePosture posture{};
  int held = 0;
};

/// Answers whether to go on: not once all values are in strips.
using TakeStrip = std::function<bool(const ValueStrip&)>;

/// How small strips are to be: half the width of strips, and rectangles without a normal [m or rad].
using StripSizes = std::array<double, 2>;

/// Encloses the joint values in these ranges of all poses of the slice with D = 0, D the determinant of the
/// Jacobian of both equations, in all postures. Over a box q = q(x) moves by J_q (x - middle), with rows J_q
/// = g_x / B_jj; where D = 0 the matrix has rank 1 at most, so that across the image, along a left null
/// vector of J_q in the middle, q moves by the square of the box's size alone.
///
/// Ends early when cancelled. Needs a live `RoundingUpward`.
void enclose_parallel_singularities(const HeldSlice& slice, const JointRanges& ranges,
                                    const StripSizes& sizes, const MapControl& control,
                                    const TakeStrip& take);

/// Likewise of all poses where a leg is stretched or folded, B_jj = 0, that whose joint is held among them.
void enclose_serial_singularities(const HeldSlice& slice, const JointRanges& ranges, const StripSizes& sizes,
                                  const MapControl& control, const TakeStrip& take);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_VALUE_STRIPS_H
