// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/file/map_key.h"

#include "model/linear_algebra.h"
#include "model/message_text.h"

#include <cctype>
#include <cstddef>
#include <initializer_list>
#include <set>
#include <sstream>

namespace parallel_aspects {
namespace {

std::string numbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += " " + number_text(value, exact_digits);
  return text;
}

std::string numbers(const Eigen::Vector3d& v) { return numbers({v.x(), v.y(), v.z()}); }

std::string line(const PassiveLimit& limit) {
  return "passive joint '" + printable(limit.joint) + "' of leg " + std::to_string(limit.leg + 1) +
         ", angle " + std::to_string(static_cast<int>(limit.angle)) +
         numbers({limit.offset, limit.sense, limit.limits.lower, limit.limits.upper}) + "\n";
}

std::string line(const BallJointCone& cone) {
  return "leg " + std::to_string(cone.leg + 1) + ", " + std::string(name(cone.end)) + " end" +
         numbers(cone.axis) + numbers({cone.angle}) + "\n";
}

std::string line(const BallObstacle& ball) { return " ball" + numbers(ball.center) + numbers({ball.radius}); }

std::string line(const BoxObstacle& box) {
  const Eigen::Vector4d& q = box.orientation.coeffs();
  return " box" + numbers(box.center) + numbers({q[0], q[1], q[2], q[3]}) + numbers(box.half_size);
}

std::string lines(const SelfCollision& collision) {
  std::string text = "links of two legs do not touch\n";
  for (const auto& [one, other] : collision.ignored)
    text += "but " + to_string(one) + " may touch " + to_string(other) + "\n";
  return text;
}

}  // namespace

std::string printable(std::string text) {
  for (char& character : text)
    if (std::iscntrl(static_cast<unsigned char>(character)) != 0) character = '?';
  return text;
}

std::string constraint_key(const Constraints& constraints) {
  std::string key;
  for (const PassiveLimit& limit : constraints.passive_limits) key += line(limit);
  for (const PassiveCone& limit : constraints.passive_cones)
    key += "passive joint '" + printable(limit.joint) + "', cone of " + line(limit.cone);
  for (const HingeLimit& limit : constraints.hinge_limits)
    key += "hinge '" + printable(limit.joint) + "', theta" + std::to_string(limit.hinge + 1) +
           numbers({limit.limits.lower, limit.limits.upper}) + "\n";
  for (const BallJointCone& cone : constraints.cones) key += "cone of " + line(cone);
  const bool links = constraints.self_collision || !constraints.obstacles.empty();
  if (links)
    key += "thickness of crank, rod and platform" +
           numbers({constraints.thickness.crank, constraints.thickness.rod,
                    constraints.thickness.platform.value_or(-1.0)}) +
           "\n";
  if (constraints.self_collision) key += lines(*constraints.self_collision);
  for (const Obstacle& obstacle : constraints.obstacles)
    key += "obstacle" + std::visit([](const auto& shape) { return line(shape); }, obstacle.shape) + "\n";
  if (constraints.workspace)
    key += "workspace" + numbers(constraints.workspace->lower) + numbers(constraints.workspace->upper) + "\n";
  const Margins& margins = constraints.margins;
  if (margins.any()) key += "margins" + numbers({margins.parallel, margins.serial, margins.det_a}) + "\n";
  return key;
}

namespace {

std::string exact(double value) { return number_text(value, exact_digits); }

/// The lines of one leg.
class LegLines {
 public:
  LegLines(const Leg& leg, std::size_t index) : start_("leg " + std::to_string(index + 1) + ", ") {
    text_ = start_ + std::string(leg.kind().name) + "\n";
    std::visit([this](const auto& actuation) { add(actuation); }, leg.actuation);
    point("anchor", leg.anchor);
    values("rod length", {leg.rod_length});
    values("limits", {leg.limits.lower, leg.limits.upper});
    if (leg.tolerance > 0.0) values("tolerance", {leg.tolerance});
  }

  const std::string& text() const noexcept { return text_; }

 private:
  void values(const char* what, std::initializer_list<double> items) {
    text_ += start_ + what;
    for (const double each : items) text_ += " " + exact(each);
    text_ += "\n";
  }
  void point(const char* what, const Eigen::Vector3d& at) { values(what, {at.x(), at.y(), at.z()}); }

  void add(const RevoluteActuation& actuation) {
    point("center", actuation.center);
    point("axis", actuation.axis);
    point("zero direction", actuation.zero_direction);
    values("crank length", {actuation.radius});
  }
  void add(const PrismaticActuation& actuation) {
    point("origin", actuation.origin);
    point("direction", actuation.direction);
  }
  void add(const StrutActuation& actuation) {
    point("base", actuation.base);
    values("length at zero and sense", {actuation.length_at_zero, actuation.sense});
  }
  void add(const ElbowActuation& actuation) {
    point("base", actuation.base);
    values("inner and outer length", {actuation.inner_length, actuation.outer_length});
    values("angle at zero and sense", {actuation.angle_at_zero, actuation.sense});
  }

  std::string start_;
  std::string text_;
};

}  // namespace

std::string map_key(const Manipulator& manipulator, const Box& region, double resolution, std::uint32_t depth,
                    std::uint32_t deepest_level) {
  std::string key = "robot '" + printable(manipulator.name()) + "'\n";
  key += "task space " + std::string(name(manipulator.task_space())) + "\n";
  if (manipulator.task_space() == TaskSpace::R2)
    key +=
        "hinges" + numbers({manipulator.motions().hinges.offset, manipulator.motions().hinges.twist}) + "\n";
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) key += LegLines(manipulator.leg(j), j).text();
  key += constraint_key(manipulator.constraints());
  for (std::size_t i = 0; i < region.dimension; ++i)
    key += "region along coordinate " + std::to_string(i + 1) + " from " + exact(region.lower[i]) + " to " +
           exact(region.upper[i]) + "\n";
  key += "resolution " + exact(resolution) + " after " + std::to_string(depth) + " halvings\n";
  key += "contested leaves halved " + std::to_string(deepest_level - depth) + " times more\n";
  return key;
}

std::string coverage_key(const std::optional<MapSlice>& slice, const std::vector<WorkingMode>& modes) {
  std::string key = "slice:";
  if (slice) {
    const Eigen::Vector4d orientation = slice->held.orientation.coeffs();
    for (const double each : coefficients_of(slice->held.position)) key += " " + exact(each);
    for (const double each : coefficients_of(orientation)) key += " " + exact(each);
    for (const double each : coefficients_of(slice->axis)) key += " " + exact(each);
    for (const bool each : slice->moves) key += each ? " free" : " held";
    key +=
        " rotation " + std::to_string(static_cast<int>(slice->rotation)) + " " + printable(slice->angle_name);
    if (slice->joint)
      key += " joint of leg " + std::to_string(slice->joint->leg + 1) + " at " + exact(slice->joint->value);
  } else {
    key += " all poses";
  }
  key += "\nworking modes";
  for (const WorkingMode& mode : modes) key += " " + to_string(mode);
  return key + "\n";
}

std::string line_missing_in(const std::string& text, const std::string& other) {
  std::set<std::string> known;
  std::istringstream lines(text), other_lines(other);
  for (std::string line; std::getline(lines, line);) known.insert(line);
  for (std::string line; std::getline(other_lines, line);)
    if (known.count(line) == 0) return line;
  return "";
}

}  // namespace parallel_aspects
