// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/charts.h"

#include "aspects/boxes/chart_legs.h"
#include "legs/toleranced.h"
#include "model/overloaded.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

// An actuated joint that is closer to its platform's line than this does not bound it.
constexpr double least_slope = 1e-6;

std::optional<PrismaticActuation> rail_of(const Leg& leg) {
  using Rail = std::optional<PrismaticActuation>;
  return std::visit(
      Overloaded{[](const RevoluteActuation&) { return Rail(); },
                 [](const PrismaticActuation& rail) { return Rail(rail); },
                 [](const StrutActuation&) { return Rail(); }, [](const ElbowActuation&) { return Rail(); }},
      leg.actuation);
}

}  // namespace

T1Chart::T1Chart(const Manipulator& manipulator)
    : PlanarLegs(manipulator),
      rail_(rail_of(manipulator.leg(0))),
      rod_length_(toleranced_length(manipulator.leg(0).rod_length, manipulator.leg(0))) {
  const Spatial<Interval> anchor = toleranced_anchor(manipulator.leg(0));
  offset_ = {anchor[0] - leg(0).base().x, anchor[1] - leg(0).base().y};
}

std::optional<Box> T1Chart::reachable_positions() const {
  const RoundingUpward rounding;
  ReachableBox box(1);
  box.restrict(0, -offset_.x, leg(0).reach());
  if (rail_) {
    // No farther from the line of the actuated joint than its rod is long.
    const Eigen::Vector3d& direction = rail_->direction;
    const Interval along(direction.x()), across(std::abs(direction.y()));
    const double side = direction.y() < 0.0 ? -1.0 : 1.0;
    if (across.lower() > least_slope)
      box.restrict(0, offset_.y * along * Interval(side) * reciprocal(across) - offset_.x,
                   (rod_length_ * reciprocal(across)).upper());
  }
  return box.box();
}

T2Chart::T2Chart(const Manipulator& manipulator) : PlanarLegs(manipulator) {
  for (std::size_t j = 0; j < leg_count; ++j) {
    const Spatial<Interval> anchor = toleranced_anchor(manipulator.leg(j));
    offsets_[j] = {anchor[0] - leg(j).base().x, anchor[1] - leg(j).base().y};
  }
}

std::optional<Box> T2Chart::reachable_positions() const {
  const RoundingUpward rounding;
  ReachableBox box(2);
  for (std::size_t j = 0; j < leg_count; ++j) {
    box.restrict(0, -offsets_[j].x, leg(j).reach());
    box.restrict(1, -offsets_[j].y, leg(j).reach());
  }
  return box.box();
}

SE2Chart::SE2Chart(const Manipulator& manipulator) : PlanarLegs(manipulator) {
  for (std::size_t j = 0; j < leg_count; ++j) {
    const Spatial<Interval> anchor = toleranced_anchor(manipulator.leg(j));
    anchors_[j] = {anchor[0], anchor[1]};
  }
}

std::optional<Box> SE2Chart::reachable_positions() const {
  const RoundingUpward rounding;
  ReachableBox box(2);
  for (std::size_t j = 0; j < leg_count; ++j) {
    const double anchor = square_root(square(anchors_[j].x) + square(anchors_[j].y)).upper();
    box.restrict(0, leg(j).base().x, leg(j).reach() + anchor);
    box.restrict(1, leg(j).base().y, leg(j).reach() + anchor);
  }
  return box.box();
}

T3Chart::T3Chart(const Manipulator& manipulator) : SpatialLegs(manipulator) {
  for (std::size_t j = 0; j < leg_count; ++j) {
    const Spatial<Interval> anchor = toleranced_anchor(manipulator.leg(j));
    for (std::size_t i = 0; i < 3; ++i) offsets_[j][i] = anchor[i] - leg(j).base()[i];
  }
}

std::optional<Box> T3Chart::reachable_positions() const {
  const RoundingUpward rounding;
  ReachableBox box(3);
  for (std::size_t j = 0; j < leg_count; ++j)
    for (std::size_t i = 0; i < 3; ++i) box.restrict(i, -offsets_[j][i], leg(j).reach());
  return box.box();
}

SO3Chart::SO3Chart(const Manipulator& manipulator) : SpatialLegs(manipulator) {
  for (std::size_t j = 0; j < leg_count; ++j) anchors_[j] = toleranced_anchor(manipulator.leg(j));
}

}  // namespace parallel_aspects
