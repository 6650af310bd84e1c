// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/config/constraints_config.h"

#include "model/angles.h"
#include "model/message_text.h"
#include "urdf/description/yaml_values.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

const char* const cone_help = "{leg: 1, end: base, axis: [0.0, 0.0, -1.0], angle: 0.6}";
const char* const link_help = "write names such as crank_1 or rod_2";

const char* const leg_help = "give its number, counted from 1 in the order of mechanism.actuated_joints";
constexpr double max_leg_number = 6.0;

/// "crank_2" as a link; the number of a leg has one digit, since no robot has more than six.
std::optional<LinkName> link_named(const std::string& word) {
  for (const LinkKind kind : {LinkKind::crank, LinkKind::rod})
    for (std::size_t leg = 0; leg < 9; ++leg)
      if (to_string(LinkName{kind, leg}) == word) return LinkName{kind, leg};
  return std::nullopt;
}

class ConstraintsReader {
 public:
  ConstraintsReader(const std::string& file, Problems& problems) : yaml_(file, problems) {}

  ConstraintsConfig read(const YAML::Node& node) {
    ConstraintsConfig config;
    if (!node.IsDefined() || node.IsNull()) return config;
    const std::vector<std::string>& known = constraint_keys();
    if (!node.IsMap()) {
      std::string keys;
      for (const std::string& key : known) keys += (keys.empty() ? "" : ", ") + key;
      yaml_.problem("has a 'constraints' that is not a map of keys; write those that are wanted of " + keys +
                    " under it, or leave it out.");
      return config;
    }
    yaml_.check_keys(node, known, "constraints");
    yaml_.truth(node["actuated_limits"], "constraints.actuated_limits", config.actuated_limits);
    yaml_.truth(node["passive_limits"], "constraints.passive_limits", config.passive_limits);
    yaml_.truth(node["strict_limits"], "constraints.strict_limits", config.strict_limits);
    read_cones(node["cones"], config);
    read_thickness(node["thickness"], config.thickness);
    read_self_collision(node["self_collision"], config);
    read_obstacles(node["obstacles"], config);
    read_workspace(node["workspace"], config);
    read_margins(node["margins"], config.margins);
    return config;
  }

 private:
  void read_cones(const YAML::Node& node, ConstraintsConfig& config) {
    if (!node.IsDefined()) return;
    if (!node.IsSequence())
      return yaml_.problem("has a constraints.cones that is not a list; write one entry " +
                           std::string(cone_help) + " for each.");
    for (std::size_t k = 0; k < node.size(); ++k)
      read_cone(node[k], "constraints.cones[" + std::to_string(k) + "]", config);
  }

  void read_cone(const YAML::Node& node, const std::string& where, ConstraintsConfig& config) {
    if (!yaml_.map(node, where, std::string("write ") + cone_help)) return;
    const std::vector<std::string> keys{"leg", "end", "axis", "angle"};
    yaml_.check_keys(node, keys, where);
    bool good = true;
    for (const std::string& key : keys)
      if (!node[key].IsDefined()) {
        yaml_.problem("does not say " + where + "." + key + "; write " + cone_help + ".");
        good = false;
      }
    ConfiguredCone cone;
    cone.key = where;
    good = read_leg(node["leg"], where + ".leg", cone.leg) && good;
    good = read_end(node["end"], where + ".end", cone.end) && good;
    good = read_axis(node["axis"], where + ".axis", cone.axis) && good;
    good = read_angle(node["angle"], where + ".angle", cone.angle) && good;
    if (good) config.cones.push_back(cone);
  }

  bool read_leg(const YAML::Node& node, const std::string& where, std::size_t& leg) {
    double number = 0.0;
    if (!yaml_.number(node, where, number)) return false;
    const bool good = number >= 1.0 && number <= max_leg_number && number == std::floor(number);
    if (good)
      leg = static_cast<std::size_t>(number) - 1;
    else
      yaml_.problem("has a " + where + " that is no leg; " + leg_help + ".");
    return good;
  }

