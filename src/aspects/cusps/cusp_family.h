// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_FAMILY_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_FAMILY_H

#include "aspects/cusps/cusp_functions.h"
#include "aspects/cusps/planar_held_slice.h"
#include "interval/interval.h"
#include "legs/limit_verdict.h"
#include "parallel_aspects/aspects/box.h"

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
class CuspFamily {
 public:
  CuspFamily(const PlanarHeldSlice& slice, const SlicePosture& posture) : slice_(slice), posture_(posture) {}

  const SlicePosture& posture() const noexcept { return posture_; }

  /// False where it is proved that the box holds no cusp within limits of the joints that move.
  bool may_hold_cusp(const Box& box) noexcept;

  Verdict within_limits(const Box& box) noexcept;

  /// The sign of B_jj of the leg whose joint is held; 0 where the box is too large to tell.
  int held_sign(const Box& box) noexcept;

  /// Nothing where a joint value may not be smooth, or the box is too large to tell.
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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_FAMILY_H
