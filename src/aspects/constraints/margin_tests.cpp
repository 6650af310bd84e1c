// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/constraints/margin_tests.h"

#include "model/overloaded.h"
#include "model/task_space_traits.h"

#include <variant>

namespace parallel_aspects {
namespace {

using Anchors = std::vector<std::array<Interval, 3>>;

Anchors enclosed_anchors(const Manipulator& manipulator) {
  Anchors result;
  for (const Leg& leg : manipulator.legs())
    result.push_back({Interval(leg.anchor.x()), Interval(leg.anchor.y()), Interval(leg.anchor.z())});
  return result;
}

Interval mean(const Anchors& anchors, std::size_t i) {
  Interval sum(0.0);
  for (const auto& anchor : anchors) sum += anchor[i];
  return sum * reciprocal(Interval(static_cast<double>(anchors.size())));
}

/// The largest |B_jj| of a leg, see `Leg::largest_entry`; nothing for a strut.
std::optional<Interval> largest_entry(const Leg& leg) {
  using Entry = std::optional<Interval>;
  const Interval rod(leg.rod_length);
  return std::visit(
      Overloaded{[&rod](const RevoluteActuation& crank) { return Entry(Interval(crank.radius) * rod); },
                 [&rod](const PrismaticActuation&) { return Entry(rod); },
                 [](const StrutActuation&) { return Entry(); },
                 [](const ElbowActuation& elbow) {
                   return Entry(Interval(elbow.inner_length) * Interval(elbow.outer_length));
                 }},
      leg.actuation);
}

}  // namespace

template <std::size_t D>
MarginTests<D>::MarginTests(const Manipulator& manipulator)
    : leg_count_(manipulator.leg_count()),
      rotations_(traits(manipulator.task_space()).rotations),
      middle_(),
      over_squared_distance_(1.0),
      unit_(1.0),
      least_squares_(manipulator.leg_count()) {
  assert_rounding_upward();
  const Margins& margins = manipulator.constraints().margins;
  any_ = margins.any();
  if (margins.parallel > 0.0) squared_index_ = square(Interval(margins.parallel));
  if (margins.det_a > 0.0) squared_determinant_ = square(Interval(margins.det_a));
  if (margins.serial > 0.0)
    for (std::size_t j = 0; j < leg_count_; ++j)
      if (const auto largest = largest_entry(manipulator.leg(j)))
        least_squares_[j] = square(Interval(margins.serial) * *largest);
  if (rotations_ > 0 && rotations_ < leg_count_) set_middle(enclosed_anchors(manipulator));
  if (rotations_ > 0 && leg_count_ == 1) {
    const Eigen::Vector3d& arm = manipulator.leg(0).anchor;
    unit_ = square(Interval(arm.x())) + square(Interval(arm.y()));
  }
}

template <std::size_t D>
void MarginTests<D>::set_middle(const std::vector<std::array<Interval, 3>>& anchors) {
  Interval sum(0.0);
  for (std::size_t i = 0; i < D; ++i) {
    middle_[i] = mean(anchors, i);
    for (const auto& anchor : anchors) sum += square(anchor[i] - middle_[i]);
  }
  const Interval squared_distance = sum * reciprocal(Interval(static_cast<double>(anchors.size())));
  // Anchors in one point leave det A zero everywhere, whatever it is compared with.
  if (!squared_distance.positive()) return;
  over_squared_distance_ = reciprocal(squared_distance);
  for (std::size_t i = 0; i < rotations_; ++i) unit_ = unit_ * squared_distance;
}

template class MarginTests<2>;
template class MarginTests<3>;

}  // namespace parallel_aspects