  bool read_end(const YAML::Node& node, const std::string& where, LegEnd& end) {
    std::string text;
    if (!yaml_.text(node, where, text)) return false;
    for (const LegEnd each : {LegEnd::base, LegEnd::platform})
      if (text == name(each)) {
        end = each;
        return true;
      }
    yaml_.problem("has a " + where + " '" + text + "' that is no end of a leg; write base or platform.");
    return false;
  }

  bool read_axis(const YAML::Node& node, const std::string& where, std::vector<double>& axis) {
    if (!yaml_.numbers(node, where, axis)) return false;
    if (std::any_of(axis.begin(), axis.end(), [](double entry) { return entry != 0.0; })) return true;
    yaml_.problem("has a " + where +
                  " of length zero; give the direction of the rod in the middle of its cone.");
    return false;
  }

  bool read_angle(const YAML::Node& node, const std::string& where, double& angle) {
    if (!yaml_.number(node, where, angle)) return false;
    if (angle > 0.0 && angle < pi) return true;
    yaml_.problem("has a " + where +
                  " that is not above 0 and below pi; give half the opening of the cone in rad, or leave the "
                  "cone out where the joint lets the rod point everywhere.");
    return false;
  }

  void read_thickness(const YAML::Node& node, LinkThickness& thickness) {
    if (!yaml_.map(node, "constraints.thickness", "write {crank: 0.1, rod: 0.05}")) return;
    yaml_.check_keys(node, {"crank", "rod", "platform"}, "constraints.thickness");
    width(node["crank"], "constraints.thickness.crank", thickness.crank);
    width(node["rod"], "constraints.thickness.rod", thickness.rod);
    double platform = 0.0;
    if (width(node["platform"], "constraints.thickness.platform", platform)) thickness.platform = platform;
  }

  bool width(const YAML::Node& node, const std::string& where, double& value) {
    double read = 0.0;
    if (!yaml_.number(node, where, read)) return false;
    if (read >= 0.0) {
      value = read;
      return true;
    }
    yaml_.problem("has a negative " + where + "; give zero or a positive width in m.");
    return false;
  }

  void read_self_collision(const YAML::Node& node, ConstraintsConfig& config) {
    if (!node.IsDefined()) return;
    if (node.IsScalar()) {
      bool on = false;
      yaml_.truth(node, "constraints.self_collision", on);
      if (on) config.self_collision.emplace();
      return;
    }
    if (!yaml_.map(node, "constraints.self_collision", "write true, or {ignore: [[crank_1, rod_2]]}")) return;
    yaml_.check_keys(node, {"ignore"}, "constraints.self_collision");
    config.self_collision.emplace();
    const YAML::Node pairs = node["ignore"];
    if (!pairs.IsDefined()) return;
    if (!pairs.IsSequence())
      return yaml_.problem(
          "has a constraints.self_collision.ignore that is not a list of pairs; write [[crank_1, rod_2]].");
    for (std::size_t k = 0; k < pairs.size(); ++k)
      read_pair(pairs[k], "constraints.self_collision.ignore[" + std::to_string(k) + "]",
                config.self_collision->ignored);
  }

  void read_pair(const YAML::Node& node, const std::string& where,
                 std::vector<std::array<LinkName, 2>>& pairs) {
    std::array<LinkName, 2> pair;
    bool good = node.IsSequence() && node.size() == 2;
    for (std::size_t k = 0; k < 2 && good; ++k) {
      const auto link = node[k].IsScalar() ? link_named(node[k].Scalar()) : std::nullopt;
      good = link.has_value();
      if (good) pair[k] = *link;
    }
    if (good) return pairs.push_back(pair);
    yaml_.problem("has a " + where + " that is not a pair of links; " + link_help + ".");
  }

  void read_obstacles(const YAML::Node& node, ConstraintsConfig& config) {
    if (!node.IsDefined()) return;
    if (!node.IsSequence())
      return yaml_.problem(
          "has a constraints.obstacles that is not a list; write one entry {center: [...], radius: r} or "
          "{center: [...], size: [...]} for each.");
    for (std::size_t k = 0; k < node.size(); ++k)
      read_obstacle(node[k], "constraints.obstacles[" + std::to_string(k) + "]", config);
  }

