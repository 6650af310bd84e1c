// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/planar_held_slice.h"

#include "model/angles.h"

#include <variant>

namespace parallel_aspects {
namespace {

Planar<Interval> sum_of(const Planar<Interval>& a, const Planar<Interval>& b) noexcept {
  return {a.x + b.x, a.y + b.y};
}

}  // namespace

PlanarHeldSlice::PlanarHeldSlice(const Manipulator& manipulator, const HeldJoint& joint)
    : HeldSlice(manipulator, joint.leg, SliceSums::no),
      held_leg_(std::make_shared<const Leg>(manipulator.leg(joint.leg))),
      circle_(circle_of_anchor(manipulator, joint)),
      held_(*held_leg_, joint.value, 0.0),
      held_is_strut_(held_leg_->kind().type == LegType::strut),
      length_(held_.rod(Turn<Interval>{1.0, 0.0}).x),
      legs_{MovingLeg(manipulator.leg(leg(0)), *held_leg_), MovingLeg(manipulator.leg(leg(1)), *held_leg_)} {}

void PlanarHeldSlice::hold(const Interval& value) noexcept {
  held_ = HeldLeg(*held_leg_, value, 0.0);
  length_ = held_.rod(Turn<Interval>{1.0, 0.0}).x;
  in_range_ = true;
}

PlanarHeldSlice::MovingLeg::MovingLeg(const Leg& moving, const Leg& held)
    : leg(moving),
      between_anchors{Interval(moving.anchor.x()) - Interval(held.anchor.x()),
                      Interval(moving.anchor.y()) - Interval(held.anchor.y())} {
  std::visit([this](const auto& actuation) { set(actuation); }, moving.actuation);
}

void PlanarHeldSlice::MovingLeg::set(const RevoluteActuation& crank) {
  crank_sense = crank.axis.z() > 0.0 ? 1.0 : -1.0;
  moves = true;
}

void PlanarHeldSlice::MovingLeg::set(const PrismaticActuation& slide) {
  rail = {slide.direction.x(), slide.direction.y()};
  moves = true;
}

void PlanarHeldSlice::MovingLeg::set(const StrutActuation&) {}

void PlanarHeldSlice::MovingLeg::set(const ElbowActuation&) {}

// Of the anchor from the base point, c_h + r + v - base.
Planar<Interval> PlanarHeldSlice::displacement(const MovingLeg& moving, const SliceTurns& at) const noexcept {
  const Planar<Interval>&m = moving.between_anchors, &base = moving.leg.base();
  const Planar<Interval> v{m.x * at.phi.cosine - m.y * at.phi.sine, m.x * at.phi.sine + m.y * at.phi.cosine};
  const Planar<Interval> anchor = sum_of(held_.rod(at.direction), v);
  return {anchor.x + (held_.center().x - base.x), anchor.y + (held_.center().y - base.y)};
}

std::optional<HeldSlice::LegOver> PlanarHeldSlice::leg_over(std::size_t i, int sign,
                                                            const SlicePlace& at) const noexcept {
  const MovingLeg& moving = legs_[i];
  const Planar<Interval> d = displacement(moving, at.over());
  const Interval squared_b_entry = moving.leg.form(d).squared_b_entry;
  LegOver result;
  result.reaches = is_positive(squared_b_entry);
  if (squared_b_entry.upper() < 0.0) return result;
  const Interval root = root_of(squared_b_entry);
  const auto points = moving.leg.link_points(d, root, sign);
  if (!points) return std::nullopt;
  const auto& c = points->joint;
  const Planar<Interval> o{held_.center().x - c[0], held_.center().y - c[1]};
  result.equation = CosineSum::half_square(length_, moving.between_anchors, o, 0.0);
  if (in_range_) result.held_slope = held_slope(moving, o);
  if (!moving.moves) return result;
  const Interval sense(moving.crank_sense);
  const Interval arm_x = c[0] - points->base[0], arm_y = c[1] - points->base[1];
  const Planar<Interval> back{sense * arm_y - moving.rail.x, -(sense * arm_x) - moving.rail.y};
  result.slope = CosineSum::along(back, length_, moving.between_anchors, o);
  result.entry = sign > 0 ? root : -root;
  return result;
}

HeldSlice::LegAt PlanarHeldSlice::leg_at(std::size_t i, const Interval& q) const noexcept {
  const MovingLeg& moving = legs_[i];
  const HeldLeg at(moving_leg(i), q, 0.0);
  const Planar<Interval>&slope = at.center_slope(), &center = at.center();
  const Planar<Interval> o{held_.center().x - center.x, held_.center().y - center.y};
  LegAt result{CosineSum::half_square(length_, moving.between_anchors, o, 0.0),
               CosineSum::along({-slope.x, -slope.y}, length_, moving.between_anchors, o)};
  result.equation.constant += Interval(-0.5) * square(at.rod(Turn<Interval>{1.0, 0.0}).x);
  result.slope.constant += -at.half_square_slope();
  if (in_range_) result.held_slope = held_slope(moving, o);
  return result;
}

CosineSum PlanarHeldSlice::held_slope(const MovingLeg& moving, const Planar<Interval>& o) const noexcept {
  const Planar<Interval>& m = moving.between_anchors;
  if (!held_is_strut_) return CosineSum::along(held_.center_slope(), length_, m, o);
  return held_.length_slope() * CosineSum::half_square_slope(length_, m, o);
}

std::optional<HeldSlice::RodOver> PlanarHeldSlice::rod_over(std::size_t i, int sign,
                                                            const SlicePlace& at) const noexcept {
  const PlanarLeg& leg = legs_[i].leg;
  const Planar<Interval> d = displacement(legs_[i], at.over());
  const Interval entry = sign == 0 ? Interval(0.0) : root_of(leg.form(d).squared_b_entry);
  const auto points = leg.link_points(d, entry, sign);
  if (!points) return std::nullopt;
  return RodOver{{points->joint[0], points->joint[1], moving_leg(i).base_point().z()}, points->length};
}

Pose PlanarHeldSlice::pose(const std::array<double, 2>& at) const {
  return circle_.pose(pi * at[0], pi * at[1]);
}

Verdict PlanarHeldSlice::leg_within_limits(std::size_t i, int sign, const SlicePlace& at) const noexcept {
  const PlanarLeg& leg = legs_[i].leg;
  const Planar<Interval> d = displacement(legs_[i], at.over());
  return verdict(leg.limits(d, root_of(leg.form(d).squared_b_entry), sign));
}

Interval PlanarHeldSlice::held_entry(const SlicePlace& at) const noexcept {
  return held_entry_over(at).value;
}

PlanarHeldSlice::HeldEntry PlanarHeldSlice::held_entry_over(const SlicePlace& at) const noexcept {
  const Planar<Interval> u = held_.rod(at.over().direction), lever = held_.center_slope(),
                         bend = held_.center_bend();
  return {lever.x * u.x + lever.y * u.y, lever.y * u.x - lever.x * u.y, bend.x * u.x + bend.y * u.y};
}

}  // namespace parallel_aspects
