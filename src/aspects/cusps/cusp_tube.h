// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_TUBE_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_TUBE_H

#include "aspects/cusps/cusp_functions.h"
#include "aspects/cusps/planar_held_slice.h"
#include "aspects/zeros/krawczyk.h"
#include "interval/interval.h"
#include "legs/limit_verdict.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// D and both {D, g_i} over a box of a family, with all gradients.
struct FamilyFunctions {
  std::array<Interval, 3> values;
  std::array<CuspGradient<3>, 3> gradients;
  std::array<bool, 2> has_gradient{};  ///< of each g_i, by both coordinates of the slice: it does not vanish
  std::size_t better_equation = 0;
};

/// The slices that hold a joint at the values of a range, in one posture.
///
/// The third coordinate of a box is the value that is held [m or rad] divided by pi, so that times pi every
/// coordinate is what derivatives are taken by. All of it needs a live `RoundingUpward`.
class SliceFamily {
 public:
  SliceFamily(const PlanarHeldSlice& slice, const SlicePosture& posture) : slice_(slice), posture_(posture) {}

  const SlicePosture& posture() const noexcept { return posture_; }

  /// False where it is proved that the box holds no cusp within limits of the joints that move.
  bool may_hold_cusp(const Box& box) noexcept;

  Verdict within_limits(const Box& box) noexcept;

  /// The sign of B_jj of the leg whose joint is held; 0 where the box is too large to decide.
  int held_sign(const Box& box) noexcept;

  /// Nothing where a joint value may not be smooth, or the box is too large to decide.
  std::optional<FamilyFunctions> over(const Box& box) noexcept;
  std::optional<FamilyFunctions> at(const MapPoint& point) noexcept;

  /// How often the functions were evaluated: the work that was done, whatever the machine.
  std::size_t evaluations() const noexcept { return evaluations_; }

 private:
  std::optional<FamilyFunctions> functions(const SlicePlace& at) noexcept;

  PlanarHeldSlice slice_;
  SlicePosture posture_;
  std::size_t evaluations_ = 0;
};

/// The values that are held in a box [m or rad].
Interval held_values(const Box& box) noexcept;

/// A set of points x of a `SliceFamily` along one of its coordinates, the parameter: with s = x_p - middle,
/// |s| <= half, each other coordinate is in a range of `cross` plus slope s.
///
/// Where Krawczyk's test holds for every s at once (of `krawczyk_test` the drift), there is exactly one cusp
/// for each value of the parameter, and these form one arc: a regular piece of a curve.
struct CuspTube {
  std::size_t axis = 2;  ///< the parameter
  double middle = 0.0, half = 0.0;
  std::array<std::size_t, 2> others{0, 1};
  std::array<double, 2> slope{};
  Box cross;
  Box enclosed;  ///< a part of `cross` that the arc does not leave
};

/// The smallest box that holds a tube with this cross section.
Box hull_of(const CuspTube& tube, const Box& cross) noexcept;

/// The parameters of a box, moved by whole turns to where the tube is.
Interval along(const CuspTube& tube, const Box& box) noexcept;

/// Whether the box, moved by whole turns of both angles, lies in the tube; whether they may have a point in
/// common.
bool contains(const CuspTube& tube, const Box& box) noexcept;
bool may_meet(const CuspTube& tube, const Box& box) noexcept;

/// Krawczyk's test of a tube; on `one` its arc is enclosed, too.
Zeros test_tube(SliceFamily& family, CuspTube& tube) noexcept;

/// A tube along a coordinate about a point near a curve, with an arc for certain.
std::optional<CuspTube> tube_about(SliceFamily& family, std::size_t axis, const MapPoint& at,
                                   double half) noexcept;

/// A tube along a coordinate that holds this box, not tested.
std::optional<CuspTube> tube_over(SliceFamily& family, const Box& box, const MapPoint& weights) noexcept;

/// Newton's method with one coordinate fixed, in double precision.
std::optional<MapPoint> near_cusp(SliceFamily& family, std::size_t axis, MapPoint at) noexcept;

/// A tiny box that holds exactly one cusp with this value of a coordinate, near a point.
std::optional<Box> cusp_near(SliceFamily& family, std::size_t axis, const MapPoint& at) noexcept;

/// Along the curve through a point, or of level sets beside it: not scaled.
std::optional<MapPoint> tangent_at(SliceFamily& family, const MapPoint& at) noexcept;

/// The coordinate that changes most along a tangent, each times its weight.
std::size_t steepest_axis(const MapPoint& tangent, const MapPoint& weights) noexcept;

/// How the value that is held moves along the arc while the parameter rises: 1 and -1 are proved, 0 is
/// unknown.
int held_direction(SliceFamily& family, const CuspTube& tube) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_TUBE_H