  void read_obstacle(const YAML::Node& node, const std::string& where, ConstraintsConfig& config) {
    if (!yaml_.map(node, where, "write {center: [...], radius: r} or {center: [...], size: [...]}")) return;
    yaml_.check_keys(node, {"name", "center", "radius", "size", "rotation"}, where);
    ConfiguredObstacle obstacle;
    obstacle.key = obstacle.name = where;
    yaml_.text(node["name"], where + ".name", obstacle.name);
    yaml_.numbers(node["center"], where + ".center", obstacle.center);
    yaml_.numbers(node["size"], where + ".size", obstacle.size);
    yaml_.numbers(node["rotation"], where + ".rotation", obstacle.rotation);
    double radius = 0.0;
    if (yaml_.number(node["radius"], where + ".radius", radius)) obstacle.radius = radius;
    if (node["radius"].IsDefined() == node["size"].IsDefined())
      return yaml_.problem("has a " + where +
                           " with both or neither of radius and size; give a ball one radius, or a box its "
                           "size.");
    if (!node["center"].IsDefined())
      return yaml_.problem("does not say " + where + ".center; give the point in m.");
    config.obstacles.push_back(obstacle);
  }

  void read_margins(const YAML::Node& node, Margins& margins) {
    if (!node.IsDefined() || !yaml_.map(node, "constraints.margins", "write {parallel: 0.05, serial: 0.1}"))
      return;
    std::vector<std::string> keys;
    for (const NamedMargin& margin : named_margins) keys.emplace_back(margin.name);
    yaml_.check_keys(node, keys, "constraints.margins");
    for (const NamedMargin& margin : named_margins) {
      const std::string where = "constraints.margins." + std::string(margin.name);
      double value = 0.0;
      if (!yaml_.number(node[std::string(margin.name)], where, value)) continue;
      if (value >= 0.0 && value < margin.bound)
        margins.*margin.member = value;
      else
        yaml_.problem("has a " + where + " of " + number_text(value) + "; it must be " +
                      std::string(margin.range) + ": " + std::string(margin.meaning) + ".");
    }
  }

  void read_workspace(const YAML::Node& node, ConstraintsConfig& config) {
    if (!node.IsDefined() || !yaml_.map(node, "constraints.workspace", "write lower and upper under it"))
      return;
    yaml_.check_keys(node, {"lower", "upper"}, "constraints.workspace");
    config.workspace.emplace();
    for (const auto& [key, values] : {std::make_pair("lower", &(*config.workspace)[0]),
                                      std::make_pair("upper", &(*config.workspace)[1])}) {
      const std::string where = std::string("constraints.workspace.") + key;
      if (!node[key].IsDefined()) yaml_.problem("does not say " + where + "; give the corner in m.");
      yaml_.numbers(node[key], where, *values);
    }
  }

  YamlValues yaml_;
};

/// Points become vectors, with what the plane lacks zero.
class ConstraintsResolver {
 public:
  ConstraintsResolver(const ConstrainedRobot& robot, const std::string& file, Problems& problems)
      : robot_(robot),
        planar_(is_planar(robot.space)),
        directions_(directions(robot.space)),
        file_(file),
        problems_(problems) {}

  void check(const LinkName& link) {
    if (link.leg >= robot_.legs)
      problems_.push_back(file_ + " leaves link '" + to_string(link) +
                          "' out of constraints.self_collision, but the robot has " +
                          std::to_string(robot_.legs) + " legs; " + link_help + ".");
  }

