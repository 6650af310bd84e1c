// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/config/mechanism_config.h"

#include "urdf/description/yaml_values.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <vector>

namespace parallel_aspects {
namespace {

bool read_vector(const YamlValues& yaml, const YAML::Node& node, const std::string& where,
                 Eigen::Vector3d& vector) {
  std::vector<double> values;
  if (!node.IsDefined()) return true;
  if (!yaml.numbers(node, where, values)) return false;
  if (values.size() != 3) {
    yaml.problem("has " + std::to_string(values.size()) + " numbers in " + where + "; give three.");
    return false;
  }
  vector = Eigen::Vector3d(values[0], values[1], values[2]);
  return true;
}

}  // namespace

bool read_frame(const YamlValues& yaml, const YAML::Node& node, const std::string& where,
                ConfiguredFrame& frame) {
  if (!node.IsDefined() || !node.IsMap()) return yaml.text(node, where, frame.link);
  yaml.check_keys(node, {"link", "xyz", "rpy", "name"}, where);
  frame.is_link = false;
  if (!node["link"].IsDefined()) {
    yaml.problem("does not say " + where + ".link; name the link that the frame is fixed to.");
    return false;
  }
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero(), rpy = Eigen::Vector3d::Zero();
  bool good = yaml.text(node["link"], where + ".link", frame.link);
  good = read_vector(yaml, node["xyz"], where + ".xyz", xyz) && good;
  good = read_vector(yaml, node["rpy"], where + ".rpy", rpy) && good;
  if (node["name"].IsDefined()) good = yaml.text(node["name"], where + ".name", frame.name) && good;
  frame.in_link = Eigen::Translation3d(xyz) * Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                  Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                  Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX());
  return good;
}

namespace {

// More would be another robot: loops close to within as much.
constexpr double max_symmetrized = 1e-3;

// Of robots that differ by more next to nothing can be proved at once.
constexpr double max_tolerance = 0.1;

const std::vector<std::string>& mechanism_keys() {
  static const std::vector<std::string> keys{
      "name",       "base_link", "operational_point", "actuated_joints", "task_space",
      "symmetrize", "tolerance", "closures",          "added_closures",  "task"};
  return keys;
}

// What a robot's file may say; all but the first two is for others.
const std::vector<std::string>& top_keys() {
  static const std::vector<std::string> keys{"mechanism",
                                             "constraints",
                                             "motion",
                                             "map",
                                             "start",
                                             "tracking",
                                             "passive",
                                             "distance",
                                             "thresholds",
                                             "guard",
                                             "state",
                                             "completed",
                                             "joint_states_timeout",
                                             "joint_states_window",
                                             "probe",
                                             "uniqueness",
                                             "tf_timeout",
                                             "read_only",
                                             "frame_prefix",
                                             "display",
                                             "diagnostic_period"};
  return keys;
}

class MechanismReader {
 public:
  MechanismReader(const std::string& file, Problems& problems)
      : file_(file), problems_(problems), yaml_(file, problems) {}

  MechanismConfig read(const YAML::Node& root) {
    MechanismConfig config;
    // What is there but unusable is one problem, not two.
    config.lists_actuated_joints = config.lists_closures = true;
    check_top(root);
    const YAML::Node mechanism = root.IsMap() ? root["mechanism"] : YAML::Node();
    if (!root.IsMap() || !mechanism.IsDefined()) {
      problem(
          "has no key 'mechanism'; add it, with base_link, operational_point, actuated_joints and closures.");
      return config;
    }
    if (!mechanism.IsMap()) {
      problem(
          "has a 'mechanism' that is not a map of keys; write operational_point, actuated_joints and "
          "closures "
          "under it.");
      return config;
    }
    yaml_.check_keys(mechanism, mechanism_keys(), "mechanism", {{"constraints", constraint_keys()}});
    text(mechanism["name"], "mechanism.name", config.name);
    text(mechanism["base_link"], "mechanism.base_link", config.base_link);
    read_operational_point(mechanism, config);
    read_actuated_joints(mechanism["actuated_joints"], config);
    read_task_space(mechanism["task_space"], config);
    read_symmetrize(mechanism["symmetrize"], config);
    read_tolerance(mechanism["tolerance"], config);
    read_closures(mechanism["closures"], "mechanism.closures", config.closures);
    config.lists_closures = !is_empty(mechanism["closures"]);
    if (mechanism["task"].IsDefined() && (config.lists_closures || !config.added_closures.empty()))
      problem("has mechanism.task, which a serial arm has, and closures; leave one of them out.");
    read_closures(mechanism["added_closures"], "mechanism.added_closures", config.added_closures);
    if (config.lists_closures && !config.added_closures.empty())
      problem(
          "has mechanism.closures and mechanism.added_closures; write all under closures, or leave out "
          "closures, to add some to those that the URDF describes.");
    read_start(root["start"], config);
    config.constraints = read_constraints_config(root["constraints"], file_, problems_);
    return config;
  }

