// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_HELD_ORIENTATIONS_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_HELD_ORIENTATIONS_H

#include "aspects/cusps/cosine_sum.h"
#include "interval/interval.h"
#include "interval/rotation_rows.h"
#include "legs/spatial_leg.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <array>

namespace parallel_aspects {

/// The orientations of SO3 where the anchor b of a leg has its distance from a proximal point c that is held.
///
/// Then the angle gamma between c and R b is known, and with orthonormal frames E, whose third axis is along
/// c, and F, whose third axis is along b,
///
///     R = E Rz(a) Ry(gamma) Rz(phi) F^T,
///
/// a torus in a and phi where sin(gamma) > 0. All of it needs a live `RoundingUpward`.
class HeldOrientations {
 public:
  HeldOrientations(const Leg& leg, double q);

  /// m.(R b), of constants.
  CosineSum along(const Spatial<Interval>& m, const Spatial<Interval>& b) const noexcept;

  /// B_jj of the leg where its joint moves c, else zero.
  CosineSum held_entry() const noexcept;

  /// Of a point [half turns], rounded.
  Pose pose(const std::array<double, 2>& at) const;

 private:
  RotationRows<Interval> base_, platform_;  // axes of E and of F
  Interval cosine_, sine_;                  // of gamma
  Spatial<Interval> anchor_, slope_;        // b and c'
  Interval along_slope_;                    // c.c'
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_HELD_ORIENTATIONS_H
