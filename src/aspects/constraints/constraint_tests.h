// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_CONSTRAINT_TESTS_H
#define PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_CONSTRAINT_TESTS_H

#include "aspects/constraints/collision_monotonicity.h"
#include "aspects/constraints/margin_tests.h"
#include "aspects/constraints/rod_cone.h"
#include "aspects/constraints/separation.h"
#include "interval/interval.h"
#include "legs/limit_verdict.h"
#include "legs/link_points.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

namespace parallel_aspects {

/// Two links that must not touch.
struct LinkPair {
  LinkKind first, second;
  Interval distance;  ///< of their middle lines, at least [m]
};

/// What the constraints of a manipulator say of enclosed points, in D = 2 or 3 dimensions, with its constants
/// enclosed in intervals. Must be made under a live `RoundingUpward`. Limits of actuated joints are with the
/// legs.
template <std::size_t D>
class ConstraintTests {
 public:
  explicit ConstraintTests(const Manipulator& manipulator);

  /// Whether points have nothing to keep; margins do not count, which ask for more than points.
  bool none() const noexcept { return none_; }
  const MarginTests<D>& margins() const noexcept { return margins_; }
  bool has_obstacles() const noexcept { return !obstacles_.empty(); }
  bool has_platform() const noexcept { return has_obstacles() && !platform_sides_.empty(); }
  bool has_passive_limits(std::size_t leg) const noexcept {
    return !passive_limits_[leg].empty() || !passive_cones_[leg].empty();
  }
  bool has_hinge_limits() const noexcept { return !hinge_limits_.empty(); }
  bool has_cones(std::size_t leg) const noexcept { return !cones_[leg].empty(); }
  bool can_collide(std::size_t leg, std::size_t other) const noexcept { return !pairs_[leg][other].empty(); }

  /// Whether the operational point is in its box.
  template <class Scalar>
  Verdict workspace(const Point<Scalar, D>& position) const {
    Verdict result = Verdict::holds;
    for (std::size_t i = 0; i < workspace_directions_; ++i) {
      const Interval range = range_of(position[i]);
      result = both(result, both(is_positive(range - Interval(workspace_lower_[i])),
                                 is_positive(Interval(workspace_upper_[i]) - range)));
    }
    return result;
  }

  /// The functions of `workspace`, which are positive where it holds, one after the other.
  template <class Scalar, class Action>
  void for_each_workspace_function(const Point<Scalar, D>& position, const Action& action) const {
    for (std::size_t i = 0; i < workspace_directions_; ++i) {
      action(position[i] - Scalar(workspace_lower_[i]));
      action(Scalar(workspace_upper_[i]) - position[i]);
    }
  }

  /// Functions that are positive where the joints of the passive chain of R1 or R2 are within their limits;
  /// `robot` turns what is fixed in the platform.
  template <class Robot, class Action>
  void for_each_hinge_function(const Robot& robot, const Action& action) const {
    for (const HingeTest& test : hinge_limits_) {
      const auto turned = robot.turned(test.in_platform);
      auto along = test.in_base[0] * turned[0] + test.in_base[1] * turned[1];
      if constexpr (D == 3) along = along + test.in_base[2] * turned[2];
      action(along - std::decay_t<decltype(along)>(test.least));
    }
  }

  /// Whether they are.
  template <class Robot>
  Verdict hinge_limits(const Robot& robot) const {
    Verdict result = Verdict::holds;
    for_each_hinge_function(
        robot, [&result](const auto& value) { result = both(result, is_positive(range_of(value))); });
    return result;
  }

  /// The limits of each passive joint of a leg, as functions; `robot` turns what is fixed in the platform.
  template <class Scalar, class Robot, class Action>
  void for_each_passive_limit(std::size_t leg, const LinkPoints<Scalar, D>& points, const Robot& robot,
                              const Action& action) const {
    for (const PassiveTest& test : passive_limits_[leg]) action(functions(test, points, robot));
    for (const RodCone<D>& cone : passive_cones_[leg]) {
      LimitFunctions<Scalar> limits;
      limits.add(cone.function(points, robot));
      action(limits);
    }
  }