 private:
  void problem(const std::string& message) const { yaml_.problem(message); }

  bool text(const YAML::Node& node, const std::string& where, std::string& value) const {
    return yaml_.text(node, where, value);
  }

  // What files of other programs have besides is not known here.
  void check_top(const YAML::Node& root) const {
    if (root.IsMap() && root["mechanism"].IsDefined() && !root["closed_loop"].IsDefined() &&
        !is_loop_closures_file(root))
      yaml_.check_keys(root, top_keys(), "the top of the file",
                       {{"mechanism", mechanism_keys()}, {"constraints", constraint_keys()}});
  }

  void read_operational_point(const YAML::Node& mechanism, MechanismConfig& config) {
    const YAML::Node node = mechanism["operational_point"];
    if (!node.IsDefined())
      problem(
          "does not say mechanism.operational_point; name the link whose origin is the operational point of "
          "the "
          "platform.");
    if (node.IsDefined()) read_frame(yaml_, node, "mechanism.operational_point", config.operational_point);
  }

  // The section is the node's, which says what is wrong with it.
  static void read_start(const YAML::Node& start, MechanismConfig& config) {
    if (!start.IsDefined() || !start.IsMap() || !start["pose"].IsDefined()) return;
    Problems unused;
    const std::string file;
    YamlValues(file, unused).numbers(start["pose"], "start.pose", config.start);
  }

  void read_actuated_joints(const YAML::Node& node, MechanismConfig& config) {
    config.lists_actuated_joints = node.IsDefined();
    if (!node.IsDefined()) return;
    if (!node.IsSequence() || node.size() == 0) {
      problem(
          "has a mechanism.actuated_joints that is not a list of names; list the actuated joints, one a "
          "leg.");
      return;
    }
    for (std::size_t k = 0; k < node.size(); ++k) {
      std::string joint;
      if (!text(node[k], "mechanism.actuated_joints[" + std::to_string(k) + "]", joint)) continue;
      if (std::find(config.actuated_joints.begin(), config.actuated_joints.end(), joint) !=
          config.actuated_joints.end())
        problem("lists joint '" + joint +
                "' twice in mechanism.actuated_joints; name each actuated joint once.");
      config.actuated_joints.push_back(joint);
    }
  }

  void read_task_space(const YAML::Node& node, MechanismConfig& config) {
    std::string word;
    if (!text(node, "mechanism.task_space", word)) return;
    config.task_space = task_space_named(word);
    if (!config.task_space)
      problem("has the unknown mechanism.task_space '" + word +
              "'; write T1, T2, SE2, T3, SO3, SE3, R1 or R2, or leave it out.");
  }

  void read_symmetrize(const YAML::Node& node, MechanismConfig& config) {
    double tolerance = 0.0;
    if (!yaml_.number(node, "mechanism.symmetrize", tolerance)) return;
    if (tolerance > 0.0 && tolerance <= max_symmetrized)
      config.symmetrize = tolerance;
    else
      problem(
          "has a mechanism.symmetrize that is not above 0 and at most 0.001; give 1.0e-4, or leave it out.");
  }

