// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/held_slice.h"

#include "aspects/cusps/planar_held_slice.h"
#include "aspects/cusps/spherical_held_slice.h"

namespace parallel_aspects {
namespace {

std::vector<int> signs_of(const Leg& leg) {
  std::vector<int> signs;
  for (const int sign : {1, -1})
    if (leg.has_branch(sign)) signs.push_back(sign);
  return signs;
}

}  // namespace

SlicePlace::SlicePlace(const std::array<double, 2>& at, const SliceTurns& turns) noexcept
    : over_(turns), middle_(Box{2, {at[0], at[1], 0.0}, {at[0], at[1], 0.0}}), center_(turns) {}

const SliceTurns& SlicePlace::center() const noexcept {
  if (!center_) center_.emplace(middle_.at);
  return *center_;
}

HeldSlice::HeldSlice(const Manipulator& manipulator, std::size_t held, SliceSums sums)
    : sums_(sums), held_signs_(signs_of(manipulator.leg(held))) {
  assert_rounding_upward();
  for (std::size_t i = 0, j = 0; j < manipulator.leg_count(); ++j)
    if (j != held) legs_[i++] = j;
  for (const int first : signs_of(manipulator.leg(legs_[0])))
    for (const int second : signs_of(manipulator.leg(legs_[1]))) postures_.push_back({first, second});
}

Verdict HeldSlice::within_limits(const SlicePosture& posture, const SlicePlace& at) const noexcept {
  return both(leg_within_limits(0, posture[0], at), leg_within_limits(1, posture[1], at));
}

int HeldSlice::held_sign(const SlicePlace& at) const noexcept {
  if (held_signs_.size() == 1) return held_signs_.front();
  const Interval entry = held_entry(at);
  return entry.positive() ? 1 : entry.negative() ? -1 : 0;
}

std::unique_ptr<const HeldSlice> make_held_slice(const Manipulator& manipulator, const HeldJoint& joint) {
  if (manipulator.task_space() == TaskSpace::SO3)
    return std::make_unique<const SphericalHeldSlice>(manipulator, joint);
  return std::make_unique<const PlanarHeldSlice>(manipulator, joint);
}

}  // namespace parallel_aspects