  /// The functions of `cones`, which are positive where it holds, one after the other.
  template <class Scalar, class Robot, class Action>
  void for_each_cone(std::size_t leg, const LinkPoints<Scalar, D>& points, const Robot& robot,
                     const Action& action) const {
    for (const RodCone<D>& cone : cones_[leg]) action(cone.function(points, robot));
  }

  /// Whether the rod of a leg is in all its cones.
  template <class Scalar, class Robot>
  Verdict cones(std::size_t leg, const LinkPoints<Scalar, D>& points, const Robot& robot) const {
    Verdict result = Verdict::holds;
    for_each_cone(leg, points, robot,
                  [&result](const Scalar& value) { result = both(result, is_positive(range_of(value))); });
    return result;
  }

  /// Whether all passive joints of a leg are within their limits.
  template <class Scalar, class Robot>
  Verdict passive_limits(std::size_t leg, const LinkPoints<Scalar, D>& points, const Robot& robot) const {
    Verdict result = Verdict::holds;
    for_each_passive_limit(leg, points, robot, [&result](const LimitFunctions<Scalar>& limits) {
      LimitFunctions<Interval> ranges{{}, limits.count, limits.any};
      for (std::size_t k = 0; k < limits.count; ++k) ranges.values[k] = range_of(limits.values[k]);
      result = both(result, verdict(ranges));
    });
    return result;
  }

  /// Whether the links of a leg are clear of all obstacles.
  template <class Scalar>
  Verdict obstacles(std::size_t leg, const LinkPoints<Scalar, D>& points) const {
    Verdict result = clear_of_obstacles(points.rod(), half_rod_);
    if (has_crank_[leg] && result != Verdict::fails)
      result = both(result, clear_of_obstacles(points.crank(), half_crank_));
    return result;
  }

  /// Whether the platform, with its anchors there, is clear of all obstacles.
  template <class Scalar>
  Verdict platform(const std::array<Point<Scalar, D>, max_legs>& anchors) const {
    Verdict result = Verdict::holds;
    for (const auto& [from, to] : platform_sides_)
      result =
          both(result, clear_of_obstacles(Segment<Scalar, D>{anchors[from], anchors[to]}, half_platform_));
    return result;
  }

  /// Whether the links of two legs, the one with the smaller index first, are clear of each other.
  template <class Scalar>
  Verdict collision(std::size_t leg, const LinkPoints<Scalar, D>& points, std::size_t other,
                    const LinkPoints<Scalar, D>& other_points) const {
    Verdict result = Verdict::holds;
    for (const LinkPair& pair : pairs_[leg][other]) {
      result =
          both(result, are_apart(link(pair.first, points), link(pair.second, other_points), pair.distance));
      if (result == Verdict::fails) break;
    }
    return result;
  }

  /// Calls `action` with functions that are positive where the links of a leg are clear of each obstacle;
  /// they prove nothing.
  template <class Scalar, class Action>
  void for_each_clearance(std::size_t leg, const LinkPoints<Scalar, D>& points, const Action& action) const {
    add_clearances(points.rod(), half_rod_, action);
    if (has_crank_[leg]) add_clearances(points.crank(), half_crank_, action);
  }

  /// Of the platform and each obstacle.
  template <class Scalar, class Action>
  void for_each_clearance(const std::array<Point<Scalar, D>, max_legs>& anchors, const Action& action) const {
    for (const auto& [from, to] : platform_sides_)
      add_clearances(Segment<Scalar, D>{anchors[from], anchors[to]}, half_platform_, action);
  }

  /// Of the links of two legs, the one with the smaller index first.
  template <class Scalar, class Action>
  void for_each_clearance(std::size_t leg, const LinkPoints<Scalar, D>& points, std::size_t other,
                          const LinkPoints<Scalar, D>& other_points, const Action& action) const {
    for (const LinkPair& pair : pairs_[leg][other])
      action(clearance(link(pair.first, points), link(pair.second, other_points), pair.distance));
  }