  BallJointCone cone(const ConfiguredCone& written) {
    if (written.leg >= robot_.legs)
      problems_.push_back(file_ + " names leg " + std::to_string(written.leg + 1) + " in " + written.key +
                          ", but the robot has " + std::to_string(robot_.legs) + " legs; " + leg_help + ".");
    if (written.end == LegEnd::platform && robot_.point_platform)
      problems_.push_back(file_ + " gives " + written.key +
                          " an axis in the platform, but the legs of the robot meet in one point, whose pose "
                          "does not determine how a link turns there; leave it out.");
    const Eigen::Vector3d axis = point(written.axis, dimension(), written.key + ".axis");
    const double largest = axis.cwiseAbs().maxCoeff();
    return {written.leg, written.end, largest > 0.0 ? (axis / largest).normalized() : axis, written.angle};
  }

  Obstacle obstacle(const ConfiguredObstacle& written) {
    const Eigen::Vector3d center = point(written.center, dimension(), written.key + ".center");
    if (written.radius) return {written.name, BallObstacle{center, *written.radius}};
    Eigen::Vector3d half = 0.5 * point(written.size, dimension(), written.key + ".size");
    return {written.name, BoxObstacle{center, orientation(written), half}};
  }

  WorkspaceBox workspace(const std::array<std::vector<double>, 2>& corners) {
    return {point(corners[0], directions_, "constraints.workspace.lower"),
            point(corners[1], directions_, "constraints.workspace.upper")};
  }

 private:
  std::size_t dimension() const { return planar_ ? 2 : 3; }

  Eigen::Vector3d point(const std::vector<double>& numbers, std::size_t count, const std::string& where) {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    if (numbers.size() == count)
      std::copy(numbers.begin(), numbers.end(), result.data());
    else
      problems_.push_back(file_ + " has " + std::to_string(numbers.size()) + " numbers in " + where +
                          "; give " + std::to_string(count) + ", one a direction.");
    return result;
  }

  Eigen::Quaterniond orientation(const ConfiguredObstacle& written) {
    if (written.rotation.empty()) return Eigen::Quaterniond::Identity();
    const Eigen::Vector3d angles = point(written.rotation, planar_ ? 1 : 3, written.key + ".rotation");
    const auto about = [](double angle, const Eigen::Vector3d& axis) {
      return Eigen::AngleAxisd(angle, axis);
    };
    if (planar_) return Eigen::Quaterniond(about(angles[0], Eigen::Vector3d::UnitZ()));
    return about(angles[2], Eigen::Vector3d::UnitZ()) * about(angles[1], Eigen::Vector3d::UnitY()) *
           Eigen::Quaterniond(about(angles[0], Eigen::Vector3d::UnitX()));
  }

  const ConstrainedRobot robot_;
  bool planar_;
  std::size_t directions_;
  const std::string& file_;
  Problems& problems_;
};

}  // namespace

const std::vector<std::string>& constraint_keys() {
  static const std::vector<std::string> keys{"actuated_limits", "passive_limits", "strict_limits",
                                             "cones",           "thickness",      "self_collision",
                                             "obstacles",       "workspace",      "margins"};
  return keys;
}

ConstraintsConfig read_constraints_config(const YAML::Node& node, const std::string& file,
                                          Problems& problems) {
  return ConstraintsReader(file, problems).read(node);
}

Constraints resolve_constraints(const ConstraintsConfig& config, const ConstrainedRobot& robot,
                                const std::string& file, Problems& problems) {
  const std::size_t before = problems.size();
  ConstraintsResolver resolver(robot, file, problems);
  Constraints constraints;
  constraints.thickness = config.thickness;
  constraints.self_collision = config.self_collision;
  constraints.margins = config.margins;
  for (const ConfiguredCone& cone : config.cones) constraints.cones.push_back(resolver.cone(cone));
  for (const ConfiguredObstacle& obstacle : config.obstacles)
    constraints.obstacles.push_back(resolver.obstacle(obstacle));
  if (config.workspace) constraints.workspace = resolver.workspace(*config.workspace);
  if (config.self_collision)
    for (const auto& pair : config.self_collision->ignored)
      for (const LinkName& link : pair) resolver.check(link);
  return problems.size() == before ? constraints : Constraints{};
}

}  // namespace parallel_aspects
