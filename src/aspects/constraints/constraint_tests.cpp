// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/constraints/constraint_tests.h"

#include "aspects/constraints/separation.h"
#include "interval/half_turns.h"

#include <algorithm>

namespace parallel_aspects {
namespace {

template <std::size_t D>
Point<Interval, D> enclosed(const Eigen::Vector3d& vector, double error = 0.0) {
  Point<Interval, D> result;
  for (std::size_t i = 0; i < D; ++i) {
    const double entry = vector[static_cast<Eigen::Index>(i)];
    result[i] = {entry - error, entry + error};
  }
  return result;
}

double width(const LinkThickness& thickness, LinkKind kind) {
  return kind == LinkKind::crank ? thickness.crank : thickness.rod;
}

}  // namespace

template <std::size_t D>
ConstraintTests<D>::ConstraintTests(const Manipulator& manipulator)
    : margins_(manipulator),
      passive_limits_(manipulator.leg_count()),
      passive_cones_(manipulator.leg_count()),
      cones_(manipulator.leg_count()),
      pairs_(manipulator.leg_count(), std::vector<std::vector<LinkPair>>(manipulator.leg_count())) {
  assert_rounding_upward();
  const Constraints& constraints = manipulator.constraints();
  ConstraintKinds kinds = manipulator.constraint_kinds();
  kinds[index_of(ConstraintKind::actuated_limits)] = kinds[index_of(ConstraintKind::margins)] = false;
  none_ = kinds.none();
  const Interval half(0.5);
  half_crank_ = half * Interval(constraints.thickness.crank);
  half_rod_ = half * Interval(constraints.thickness.rod);
  for (const Leg& leg : manipulator.legs()) has_crank_.push_back(leg.kind().has_crank);
  for (const PassiveLimit& limit : constraints.passive_limits)
    passive_limits_[limit.leg].push_back({limit.angle, AngleLimits(limit.limits, limit.offset, limit.sense)});
  for (const PassiveCone& limit : constraints.passive_cones)
    passive_cones_[limit.cone.leg].emplace_back(limit.cone, manipulator.leg(limit.cone.leg));
  for (const HingeLimit& limit : constraints.hinge_limits)
    if (limit.is_limited()) add(limit, manipulator.motions());
  for (const BallJointCone& cone : constraints.cones)
    cones_[cone.leg].emplace_back(cone, manipulator.leg(cone.leg));
  if (constraints.self_collision) add_pairs(manipulator);
  for (const Obstacle& obstacle : constraints.obstacles)
    std::visit([this](const auto& shape) { add(shape); }, obstacle.shape);
  if (constraints.thickness.platform) add_platform(manipulator);
  if (constraints.workspace) set_workspace(*constraints.workspace, directions(manipulator.task_space()));
}

// With s = sin(twist), the z axis of the platform is s (sin theta1, -cos theta1, .) in the base, and that of
// the base s (sin theta2, cos theta2, .) in the platform.
template <std::size_t D>
void ConstraintTests<D>::add(const HingeLimit& limit, const Motions& motions) {
  const Interval half(0.5), lower(limit.limits.lower), upper(limit.limits.upper), zero(0.0), one(1.0);
  const Turn<Interval> middle = enclosed_turn(0.0, 1.0, half * (lower + upper));
  const Turn<Interval> width = enclosed_turn(0.0, 1.0, half * (upper - lower));
  std::array<Interval, 3> in_base{middle.cosine, middle.sine, zero}, in_platform{one, zero, zero};
  Interval least = width.cosine;
  if (motions.space == TaskSpace::R2) {
    least = least * enclosed_turn(motions.hinges.twist).sine;
    const std::array<Interval, 3> z_axis{zero, zero, one};
    const bool first = limit.hinge == 0;
    const std::array<Interval, 3> across{middle.sine, first ? -middle.cosine : middle.cosine, zero};
    in_base = first ? across : z_axis;
    in_platform = first ? z_axis : across;
  }
  HingeTest test;
  for (std::size_t i = 0; i < D; ++i) {
    test.in_base[i] = in_base[i];
    test.in_platform[i] = in_platform[i];
  }
  test.least = least;
  hinge_limits_.push_back(test);
}

template <std::size_t D>
void ConstraintTests<D>::set_workspace(const WorkspaceBox& box, std::size_t count) {
  workspace_directions_ = std::min(D, count);
  for (std::size_t i = 0; i < workspace_directions_; ++i) {
    workspace_lower_[i] = box.lower[static_cast<Eigen::Index>(i)];
    workspace_upper_[i] = box.upper[static_cast<Eigen::Index>(i)];
  }
}

template <std::size_t D>
void ConstraintTests<D>::add(const BallObstacle& ball) {
  obstacles_.push_back(Ball{enclosed<D>(ball.center), Interval(ball.radius)});
}

template <std::size_t D>
void ConstraintTests<D>::add(const BoxObstacle& box) {
  const Eigen::Matrix3d rotation = box.orientation.toRotationMatrix();
  Box result{enclosed<D>(box.center), {}, {}};
  for (std::size_t i = 0; i < D; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    result.axes[i] = enclosed<D>(rotation.col(axis), few_units);
    result.extent.half_size[i] = box.half_size[axis];
  }
  obstacles_.push_back(result);
}

template <std::size_t D>
void ConstraintTests<D>::add_pairs(const Manipulator& manipulator) {
  const LinkThickness& thickness = manipulator.constraints().thickness;
  for (std::size_t i = 0; i < manipulator.leg_count(); ++i)
    for (std::size_t j = i + 1; j < manipulator.leg_count(); ++j)
      for (const LinkKind one : {LinkKind::crank, LinkKind::rod})
        for (const LinkKind other : {LinkKind::crank, LinkKind::rod}) {
          if ((one == LinkKind::crank && !has_crank_[i]) || (other == LinkKind::crank && !has_crank_[j]))
            continue;
          if (!parallel_aspects::can_collide(manipulator, {one, i}, {other, j})) continue;
          pairs_[i][j].push_back(
              {one, other,
               Interval(0.5) * (Interval(width(thickness, one)) + Interval(width(thickness, other)))});
        }
}

/// Its sides from anchor to anchor, in the order of the legs.
template <std::size_t D>
void ConstraintTests<D>::add_platform(const Manipulator& manipulator) {
  half_platform_ = Interval(0.5) * Interval(*manipulator.constraints().thickness.platform);
  const std::size_t count = manipulator.leg_count();
  for (std::size_t j = 0; j < (count > 2 ? count : count - 1); ++j) {
    const std::size_t next = (j + 1) % count;
    if ((manipulator.leg(j).anchor - manipulator.leg(next).anchor).norm() >
        joint_tolerance * manipulator.size())
      platform_sides_.push_back({j, next});
  }
}

template class ConstraintTests<2>;
template class ConstraintTests<3>;

}  // namespace parallel_aspects
