// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_HELD_SLICE_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_HELD_SLICE_H

#include "aspects/cusps/cosine_sum.h"
#include "interval/interval.h"
#include "legs/limit_verdict.h"
#include "legs/spatial_leg.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// The signs of B_jj of both legs whose joints move.
using SlicePosture = std::array<int, 2>;

/// A box of a slice, or a point of it, as legs need it.
class SlicePlace {
 public:
  SlicePlace(const Box& box, SliceSums sums) noexcept : over_(ranges_of(box), sums), middle_(box) {}

  /// Of one point [half turns].
  explicit SlicePlace(const std::array<double, 2>& at) noexcept : SlicePlace(at, SliceTurns(at)) {}

  const SliceTurns& over() const noexcept { return over_; }

  /// The point in the middle, and how far others are from it.
  const SliceTurns& center() const noexcept;
  SlicePlace at_center() const noexcept { return {middle_.at, center()}; }
  const SliceCenter& middle() const noexcept { return middle_; }

 private:
  SlicePlace(const std::array<double, 2>& at, const SliceTurns& turns) noexcept;

  SliceTurns over_;
  SliceCenter middle_;
  mutable std::optional<SliceTurns> center_;  // computed where it is asked for
};

/// |B_jj|.
inline Interval root_of(const Interval& squared_b_entry) noexcept {
  return square_root(not_negative_part(squared_b_entry));
}

/// A robot with three legs of any kind, the actuated joint of one of them held: the equations of both others
/// over its slice. All of it needs a live `RoundingUpward`.
class HeldSlice {
 public:
  virtual ~HeldSlice() = default;

  /// Index of the leg that equation i, 0 or 1, belongs to.
  std::size_t leg(std::size_t i) const noexcept { return fixed_->legs[i]; }

  /// Those that the kinds of both legs allow.
  const std::vector<SlicePosture>& postures() const noexcept { return fixed_->postures; }

  SlicePlace place(const Box& box) const noexcept { return {box, sums_}; }

  /// A leg over a box of the slice, in one posture.
  struct LegOver {
    Verdict reaches = Verdict::unknown;
    CosineSum equation;  ///< g_i at fixed joint values, but for a constant
    CosineSum slope,
        held_slope;        ///< its derivatives by the joint value and, of a range, by the value that is held
    Interval entry = 1.0;  ///< B_jj where the joint moves c; 1 where it does not
  };

  /// Nothing where the box is too large to decide.
  virtual std::optional<LegOver> leg_over(std::size_t i, int sign, const SlicePlace& at) const noexcept = 0;

  /// A leg at a joint value, or over a range of them.
  struct LegAt {
    CosineSum equation;      ///< g_i, all of it
    CosineSum slope;         ///< its derivative by the joint value, -B_jj
    CosineSum held_slope{};  ///< that by the value that is held, of a range
  };

  /// Not of an actuated elbow.
  virtual LegAt leg_at(std::size_t i, const Interval& q) const noexcept = 0;

  /// Over a box, in one posture, or where the leg is stretched or folded, with sign 0: a range of values, of
  /// angles to whole turns. Nothing where the box is too large to decide. Not of an actuated elbow.
  std::optional<Interval> joint_value(std::size_t i, int sign, const SlicePlace& at) const noexcept;

  /// B_jj over a box where the leg is neither stretched nor folded, of a strut too.
  Interval joint_entry(std::size_t i, const LegOver& leg, const SlicePlace& at) const noexcept;

  /// Whether the joint values are within limits.
  Verdict within_limits(const SlicePosture& posture, const SlicePlace& at) const noexcept;

  /// The sign of B_jj of the leg whose joint is held; 0 where the box is too large to decide.
  int held_sign(const SlicePlace& at) const noexcept;

  /// The working mode of poses of a posture; nothing where a sign is not known.
  std::optional<WorkingMode> mode_of(const SlicePosture& posture, const SlicePlace& at) const noexcept;

  /// Of a point [half turns], rounded.
  virtual Pose pose(const std::array<double, 2>& at) const = 0;

 protected:
  HeldSlice(const Manipulator& manipulator, std::size_t held, SliceSums sums);

  /// c, and the length of the rod.
  struct RodOver {
    Spatial<Interval> from;  ///< [m]
    Interval length;         ///< in space [m]
  };
  virtual std::optional<RodOver> rod_over(std::size_t i, int sign, const SlicePlace& at) const noexcept = 0;

  const Leg& moving_leg(std::size_t i) const noexcept { return fixed_->moving_legs[i]; }

  virtual Verdict leg_within_limits(std::size_t i, int sign, const SlicePlace& at) const noexcept = 0;

  /// B_jj of the leg whose joint is held, but for a positive factor.
  virtual Interval held_entry(const SlicePlace& at) const noexcept = 0;

 private:
  /// What slices of other values share.
  struct Fixed {
    std::size_t held = 0;         // index of the leg whose joint is held
    std::vector<int> held_signs;  // of B_jj that there are
    std::array<std::size_t, 2> legs{};
    std::vector<Leg> moving_legs;
    std::vector<SlicePosture> postures;

    Fixed(const Manipulator& manipulator, std::size_t of_leg);
  };

  SliceSums sums_;
  std::shared_ptr<const Fixed> fixed_;
};

/// Of a slice that holds a joint, see `find_held_joint_problem`.
std::unique_ptr<const HeldSlice> make_held_slice(const Manipulator& manipulator, const HeldJoint& joint);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_HELD_SLICE_H