  void read_tolerance(const YAML::Node& node, MechanismConfig& config) {
    double tolerance = 0.0;
    if (!yaml_.number(node, "mechanism.tolerance", tolerance)) return;
    if (tolerance >= 0.0 && tolerance <= max_tolerance)
      config.tolerance = tolerance;
    else
      problem(
          "has a mechanism.tolerance that is not from 0 to 0.1; "
          "give a share of the robot's size such as 1.0e-4, or leave it out.");
  }

  static bool is_empty(const YAML::Node& node) {
    return !node.IsDefined() || (node.IsSequence() && node.size() == 0);
  }

  void read_closures(const YAML::Node& node, const std::string& where,
                     std::vector<ConfiguredClosure>& closures) {
    if (!node.IsDefined()) return;
    if (!node.IsSequence()) {
      problem("has a " + where +
              " that is not a list; write one entry {frames: [link, link], type: point} for each loop.");
      return;
    }
    for (std::size_t k = 0; k < node.size(); ++k)
      read_closure(node[k], where + "[" + std::to_string(k) + "]", closures);
  }

  void read_closure(const YAML::Node& node, const std::string& where,
                    std::vector<ConfiguredClosure>& closures) {
    if (!node.IsMap()) {
      problem("has a " + where + " that is not a map; write {frames: [link, link], type: point}.");
      return;
    }
    yaml_.check_keys(node, {"frames", "type"}, where);
    ConfiguredClosure closure;
    const YAML::Node frames = node["frames"];
    if (!frames.IsDefined() || !frames.IsSequence() || frames.size() != 2) {
      problem("has a " + where +
              ".frames that is not a list of two links; name the two links whose origins meet.");
      return;
    }
    bool good = true;
    for (std::size_t k = 0; k < 2; ++k)
      good = read_frame(yaml_, frames[k], where + ".frames[" + std::to_string(k) + "]", closure.frames[k]) &&
             good;
    good = read_type(node["type"], where + ".type", closure.type) && good;
    if (good) closures.push_back(closure);
  }

  bool read_type(const YAML::Node& node, const std::string& where, ClosureType& type) {
    if (!node.IsDefined()) return true;
    std::string word;
    if (!text(node, where, word)) return false;
    const auto known = closure_type_named(word);
    if (known) {
      type = *known;
    } else {
      problem("has the unknown " + where + " '" + word +
              "'; write point, revolute, universal, spherical, fixed or auto.");
    }
    return known.has_value();
  }

  const std::string& file_;
  Problems& problems_;
  YamlValues yaml_;
};

// The first line up to `last`, counted from 1, that is indented with a tab, which YAML does not allow.
std::optional<int> line_with_tab(const std::string& text, int last) {
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; number <= last && std::getline(lines, line); ++number) {
    const std::size_t tab = line.find('\t');
    if (tab != std::string::npos && tab < line.find_first_not_of(" \t")) return number;
  }
  return std::nullopt;
}

std::string problem_with_yaml(const std::string& text, const YAML::Exception& error) {
  const int line = error.mark.line + 1;
  if (const auto tab = line_with_tab(text, line))
    return " indents line " + std::to_string(*tab) + " with tabs, which YAML does not allow; write spaces.";
  return " cannot be read as YAML at line " + std::to_string(line) + ": " + error.msg + "; correct it there.";
}

}  // namespace

bool is_loop_closures_file(const YAML::Node& root) {
  if (!root.IsMap()) return false;
  const YAML::Node closures = root["closures"];
  if (!closures.IsDefined() || !closures.IsSequence()) return false;
  return root["independent"].IsDefined() || root["dependent"].IsDefined() ||
         std::any_of(closures.begin(), closures.end(), [](const YAML::Node& closure) {
           return closure.IsMap() && closure["link_a"].IsDefined();
         });
}

MechanismConfig read_mechanism_config(const std::string& text, const std::string& file, Problems& problems) {
  try {
    return MechanismReader(file, problems).read(yaml_document(text));
  } catch (const YAML::Exception& error) {
    problems.push_back(file + problem_with_yaml(text, error));
    return {};
  }
}

}  // namespace parallel_aspects
