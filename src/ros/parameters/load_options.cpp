// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/load_options.h"

#include "ros/parameters/parameter_reader.h"

#include <ros/param.h>
#include <yaml-cpp/yaml.h>

#include <utility>

namespace parallel_aspects {
namespace {

using XmlRpc::XmlRpcValue;

void emit(YAML::Emitter& out, const XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      out << static_cast<const bool&>(value);
      return;
    case XmlRpcValue::TypeInt:
      out << static_cast<const int&>(value);
      return;
    case XmlRpcValue::TypeDouble:
      out << static_cast<const double&>(value);
      return;
    case XmlRpcValue::TypeString:
      out << YAML::DoubleQuoted << static_cast<const std::string&>(value);
      return;
    case XmlRpcValue::TypeArray:
      out << YAML::BeginSeq;
      for (int i = 0; i < value.size(); ++i) emit(out, value[i]);
      out << YAML::EndSeq;
      return;
    case XmlRpcValue::TypeStruct:
      out << YAML::BeginMap;
      for (const auto& member : value) {
        out << YAML::Key << YAML::DoubleQuoted << member.first << YAML::Value;
        emit(out, member.second);
      }
      out << YAML::EndMap;
      return;
    default:
      out << YAML::Null;
  }
}

std::optional<Box> region_from(ParameterReader reader, Problems& problems, const std::string& name) {
  std::vector<double> lower, upper;
  reader.read("lower", lower);
  reader.read("upper", upper);
  reader.report_unknown_keys();
  if (lower.size() != upper.size() || lower.empty() || lower.size() > max_map_dimension) {
    problems.push_back("Parameter " + name +
                       " must have lower and upper, lists of as many numbers as the platform has positions.");
    return std::nullopt;
  }
  Box region;
  region.dimension = lower.size();
  std::copy(lower.begin(), lower.end(), region.lower.begin());
  std::copy(upper.begin(), upper.end(), region.upper.begin());
  return region;
}

MapOptions map_options_from(ParameterReader reader, const std::string& prefix, std::string& file,
                            Problems& problems) {
  MapOptions map;
  reader.read("file", file);
  reader.read("resolution", map.resolution);
  reader.read("extra_levels", map.extra_levels);
  int threads = 0;
  reader.read("threads", threads);
  if (threads < 0) problems.push_back("Parameter " + prefix + "map/threads must be 0 (one a core) to 1024.");
  map.threads = threads < 0 ? 0 : static_cast<unsigned>(threads);
  if (reader.has("region")) map.region = region_from(reader.group("region"), problems, prefix + "map/region");
  reader.report_unknown_keys();
  return map;
}

StartOptions start_options_from(ParameterReader reader) {
  StartOptions start;
  reader.read("pose", start.pose);
  reader.read("determinant_sign", start.determinant_sign);
  reader.read("tolerance", start.tolerance);
  reader.report_unknown_keys();
  return start;
}

DisplayOptions display_options_from(ParameterReader reader) {
  DisplayOptions display;
  reader.read("gallery", display.gallery);
  reader.read("gallery_scale", display.gallery_scale);
  reader.read("radius", display.radius);
  reader.read("rate", display.rate);
  reader.report_unknown_keys();
  return display;
}

TrackerOptions tracker_options_from(ParameterReader reader, double joint_states_timeout) {
  TrackerOptions tracking;
  // A timeout that makes no sense is refused under its own name alone.
  if (joint_states_timeout > 0.0) tracking.samples.longest_interval = joint_states_timeout;
  reader.read("hysteresis", tracking.hysteresis);
  reader.read("check_velocity", tracking.samples.check_velocity);
  reader.read("velocity_tolerance", tracking.samples.velocity_tolerance);
  reader.read("encoder_noise", tracking.samples.encoder_noise);
  reader.read("path_bend", tracking.samples.path_bend);
  reader.read("longest_interval", tracking.samples.longest_interval);
  reader.read("interval_ratio", tracking.samples.interval_ratio);
  reader.report_unknown_keys();
  return tracking;
}

PassiveOptions passive_options_from(ParameterReader reader) {
  PassiveOptions passive;
  reader.read("angle_tolerance", passive.angle_tolerance);
  reader.read("length_tolerance", passive.length_tolerance);
  reader.read("hysteresis", passive.hysteresis);
  reader.report_unknown_keys();
  return passive;
}

ThresholdParameters thresholds_from(ParameterReader reader) {
  ThresholdParameters thresholds;
  reader.read("parallel_warn", thresholds.parallel_warn);
  reader.read("parallel_stop", thresholds.parallel_stop);
  reader.read("serial_warn", thresholds.serial_warn);
  reader.read("serial_stop", thresholds.serial_stop);
  reader.read("limit_warn", thresholds.limit_warn);
  reader.read("limit_stop", thresholds.limit_stop);
  reader.read("hysteresis", thresholds.hysteresis);
  reader.report_unknown_keys();
  return thresholds;
}

double rate_from(ParameterReader reader, double rate) {
  reader.read("rate", rate);
  reader.report_unknown_keys();
  return rate;
}

int decimation_from(ParameterReader reader) {
  int decimation = 1;
  reader.read("decimation", decimation);
  reader.report_unknown_keys();
  return decimation;
}

// The URDF; nothing, with a message, where there is no text.
std::string urdf_from(const std::string& parameter, Problems& problems) {
  XmlRpcValue value;
  const char* const help = "; load the robot's URDF into it as text.";
  if (!ros::param::get(parameter, value))
    problems.push_back("Parameter " + parameter + " is not there" + help);
  else if (value.getType() != XmlRpcValue::TypeString)
    problems.push_back("Parameter " + parameter + " is not text" + help);
  else
    return static_cast<std::string&>(value);
  return {};
}

// What is under `prefix` for the loader: `mechanism`, and `constraints` where there are some.
SharedMechanism mechanism_from(const ros::NodeHandle& nh, const XmlRpcValue& parameters,
                               const std::string& prefix, const std::string& frame_prefix) {
  const std::string description_name = prefix + "mechanism";
  std::string urdf_name = nh.resolveName("robot_description");
  nh.searchParam("robot_description", urdf_name);
  Problems problems;
  const std::string urdf = urdf_from(urdf_name, problems);
  if (!parameters.hasMember("mechanism"))
    problems.push_back("Parameter " + description_name +
                       " is not there; load config/robots/ROBOT.yaml into the node's namespace.");
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  XmlRpcValue document;
  for (const char* part : {"mechanism", "constraints"})
    if (parameters.hasMember(part)) document[part] = parameters[part];
  return load_mechanism(urdf, urdf_name, yaml_text(document), prefix.substr(0, prefix.size() - 1),
                        frame_prefix);
}

void append(const Problems& found, Problems& problems) {
  problems.insert(problems.end(), found.begin(), found.end());
}

}  // namespace

