// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/load_options.h"

#include "ros/parameters/parameter_reader.h"

#include <ros/param.h>
#include <yaml-cpp/yaml.h>

#include <utility>

namespace parallel_aspects {
namespace {

using XmlRpc::XmlRpcValue;

void emit(YAML::Emitter& out, const XmlRpcValue& value);

void emit_list(YAML::Emitter& out, const XmlRpcValue& list) {
  out << YAML::BeginSeq;
  for (int i = 0; i < list.size(); ++i) emit(out, list[i]);
  out << YAML::EndSeq;
}

void emit_struct(YAML::Emitter& out, const XmlRpcValue& members) {
  out << YAML::BeginMap;
  for (const auto& member : members) {
    out << YAML::Key << YAML::DoubleQuoted << member.first << YAML::Value;
    emit(out, member.second);
  }
  out << YAML::EndMap;
}

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
      return emit_list(out, value);
    case XmlRpcValue::TypeStruct:
      return emit_struct(out, value);
    default:
      out << YAML::Null;
  }
}

std::optional<Box> region_from(ParameterReader reader, Problems& problems, const std::string& name) {
  std::vector<double> lower, upper;
  reader.read_all("lower", lower, "upper", upper);
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
  reader.read("complete", map.complete);
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
  reader.read_all("pose", start.pose, "determinant_sign", start.determinant_sign, "tolerance",
                  start.tolerance);
  return start;
}

DisplayOptions display_options_from(ParameterReader reader) {
  DisplayOptions display;
  reader.read_all("gallery", display.gallery, "gallery_scale", display.gallery_scale, "radius",
                  display.radius, "rate", display.rate);
  return display;
}

TrackerOptions tracker_options_from(ParameterReader reader, double joint_states_timeout) {
  TrackerOptions tracking;
  // A timeout that makes no sense is refused under its own name alone.
  if (joint_states_timeout > 0.0) tracking.samples.longest_interval = joint_states_timeout;
  reader.read_all("hysteresis", tracking.hysteresis, "check_velocity", tracking.samples.check_velocity,
                  "velocity_tolerance", tracking.samples.velocity_tolerance, "encoder_noise",
                  tracking.samples.encoder_noise, "path_bend", tracking.samples.path_bend, "longest_interval",
                  tracking.samples.longest_interval, "interval_ratio", tracking.samples.interval_ratio);
  return tracking;
}

PassiveOptions passive_options_from(ParameterReader reader) {
  PassiveOptions passive;
  reader.read_all("angle_tolerance", passive.angle_tolerance, "length_tolerance", passive.length_tolerance,
                  "hysteresis", passive.hysteresis);
  return passive;
}

ThresholdParameters thresholds_from(ParameterReader reader) {
  ThresholdParameters thresholds;
  reader.read_all("parallel_warn", thresholds.parallel_warn, "parallel_stop", thresholds.parallel_stop,
                  "serial_warn", thresholds.serial_warn, "serial_stop", thresholds.serial_stop, "limit_warn",
                  thresholds.limit_warn, "limit_stop", thresholds.limit_stop, "hysteresis",
                  thresholds.hysteresis);
  return thresholds;
}

GuardParameters guard_from(ParameterReader reader) {
  GuardParameters guard;
  reader.read_all("enabled", guard.enabled, "latency", guard.latency, "command_timeout",
                  guard.command_timeout, "sample_age", guard.sample_age, "linear_deceleration",
                  guard.linear_deceleration, "angular_deceleration", guard.angular_deceleration, "recovery",
                  guard.recovery, "reference_point", guard.reference_point);
  return guard;
}

ProbeOptions probe_from(ParameterReader reader) {
  ProbeOptions probe;
  reader.read("enabled", probe.enabled);
  reader.read("rate", probe.rate);
  reader.report_unknown_keys();
  return probe;
}

UniquenessParameters uniqueness_from(ParameterReader reader) {
  UniquenessParameters uniqueness;
  reader.read_all("enabled", uniqueness.enabled, "hold", uniqueness.hold, "most_cells",
                  uniqueness.most_cells);
  return uniqueness;
}

double rate_from(ParameterReader reader, double rate) {
  reader.read_all("rate", rate);
  return rate;
}

int decimation_from(ParameterReader reader) {
  int decimation = 1;
  reader.read_all("decimation", decimation);
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

// What is under `prefix` for the loader: `mechanism`, `constraints` and `motion` where there are some.
NodeSetup setup_from(const ros::NodeHandle& nh, const XmlRpcValue& parameters, const std::string& prefix,
                     NodeOptions options) {
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
  for (const char* part : {"mechanism", "constraints", "motion"})
    if (parameters.hasMember(part)) document[part] = parameters[part];
  const std::string description = yaml_text(document);
  SharedMechanism mechanism =
      load_mechanism(urdf, urdf_name, description, prefix.substr(0, prefix.size() - 1), options.frame_prefix);
  return {std::move(mechanism), std::move(options), urdf, description};
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
  options.guard = guard_from(reader.group("guard"));
  options.probe = probe_from(reader.group("probe"));
  options.uniqueness = uniqueness_from(reader.group("uniqueness"));
  options.distance_rate = rate_from(reader.group("distance"), options.distance_rate);
  options.state_decimation = decimation_from(reader.group("state"));
  options.completed_decimation = decimation_from(reader.group("completed"));
  reader.read("joint_states_window", options.joint_states_window);
  reader.read("tf_timeout", options.tf_timeout);
  reader.read("read_only", options.read_only);
  reader.read("frame_prefix", options.frame_prefix);
  for (const char* read_elsewhere : {"mechanism", "constraints", "motion", "diagnostic_period"})
    reader.raw(read_elsewhere);
  reader.raw("distance_unit");  // set by the node itself, so that it is there when it starts again or reloads
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
    NodeSetup setup = setup_from(nh, parameters, prefix, std::move(options));
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
