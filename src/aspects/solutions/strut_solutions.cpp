// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/strut_solutions.h"

#include "aspects/solutions/solution_equations.h"
#include "interval/scalar_range.h"
#include "model/angles.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {
namespace {

/// Half the square of m + t h for t from -1 to 1, as a value and the slope m h.
struct HalfSquareBetween {
  Interval value, slope;

  HalfSquareBetween(double from, double to) noexcept {
    const Interval middle = Interval(0.5) * (Interval(from) + Interval(to));
    const Interval half = Interval(0.5) * (Interval(to) - Interval(from));
    value = Interval(0.5) * (square(middle) + Interval(0.0, square(half).upper()));
    slope = middle * half;
  }
};

/// The rod that is held, as  middle + t slope  and what is left of that, for t from -1 to 1.
struct RodBetween {
  StrutSlice middle;
  Interval all, slope, rest;

  RodBetween(const StrutSlice& family, double from, double to) noexcept
      : middle(slices_of(family, Interval(0.5) * (Interval(from) + Interval(to)))),
        all(slices_of(family, {std::min(from, to), std::max(from, to)}).rod()) {
    const Interval half = Interval(0.5) * (Interval(to) - Interval(from));
    const Interval derivative = Interval(std::min(from, to), std::max(from, to)) * half * reciprocal(all);
    slope = Interval(middle_of(derivative));
    rest = (derivative - slope) * Interval(-1.0, 1.0);
  }

  static StrutSlice slices_of(const StrutSlice& family, const Interval& lengths) noexcept {
    return family.with_half_square(Interval(0.5) * square(lengths));
  }
};

PairOverBox pair_between(const StrutSlice& slice, const Box& box, const Lengths& from, const Lengths& to) {
  const HalfSquareBetween first(from[0], to[0]), second(from[1], to[1]);
  PairOverBox pair = pair_over(slice, box, {first.value, second.value});
  pair.drift = {first.slope, second.slope};
  return pair;
}

/// The same in a family: g_i is of degree two in the rod.
PairOverBox pair_in_family(const StrutSlice& family, const Box& box, const Lengths& from, const Lengths& to) {
  const RodBetween rod(family, from[2], to[2]);
  PairOverBox pair = pair_between(rod.middle, box, from, to);
  pair.jacobian = pair_over(family.with_rod(rod.all), box, {}).jacobian;
  const SliceTurns center(SliceCenter(box).at);
  const Interval bend = Interval(0.5) * square(rod.all - rod.middle.rod());
  for (std::size_t i = 0; i < 2; ++i) {
    const Interval slope = rod.middle.slope<0>(i, center).value();
    pair.center[i] += slope * rod.rest + bend;
    pair.drift[i] = pair.drift[i] - slope * rod.slope;
  }
  return pair;
}

}  // namespace

std::array<Interval, 2> values_at(const Lengths& lengths) noexcept {
  return {Interval(0.5) * square(Interval(lengths[0])), Interval(0.5) * square(Interval(lengths[1]))};
}

PairOverBox pair_over(const StrutSlice& slice, const Box& box, const std::array<Interval, 2>& values) {
  const bool is_point = box.width(0) == 0.0 && box.width(1) == 0.0;
  const SliceTurns center(SliceCenter(box).at), over = is_point ? center : SliceTurns(ranges_of(box));
  PairOverBox pair;
  for (std::size_t i = 0; i < 2; ++i) {
    const Jet<1> slopes = slice.half_square<1>(i, over);
    pair.center[i] = (is_point ? slopes.value() : slice.half_square<0>(i, center).value()) - values[i];
    pair.jacobian[i] = {slopes.at(1, 0), slopes.at(0, 1)};
  }
  return pair;
}

std::optional<std::vector<Box>> find_all_solutions(const StrutSlice& slice, const Lengths& lengths) {
  assert_rounding_upward();
  const StrutSlice at = slice.at(lengths);
  const std::array<Interval, 2> values = values_at(lengths);
  return find_all_zeros([&](const Box& box) { return pair_over(at, box, values); });
}

PairOverBox StrutEquations::at(const Box& box, const ActuatedValues& lengths) const {
  return pair_over(slice_.at(lengths), box, values_at(lengths));
}

PairOverBox StrutEquations::about(const Box& box, const ActuatedValues& lengths, double slack) const {
  std::array<Interval, 3> values;
  for (std::size_t i = 0; i < 3; ++i)
    values[i] = Interval(0.5) * square(Interval(lengths[i]) + Interval(-slack, slack));
  const StrutSlice slice = slice_.dimension() == 2 ? slice_ : slice_.with_half_square(values[2]);
  return pair_over(slice, box, {values[0], values[1]});
}

std::optional<PairOverBox> StrutEquations::between(const Box& box, const ActuatedValues& from,
                                                   const ActuatedValues& to) const {
  return slice_.dimension() == 2 ? pair_between(slice_, box, from, to)
                                 : pair_in_family(slice_, box, from, to);
}

namespace {

constexpr double pose_box_half_width = 0x1p-32;  // [half turns]

}  // namespace

Pose StrutPoses::pose(const Box& box, const Lengths& lengths) const {
  return circle(lengths[2] * lengths[2]).pose(pi * box.center(0), pi * box.center(1));
}

// Where the anchor of the first strut, or of that which is held, moves while its length stays the same.
AnchorCircle StrutPoses::circle(double squared_length) const {
  if (!is_family_) return circle_of_anchor(manipulator_, {legs_[2], held_, false});
  const Leg& leg = manipulator_.leg(legs_[2]);
  const Eigen::Vector3d center = leg.base_point();
  const double height = leg.anchor.z() - center.z();
  return {center.head<2>(), std::sqrt(std::max(0.0, squared_length - height * height)), leg.anchor.head<2>()};
}

Box box_about(const AnchorCircle& circle, const Pose& pose) {
  const Eigen::Vector2d rod = circle.rod(pose);
  const double phi = 2.0 * std::atan2(pose.orientation.z(), pose.orientation.w());
  const std::array<double, 2> at{std::atan2(rod.y(), rod.x()) / pi, std::remainder(phi, full_turn) / pi};
  Box box{2, {}, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    box.lower[i] = at[i] - pose_box_half_width;
    box.upper[i] = at[i] + pose_box_half_width;
  }
  return box;
}

Box StrutPoses::box_about(const Pose& pose) const { return parallel_aspects::box_about(circle(0.0), pose); }

Lengths StrutPoses::lengths(const JointVector& actuated) const {
  Lengths result{};
  const bool is_known = static_cast<std::size_t>(actuated.size()) == manipulator_.leg_count();
  for (std::size_t i = 0; i < (is_family_ ? 3U : 2U); ++i) {
    const Leg& leg = manipulator_.leg(legs_[i]);
    const double q = is_known ? actuated[static_cast<Eigen::Index>(legs_[i])] : std::nan("");
    result[i] = std::isfinite(q) && leg.can_have(q) ? std::sqrt(leg.squared_distance(q)) : -1.0;
  }
  return result;
}

JointVector StrutPoses::actuated(const Pose& pose) const {
  JointVector q = inverse(manipulator_, pose, working_modes(manipulator_).front()).q;
  if (!is_family_ && q.size() > 0) q[static_cast<Eigen::Index>(legs_[2])] = held_;
  return q;
}

}  // namespace parallel_aspects
