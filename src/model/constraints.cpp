// SPDX-License-Identifier: BSD-3-Clause
#include "model/angles.h"
#include "model/message_text.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/model/manipulator.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

bool is_width(double value) { return std::isfinite(value) && value >= 0.0; }

class Check {
 public:
  Check(const Constraints& constraints, TaskSpace space, const std::vector<Leg>& legs)
      : constraints_(constraints), space_(space), legs_(legs) {}

  Problems run() {
    check_thickness();
    if (constraints_.self_collision) check_self_collision(*constraints_.self_collision);
    for (const Obstacle& obstacle : constraints_.obstacles)
      std::visit([&](const auto& shape) { check(obstacle.name, shape); }, obstacle.shape);
    if (!constraints_.obstacles.empty()) check_links("obstacles");
    if (constraints_.workspace) check_workspace(*constraints_.workspace);
    check_margins(constraints_.margins);
    for (const PassiveLimit& limit : constraints_.passive_limits) check_passive(limit);
    for (const PassiveCone& limit : constraints_.passive_cones) check_cone(limit.cone);
    for (const HingeLimit& limit : constraints_.hinge_limits) check_hinge(limit);
    for (const BallJointCone& cone : constraints_.cones) check_cone(cone);
    return std::move(problems_);
  }

 private:
  void problem(const std::string& message) { problems_.push_back(message); }

  void check_thickness() {
    const LinkThickness& thickness = constraints_.thickness;
    if (!is_width(thickness.crank) || !is_width(thickness.rod) || !is_width(thickness.platform.value_or(0.0)))
      problem("The thickness of a link is negative or not finite; give zero or a positive width in m.");
  }

  /// Of all that asks where links are.
  void check_links(const std::string& what) {
    if (space_ == TaskSpace::SO3)
      problem("The links of a robot in SO3 are not straight, so that " + what +
              " cannot be determined from distances; leave that out.");
    for (const Leg& leg : legs_)
      if (!leg.kind().has_straight_rod)
        problem("Leg '" + leg.name + "' is actuated at its elbow, so that " + what +
                " cannot be determined from the distance of its ends; leave that out.");
  }

  void check_self_collision(const SelfCollision& collision) {
    check_links("self_collision");
    const LinkThickness& thickness = constraints_.thickness;
    const bool cranks =
        std::any_of(legs_.begin(), legs_.end(), [](const Leg& leg) { return leg.kind().has_crank; });
    if (!is_planar(space_) && !(thickness.rod > 0.0 && (thickness.crank > 0.0 || !cranks)))
      problem(
          "In space, links without thickness all but never touch; give self_collision a thickness of crank "
          "and rod.");
    for (const auto& pair : collision.ignored)
      for (const LinkName& link : pair)
        if (link.leg >= legs_.size())
          problem("There is no link '" + to_string(link) +
                  "' to leave out of self_collision; the robot has " + std::to_string(legs_.size()) +
                  " legs.");
  }

  void check(const std::string& name, const BallObstacle& ball) {
    if (!ball.center.allFinite() || !std::isfinite(ball.radius) || !(ball.radius > 0.0))
      problem("Obstacle '" + name + "' needs a finite center and a positive radius in m; correct it.");
  }

  void check(const std::string& name, const BoxObstacle& box) {
    const double smallest = is_planar(space_) ? box.half_size.head<2>().minCoeff() : box.half_size.minCoeff();
    if (!box.center.allFinite() || !box.half_size.allFinite() || !(smallest > 0.0) ||
        !(std::abs(box.orientation.norm() - 1.0) < 1e-9))
      problem("Obstacle '" + name +
              "' needs a finite center, positive sizes in m and a direction; correct it.");
  }

  void check_workspace(const WorkspaceBox& box) {
    const auto count = static_cast<Eigen::Index>(directions(space_));
    if (count == 0)
      problem(
          "A robot in " + std::string(name(space_)) + " turns only; leave out the workspace" +
          (has_hinges(space_) ? ", and limit the passive joints that hold the platform in the URDF." : "."));
    for (Eigen::Index i = 0; i < count; ++i)
      if (!std::isfinite(box.lower[i]) || !std::isfinite(box.upper[i]) || !(box.lower[i] < box.upper[i]))
        problem("The workspace needs finite numbers, each of lower below that of upper; number " +
                std::to_string(i + 1) + " is not.");
  }