  /// Leaves the directions in which poses grow where the links of two legs are clear of each other, the one
  /// with the smaller index first. Both legs must reach all over the box.
  template <class Slope>
  void require_no_collision(std::size_t leg, const LinkPoints<Slope, D>& points, std::size_t other,
                            const LinkPoints<Slope, D>& other_points, Monotonicity& monotonicity) const {
    for (const LinkPair& pair : pairs_[leg][other])
      require_apart(link(pair.first, points), link(pair.second, other_points), pair.distance, monotonicity);
  }

  /// The same for the links of a leg and all obstacles.
  template <class Slope>
  void require_no_contact(std::size_t leg, const LinkPoints<Slope, D>& points,
                          Monotonicity& monotonicity) const {
    require_no_contact(points.rod(), half_rod_, monotonicity);
    if (has_crank_[leg]) require_no_contact(points.crank(), half_crank_, monotonicity);
  }

  /// The same for the platform and all obstacles.
  template <class Slope>
  void require_no_contact(const std::array<Point<Slope, D>, max_legs>& anchors,
                          Monotonicity& monotonicity) const {
    for (const auto& [from, to] : platform_sides_)
      require_no_contact(Segment<Slope, D>{anchors[from], anchors[to]}, half_platform_, monotonicity);
  }

  template <class Scalar>
  static Segment<Scalar, D> link(LinkKind kind, const LinkPoints<Scalar, D>& points) {
    return kind == LinkKind::crank ? points.crank() : points.rod();
  }

 private:
  struct PassiveTest {
    PassiveAngle angle;
    AngleLimits limits;
  };
  /// A direction of the platform that must not turn farther from one of the base:  in_base . R in_platform >=
  /// least. In R1, and for either joint of R2 times the sine of `twist`, the left side is the cosine of the
  /// angle from the middle of its range.
  struct HingeTest {
    Point<Interval, D> in_base, in_platform;
    Interval least;
  };
  struct Ball {
    Point<Interval, D> center;
    Interval radius;
  };
  struct Box {
    Point<Interval, D> center;
    std::array<Point<Interval, D>, D> axes;
    CenteredBox<D> extent;
  };

  void add(const BallObstacle& ball);
  void add(const BoxObstacle& box);
  void add_pairs(const Manipulator& manipulator);
  void add_platform(const Manipulator& manipulator);
  void add(const HingeLimit& limit, const Motions& motions);
  void set_workspace(const WorkspaceBox& box, std::size_t count);

  template <class Scalar, class Robot>
  static LimitFunctions<Scalar> functions(const PassiveTest& test, const LinkPoints<Scalar, D>& points,
                                          const Robot& robot) {
    const Point<Scalar, D> rod = points.anchor - points.joint;
    const Point<Scalar, 2> in_plane{rod[0], rod[1]};
    switch (test.angle) {
      case PassiveAngle::base_to_rod:
        return test.limits.functions(in_plane[0], in_plane[1]);
      case PassiveAngle::crank_to_rod:
        return functions<Scalar>(
            test.limits, {points.joint[0] - points.base[0], points.joint[1] - points.base[1]}, in_plane);
      case PassiveAngle::rod_to_platform:
        break;
    }
    Point<Interval, D> x_axis{};
    x_axis[0] = Interval(1.0);
    const Point<Scalar, D> heading = robot.turned(x_axis);
    return functions<Scalar>(test.limits, in_plane, {heading[0], heading[1]});
  }

  /// Of the angle from one direction of the plane to another.
  template <class Scalar>
  static LimitFunctions<Scalar> functions(const AngleLimits& limits, const Point<Scalar, 2>& from,
                                          const Point<Scalar, 2>& to) {
    return limits.functions<Scalar>(from[0] * to[0] + from[1] * to[1], from[0] * to[1] - from[1] * to[0]);
  }