std::string yaml_text(const XmlRpcValue& value) {
  YAML::Emitter out;
  emit(out, value);
  return out.c_str();
}

NodeOptions options_from(const XmlRpcValue& parameters, const std::string& prefix, Problems& problems) {
  ParameterReader reader(parameters, prefix, problems);
  NodeOptions options;
  reader.read("joint_states_timeout", options.joint_states_timeout);
  options.map = map_options_from(reader.group("map"), prefix, options.map_file, problems);
  options.start = start_options_from(reader.group("start"));
  options.display = display_options_from(reader.group("display"));
  options.tracking = tracker_options_from(reader.group("tracking"), options.joint_states_timeout);
  options.passive = passive_options_from(reader.group("passive"));
  options.thresholds = thresholds_from(reader.group("thresholds"));
  options.distance_rate = rate_from(reader.group("distance"), options.distance_rate);
  options.state_decimation = decimation_from(reader.group("state"));
  options.completed_decimation = decimation_from(reader.group("completed"));
  reader.read("joint_states_window", options.joint_states_window);
  reader.read("tf_timeout", options.tf_timeout);
  reader.read("read_only", options.read_only);
  reader.read("frame_prefix", options.frame_prefix);
  for (const char* read_elsewhere : {"mechanism", "constraints", "diagnostic_period"})
    reader.raw(read_elsewhere);
  reader.report_unknown_keys();
  return options;
}

NodeSetup load_setup(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh) {
  const std::string prefix = private_nh.getNamespace() + "/";
  XmlRpcValue parameters;
  ros::param::get(private_nh.getNamespace(), parameters);
  Problems problems;
  NodeOptions options = options_from(parameters, prefix, problems);
  try {
    NodeSetup setup{mechanism_from(nh, parameters, prefix, options.frame_prefix), std::move(options)};
    const Manipulator& manipulator = *setup.mechanism->manipulator();
    append(problems_of(setup.options, manipulator, prefix), problems);
    if (setup.options.frame_prefix.empty()) setup.options.frame_prefix = manipulator.name();
    if (problems.empty()) return setup;
  } catch (const InvalidDescription& invalid) {
    append(invalid.problems(), problems);
  }
  throw InvalidDescription(std::move(problems));
}

}  // namespace parallel_aspects
