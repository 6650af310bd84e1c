// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/held_slice.h"

#include <variant>

namespace parallel_aspects {
namespace {

std::vector<int> signs_of(const Leg& leg) {
  std::vector<int> signs;
  for (const int sign : {1, -1})
    if (leg.has_branch(sign)) signs.push_back(sign);
  return signs;
}

Planar<Interval> sum_of(const Planar<Interval>& a, const Planar<Interval>& b) noexcept {
  return {a.x + b.x, a.y + b.y};
}

}  // namespace

HeldSlice::HeldSlice(const Manipulator& manipulator, const MapSlice& slice)
    : held_leg_(manipulator.leg(slice.joint->leg)),
      held_(held_leg_, slice.joint->value, 0.0),
      held_is_strut_(held_leg_.kind().type == LegType::strut),
      length_(held_.rod(Turn<Interval>{1.0, 0.0}).x),
      held_signs_(signs_of(held_leg_)) {
  assert_rounding_upward();
  const std::size_t held = slice.joint->leg;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    if (j != held) legs_.emplace_back(manipulator.leg(j), manipulator.leg(held), j);
  for (const int first : legs_[0].signs)
    for (const int second : legs_[1].signs) postures_.push_back({first, second});
}

void HeldSlice::hold(const Interval& value) noexcept {
  held_ = HeldLeg(held_leg_, value, 0.0);
  length_ = held_.rod(Turn<Interval>{1.0, 0.0}).x;
}

HeldSlice::MovingLeg::MovingLeg(const Leg& moving, const Leg& held, std::size_t j)
    : index(j),
      leg(moving),
      between_anchors{Interval(moving.anchor.x()) - Interval(held.anchor.x()),
                      Interval(moving.anchor.y()) - Interval(held.anchor.y())},
      signs(signs_of(moving)) {
  std::visit([this](const auto& actuation) { set(actuation); }, moving.actuation);
}

void HeldSlice::MovingLeg::set(const RevoluteActuation& crank) {
  crank_sense = crank.axis.z() > 0.0 ? 1.0 : -1.0;
  moves = true;
}

void HeldSlice::MovingLeg::set(const PrismaticActuation& slide) {
  rail = {slide.direction.x(), slide.direction.y()};
  moves = true;
}

void HeldSlice::MovingLeg::set(const StrutActuation&) {}

void HeldSlice::MovingLeg::set(const ElbowActuation&) {}

// Of the anchor from the base point, c_h + r + v - base.
Planar<Interval> HeldSlice::displacement(const MovingLeg& moving, const SliceTurns& at) const noexcept {
  const Planar<Interval>&m = moving.between_anchors, &base = moving.leg.base();
  const Planar<Interval> v{m.x * at.phi.cosine - m.y * at.phi.sine, m.x * at.phi.sine + m.y * at.phi.cosine};
  const Planar<Interval> anchor = sum_of(held_.rod(at.direction), v);
  return {anchor.x + (held_.center().x - base.x), anchor.y + (held_.center().y - base.y)};
}

std::optional<HeldSlice::LegOver> HeldSlice::leg_over(std::size_t i, int sign,
                                                      const SliceTurns& at) const noexcept {
  const MovingLeg& moving = legs_[i];
  const Planar<Interval> d = displacement(moving, at);
  const Interval squared_entry = moving.leg.form(d).squared_entry;
  LegOver result{is_positive(squared_entry), {}, {0.0, 0.0}, 1.0};
  if (squared_entry.upper() < 0.0) return result;
  const Interval root = square_root(not_negative_part(squared_entry));
  const auto points = moving.leg.link_points(d, root, sign);
  if (!points) return std::nullopt;
  const auto& c = points->joint;
  result.o = {held_.center().x - c[0], held_.center().y - c[1]};
  if (!moving.moves) return result;
  const Interval sense(moving.crank_sense);
  const Interval arm_x = c[0] - points->base[0], arm_y = c[1] - points->base[1];
  result.slope = {sense * arm_y - moving.rail.x, -(sense * arm_x) - moving.rail.y};
  result.entry = sign > 0 ? root : -root;
  return result;
}

Verdict HeldSlice::within_limits(const SlicePosture& posture, const SliceTurns& at) const noexcept {
  Verdict result = Verdict::holds;
  for (std::size_t i = 0; i < 2; ++i) {
    const Planar<Interval> d = displacement(legs_[i], at);
    const Interval root = square_root(not_negative_part(legs_[i].leg.form(d).squared_entry));
    result = both(result, verdict(legs_[i].leg.limits(d, root, posture[i])));
  }
  return result;
}

int HeldSlice::held_sign(const SliceTurns& at) const noexcept {
  if (held_signs_.size() == 1) return held_signs_.front();
  const Planar<Interval> u = held_.rod(at.direction);
  for (const int sign : held_signs_)
    if (verdict(held_.branch(u, sign)) == Verdict::holds) return sign;
  return 0;
}

}  // namespace parallel_aspects