  template <class Scalar>
  Verdict clear_of_obstacles(const Segment<Scalar, D>& segment, const Interval& half_width) const {
    Verdict result = Verdict::holds;
    for (const auto& obstacle : obstacles_) {
      result =
          both(result,
               std::visit([&](const auto& shape) { return is_clear(segment, shape, half_width); }, obstacle));
      if (result == Verdict::fails) break;
    }
    return result;
  }

  template <class Scalar, class Action>
  void add_clearances(const Segment<Scalar, D>& segment, const Interval& half_width,
                      const Action& action) const {
    for (const auto& obstacle : obstacles_) {
      if (const Ball* ball = std::get_if<Ball>(&obstacle))
        action(clearance(segment, point_of<Scalar>(*ball), ball->radius + half_width));
      if (const Box* box = std::get_if<Box>(&obstacle))
        action(clearance(seen_from(*box, segment), box->extent, half_width));
    }
  }

  template <class Slope>
  void require_no_contact(const Segment<Slope, D>& segment, const Interval& half_width,
                          Monotonicity& monotonicity) const {
    for (const auto& obstacle : obstacles_) {
      if (const Ball* ball = std::get_if<Ball>(&obstacle))
        require_apart(segment, point_of<Slope>(*ball), ball->radius + half_width, monotonicity);
      if (const Box* box = std::get_if<Box>(&obstacle))
        require_apart_from_box(seen_from(*box, segment), box->extent, half_width, monotonicity);
    }
  }

  template <class Scalar>
  static Segment<Scalar, D> point_of(const Ball& ball) {
    Point<Scalar, D> center;
    for (std::size_t i = 0; i < D; ++i) center[i] = Scalar(ball.center[i]);
    return {center, center};
  }

  template <class Scalar>
  static Verdict is_clear(const Segment<Scalar, D>& segment, const Ball& ball, const Interval& half_width) {
    return are_apart(segment, point_of<Scalar>(ball), ball.radius + half_width);
  }

  template <class Scalar>
  static Verdict is_clear(const Segment<Scalar, D>& segment, const Box& box, const Interval& half_width) {
    return is_apart_from_box(seen_from(box, segment), box.extent, half_width);
  }

  template <class Scalar>
  static Segment<Scalar, D> seen_from(const Box& box, const Segment<Scalar, D>& segment) {
    return {seen_from(box, segment.from), seen_from(box, segment.to)};
  }

  template <class Scalar>
  static Point<Scalar, D> seen_from(const Box& box, const Point<Scalar, D>& point) {
    Point<Scalar, D> offset, result;
    for (std::size_t i = 0; i < D; ++i) offset[i] = point[i] - Scalar(box.center[i]);
    for (std::size_t i = 0; i < D; ++i) {
      result[i] = box.axes[i][0] * offset[0];
      for (std::size_t k = 1; k < D; ++k) result[i] = result[i] + box.axes[i][k] * offset[k];
    }
    return result;
  }

  bool none_ = true;
  MarginTests<D> margins_;
  std::size_t workspace_directions_ = 0;  // 0 without a workspace
  std::array<double, D> workspace_lower_{}, workspace_upper_{};
  std::vector<std::vector<PassiveTest>> passive_limits_;        // by leg
  std::vector<std::vector<RodCone<D>>> passive_cones_, cones_;  // by leg
  std::vector<std::vector<std::vector<LinkPair>>> pairs_;       // by leg and a leg after it
  std::vector<HingeTest> hinge_limits_;
  std::vector<bool> has_crank_;
  std::vector<std::variant<Ball, Box>> obstacles_;
  std::vector<std::array<std::size_t, 2>> platform_sides_;  // by the legs of their anchors
  Interval half_crank_, half_rod_, half_platform_;
};

extern template class ConstraintTests<2>;
extern template class ConstraintTests<3>;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_CONSTRAINT_TESTS_H