  void check_margins(const Margins& margins) {
    for (const NamedMargin& margin : named_margins)
      if (!(margins.*margin.member >= 0.0 && margins.*margin.member < margin.bound))
        problem("The margin '" + std::string(margin.name) + "' is " + number_text(margins.*margin.member) +
                "; it must be " + std::string(margin.range) + ": " + std::string(margin.meaning) + ".");
  }

  void check_passive(const PassiveLimit& limit) {
    if (limit.leg >= legs_.size() || !std::isfinite(limit.offset) || std::abs(limit.sense) != 1.0 ||
        !(limit.limits.lower <= limit.limits.upper) || !is_planar(space_))
      problem("The limits of joint '" + limit.joint + "' are not those of a leg in the plane; correct them.");
  }

  void check_hinge(const HingeLimit& limit) {
    if (!has_hinges(space_) || limit.hinge >= degrees_of_freedom(space_) ||
        !(limit.limits.lower < limit.limits.upper))
      problem("The limits of joint '" + limit.joint +
              "' are not those of the passive chain that holds the platform; correct them.");
  }

  void check_cone(const BallJointCone& cone) {
    if (cone.leg >= legs_.size())
      return problem("A cone names leg " + std::to_string(cone.leg + 1) + ", but the robot has " +
                     std::to_string(legs_.size()) + " legs; count them from 1.");
    const std::string which =
        "The cone at the " + std::string(name(cone.end)) + " end of leg " + std::to_string(cone.leg + 1);
    if (space_ == TaskSpace::SO3)
      return problem(which +
                     " is one of a robot in SO3, whose links are arcs and have no direction; leave it out.");
    if (!legs_[cone.leg].kind().has_straight_rod)
      problem(which +
              " cannot be tested, since the leg is actuated at its elbow, and the distance of its ends does "
              "not determine where its links point; leave it out.");
    if (!cone.axis.allFinite() || !(std::abs(cone.axis.norm() - 1.0) < 1e-9) ||
        (is_planar(space_) && cone.axis.z() != 0.0))
      problem(which + " has an axis that is not a unit vector" +
              (is_planar(space_) ? " of the plane; give one." : "; normalise it."));
    if (!(cone.angle > 0.0 && cone.angle < pi))
      problem(
          which + " has an angle of " + std::to_string(cone.angle) +
          " rad; give the angle from its axis to its surface, above 0 and below pi, or leave the cone out "
          "where the joint may lean to every side.");
  }

  const Constraints& constraints_;
  TaskSpace space_;
  const std::vector<Leg>& legs_;
  Problems problems_;
};

}  // namespace

std::string_view name(ConstraintKind kind) noexcept {
  switch (kind) {
    case ConstraintKind::actuated_limits:
      return "actuated_limits";
    case ConstraintKind::passive_limits:
      return "passive_limits";
    case ConstraintKind::cones:
      return "cones";
    case ConstraintKind::self_collision:
      return "self_collision";
    case ConstraintKind::obstacles:
      return "obstacles";
    case ConstraintKind::workspace:
      return "workspace";
    case ConstraintKind::margins:
      break;
  }
  return "margins";
}

bool HingeLimit::is_limited() const noexcept { return limits.upper - limits.lower < full_turn; }

std::string_view name(LegEnd end) noexcept { return end == LegEnd::base ? "base" : "platform"; }

std::optional<ConstraintKind> constraint_named(std::string_view text) noexcept {
  for (const ConstraintKind kind : all_constraint_kinds)
    if (text == name(kind)) return kind;
  return std::nullopt;
}

std::string to_string(const LinkName& link) {
  return (link.kind == LinkKind::crank ? "crank_" : "rod_") + std::to_string(link.leg + 1);
}

std::size_t directions(TaskSpace space) noexcept { return traits(space).translations; }

bool is_planar(TaskSpace space) noexcept { return traits(space).planar; }

Problems find_problems(const Constraints& constraints, TaskSpace space, const std::vector<Leg>& legs) {
  return Check(constraints, space, legs).run();
}

}  // namespace parallel_aspects
