// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/file/constraint_key.h"

#include "model/number_text.h"

#include <cctype>
#include <initializer_list>

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

}  // namespace parallel_aspects
