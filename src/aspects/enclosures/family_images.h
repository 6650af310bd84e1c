// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ENCLOSURES_FAMILY_IMAGES_H
#define PARALLEL_ASPECTS_ASPECTS_ENCLOSURES_FAMILY_IMAGES_H

#include "aspects/cusps/cusp_functions.h"
#include "aspects/cusps/held_slice.h"
#include "aspects/cusps/planar_held_slice.h"
#include "aspects/enclosures/singular_images.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// The singular poses of one working mode of a robot of SE2 with three legs of any kind but actuated elbows,
/// over all values of its joints: D = 0, and B_jj = 0 of each leg. Strips are of the actuated values, in
/// order.
///
/// Boxes are of families of slices: of the slices that hold the joint of one leg, by the direction of its
/// rod, phi, and the value that is held. Where the other two legs are neither stretched nor folded, all
/// values q are smooth functions of these coordinates x, with derivatives J. A singularity is where a
/// function f vanishes, D or B_hh of the leg that is held. With m the middle of the box, and whatever n and
/// l,
///
///     n.q(x) = n.q(m) - l f(m) + (n J - l grad f)(x - m),  J and grad f somewhere in the box,
///
/// for x with f(x) = 0. About D = 0 the first two columns of J are nearly parallel; n is across them and the
/// third, and l is 0. About B_hh = 0 n and l are such that n J = l grad f in the middle. So what is left is
/// of second order in the size of the box.
class FamilyImages : public SingularImages {
 public:
  /// Needs a live `RoundingUpward`.
  FamilyImages(const Manipulator& manipulator, const WorkingMode& mode, const ValueSpace& space);

 private:
  /// One kind of singularity: D = 0, or B_hh = 0 of the leg that is held.
  struct Singularity {
    PlanarHeldSlice slices;
    std::size_t held = 0;
    SlicePosture posture{};
    int held_sign = 0;       ///< 0 where it is B_hh = 0
    double half_turn = 0.0;  ///< see `SingularImages`

    bool is_serial() const noexcept { return held_sign == 0; }
  };

  void add(const Manipulator& manipulator, const WorkingMode& mode, std::size_t held, bool is_serial);
  std::optional<ImageStrip> strip_of(const Box& box, Surface surface) const override;
  double half_turn(Surface surface) const override { return singularities_[surface].half_turn; }
  bool is_excluded(const Singularity& of, const PlanarHeldSlice& slices, const std::optional<CuspLegs>& legs,
                   const SlicePlace& place) const;
  bool is_left_to_others(const Singularity& of, const PlanarHeldSlice& slices, const SlicePlace& place) const;

  std::array<double, 3> moving_sizes_{};  // of |B_jj|; 0 of struts
  std::vector<Singularity> singularities_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ENCLOSURES_FAMILY_IMAGES_H
