// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/node_options.h"

#include "aspects/boxes/box_classifier.h"
#include "aspects/map/empty_map.h"
#include "aspects/map/map_plan.h"
#include "model/message_text.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <cmath>

namespace parallel_aspects {
namespace {

bool positive(double value) { return std::isfinite(value) && value > 0.0; }

bool valid_frame_prefix(const std::string& prefix) {
  return prefix.empty() || (prefix.front() != '/' && prefix.back() != '/' &&
                            prefix.find_first_of(" \t\n") == std::string::npos);
}

// Collects messages of one form: the parameter, what is wrong, what to do.
class Checks {
 public:
  explicit Checks(std::string prefix) : prefix_(std::move(prefix)) {}

  void require(bool holds, const std::string& key, const std::string& message) {
    if (!holds) problems_.push_back("Parameter " + prefix_ + key + " " + message);
  }

  bool empty() const { return problems_.empty(); }
  Problems take() { return std::move(problems_); }

 private:
  std::string prefix_;
  Problems problems_;
};

void check_map(const MapOptions& map, const Manipulator& manipulator, Checks& checks,
               const std::string& group) {
  const TaskSpace space = manipulator.task_space();
  checks.require(
      !map.complete || space != TaskSpace::SE3, group + "complete",
      "is for maps; with six degrees of freedom there is a roadmap in place of one, so leave it out.");
  checks.require(!map.resolution || positive(*map.resolution), group + "resolution",
                 "must be a positive number [m or rad]; leave it out for 1/200 of the robot's size.");
  checks.require(map.threads <= 1024, group + "threads", "must be 0 (one a core) to 1024.");
  checks.require(map.extra_levels >= 0 && map.extra_levels <= 20, group + "extra_levels", "must be 0 to 20.");
  if (!map.region) return;
  const std::size_t positions = directions(space);
  checks.require(positions > 0, group + "region",
                 "is of positions, but every orientation of a robot in SO3 is searched; leave it out.");
  checks.require(
      positions == 0 || map.region->dimension == positions, group + "region",
      "must have " + std::to_string(positions) + " numbers in lower and in upper, one a position [m].");
  for (std::size_t i = 0; i < map.region->dimension; ++i)
    checks.require(std::isfinite(map.region->width(i)) && map.region->width(i) > 0.0, group + "region",
                   "must have finite numbers, each of lower below that of upper; number " +
                       std::to_string(i + 1) + " is not.");
}

// Why there is no map; empty where there is one.
std::string why_no_map(const Manipulator& manipulator, const MapOptions& map) {
  MapPlan plan;
  return make_map_plan(manipulator, map, plan);
}

// Where there is no map without it either, the node does without one.
void check_resolution(MapOptions map, const Manipulator& manipulator, Checks& checks,
                      const std::string& group) {
  if (!map.resolution) return;
  const std::string problem = why_no_map(manipulator, map);
  map.resolution.reset();
  checks.require(problem.empty() || !why_no_map(manipulator, map).empty(), group + "resolution",
                 "gives no map: " + problem);
}

void check_region(const MapOptions& map, const Manipulator& manipulator, Checks& checks,
                  const std::string& group) {
  MapPlan plan;
  if (!map.region || !make_map_plan(manipulator, map, plan).empty()) return;
  const std::string problem = why_out_of_reach(*map.region, plan.classifier->reachable_positions(),
                                               coordinate_names(manipulator.task_space()));
  checks.require(problem.empty(), group + "region", "gives no map: " + problem);
}

void check_workspace(const MapOptions& map, const Manipulator& manipulator, Checks& checks) {
  const ConstraintKinds kinds = manipulator.constraint_kinds();
  const std::size_t workspace = index_of(ConstraintKind::workspace);
  if (!kinds[workspace]) return;
  const std::string problem = why_no_map(manipulator, map);
  if (problem.empty()) return;
  const auto without = manipulator.with_constraints(ConstraintKinds(kinds).reset(workspace));
  checks.require(!why_no_map(*without, map).empty(), "constraints/workspace", "gives no map: " + problem);
}

// What leaves no map shows in its plan alone.
void check_plan(const MapOptions& map, const Manipulator& manipulator, Checks& checks,
                const std::string& group) {
  if (!checks.empty() || manipulator.task_space() == TaskSpace::SE3) return;
  check_resolution(map, manipulator, checks, group);
  check_region(map, manipulator, checks, group);
  check_workspace(map, manipulator, checks);
}

// How far the anchor of a leg that stands at `point` must be moved at least for the leg to reach it [m].
double lack_of_reach(const Leg& leg, const Eigen::Vector3d& point) {
  if (squared_inverse_entry(leg, point) >= 0.0) return 0.0;
  const double q = joint_value(leg, point, 0);
  return std::abs((point - leg.proximal_point(q)).norm() - std::sqrt(leg.squared_distance(q)));
}

// A direct solution within the tolerance needs every anchor where its leg reaches it.
void check_reach(const Pose& pose, double tolerance, const Manipulator& manipulator, Checks& checks) {
  double squared = 0.0, most = 0.0;
  std::string farthest;
  for (const Leg& leg : manipulator.legs()) {
    const double lack = lack_of_reach(leg, pose.transform(leg.anchor));
    squared += lack * lack;
    if (lack > most) farthest = leg.name;
    most = std::max(most, lack);
  }
  const double least = std::sqrt(squared / static_cast<double>(manipulator.leg_count()));
  checks.require(!(least > tolerance), "start/pose",
                 "cannot be reached, nor any pose within start/tolerance, " +
                     distance_text(manipulator, tolerance) + ": to where " + farthest +
                     " can reach its anchor is " + distance_text(manipulator, most) +
                     " away; state where the robot is.");
}

void check_start(const StartOptions& start, const Manipulator& manipulator, Checks& checks) {
  const TaskSpace space = manipulator.task_space();
  checks.require(!(start.pose && start.determinant_sign), "start",
                 "has both pose and determinant_sign; keep the one that is known.");
  checks.require(
      !start.tolerance || positive(*start.tolerance), "start/tolerance",
      "must be a positive number [m, of spherical robots rad]; leave it out for 1/20 of the robot's size.");
  checks.require(!start.determinant_sign || std::abs(*start.determinant_sign) == 1, "start/determinant_sign",
                 "must be 1 or -1.");
  if (!start.pose) return;
  const PoseCoordinates coordinates =
      start.pose->size() <= PoseCoordinates::MaxRowsAtCompileTime
          ? PoseCoordinates(Eigen::Map<const Eigen::VectorXd>(start.pose->data(), start.pose->size()))
          : PoseCoordinates();
  std::string names;
  for (const std::string& name : coordinate_names(space)) names += (names.empty() ? "" : ", ") + name;
  const auto pose = pose_from_coordinates(manipulator.motions(), coordinates);
  checks.require(pose.has_value(), "start/pose", "must be a list of finite numbers [" + names + "].");
  const double tolerance = tolerance_of(start, manipulator);
  if (pose && positive(tolerance)) check_reach(*pose, tolerance, manipulator, checks);
}

bool within(double value, double lowest, double highest) { return value >= lowest && value <= highest; }

void check_display(const DisplayOptions& display, const std::string& group, Checks& checks) {
  checks.require(within(display.gallery_scale, 0.01, 10.0), group + "gallery_scale", "must be 0.01 to 10.");
  checks.require(positive(display.radius), group + "radius", "must be a positive number [m].");
  checks.require(within(display.rate, 0.1, 100.0), group + "rate", "must be 0.1 to 100 [Hz].");
}

void check_thresholds(const ThresholdParameters& given, const std::string& group, Checks& checks) {
  const auto check = [&](const std::string& key, double warn, double stop) {
    checks.require(within(warn, 0.0, 1e6), group + key + "_warn",
                   "must be 0 (none) to 1000000 [m, of spherical robots rad].");
    checks.require(within(stop, 0.0, 1e6), group + key + "_stop",
                   "must be 0 (none) to 1000000 [m, of spherical robots rad].");
    checks.require(!(warn > 0.0 && stop > warn), group + key + "_stop",
                   "must not be above " + key + "_warn, as the robot would stop before it is warned.");
  };
  check("parallel", given.parallel_warn, given.parallel_stop);
  check("serial", given.serial_warn, given.serial_stop);
  check("limit", given.limit_warn, given.limit_stop);
  checks.require(within(given.hysteresis, 0.0, 10.0), group + "hysteresis", "must be 0 to 10.");
}

void check_guard(const GuardParameters& guard, TaskSpace space, Checks& checks) {
  checks.require(within(guard.latency, 0.0, 1.0), "guard/latency", "must be 0 to 1 [s].");
  checks.require(within(guard.command_timeout, 0.001, 1.0), "guard/command_timeout",
                 "must be 0.001 to 1 [s].");
  checks.require(within(guard.sample_age, 0.001, 1.0), "guard/sample_age", "must be 0.001 to 1 [s].");
  checks.require(within(guard.recovery, 0.0, 60.0), "guard/recovery", "must be 0 to 60 [s].");
  const std::vector<double>& point = guard.reference_point;
  checks.require(point.size() == 3 && within(point[0], -1e6, 1e6) && within(point[1], -1e6, 1e6) &&
                     within(point[2], -1e6, 1e6),
                 "guard/reference_point",
                 "must be a list of three numbers of -1000000 to 1000000, in the platform frame [m].");
  if (!guard.enabled) return;
  checks.require(!has_translation(space) || within(guard.linear_deceleration, 1e-6, 1e6),
                 "guard/linear_deceleration",
                 "must be 0.000001 to 1000000 [m/s^2]: what the platform brakes with, at least.");
  checks.require(!has_rotation(space) || within(guard.angular_deceleration, 1e-6, 1e6),
                 "guard/angular_deceleration",
                 "must be 0.000001 to 1000000 [rad/s^2]: what the platform brakes with, at least.");
}

void check_tracking(const TrackerOptions& tracking, const PassiveOptions& passive, Checks& checks) {
  checks.require(within(tracking.hysteresis, 0.0, 0.5), "tracking/hysteresis", "must be 0 to 0.5.");
  checks.require(
      tracking.samples.longest_interval > 0.0, "tracking/longest_interval",
      "must be a positive number [s], or .inf where nothing moves the robot unseen; leave it out for "
      "joint_states_timeout.");
  checks.require(tracking.samples.interval_ratio >= 1.0, "tracking/interval_ratio",
                 "must be 1 or more, or .inf for no limit.");
  checks.require(within(tracking.samples.velocity_tolerance, 0.0, 100.0), "tracking/velocity_tolerance",
                 "must be 0 to 100.");
  checks.require(within(tracking.samples.encoder_noise, 0.0, 1.0), "tracking/encoder_noise",
                 "must be 0 to 1 [rad, or share of the robot's size].");
  checks.require(within(tracking.samples.path_bend, 0.0, 1000.0), "tracking/path_bend", "must be 0 to 1000.");
  checks.require(positive(passive.angle_tolerance), "passive/angle_tolerance", "must be positive [rad].");
  checks.require(positive(passive.length_tolerance), "passive/length_tolerance",
                 "must be positive [share of the robot's size].");
  checks.require(within(passive.hysteresis, 0.0, 1.0), "passive/hysteresis", "must be 0 to 1.");
}

}  // namespace

double tolerance_of(const StartOptions& start, const Manipulator& manipulator) {
  return start.tolerance ? DistanceUnit(manipulator).length_of(*start.tolerance) : manipulator.size() / 20.0;
}

DistanceThresholds::Options thresholds_of(const ThresholdParameters& given, DistanceUnit unit) {
  const auto lengths = [&](double warn, double stop) {
    return ThresholdOptions{unit.length_of(warn), unit.length_of(stop), given.hysteresis};
  };
  return {lengths(given.parallel_warn, given.parallel_stop), lengths(given.serial_warn, given.serial_stop),
          lengths(given.limit_warn, given.limit_stop)};
}

Problems problems_of(const ThresholdParameters& thresholds, const std::string& prefix) {
  Checks checks(prefix);
  check_thresholds(thresholds, "", checks);
  return checks.take();
}

Problems problems_of(const DisplayOptions& display, const std::string& prefix) {
  Checks checks(prefix);
  check_display(display, "", checks);
  return checks.take();
}

Problems problems_of(const MapOptions& options, const Manipulator& manipulator, const std::string& prefix) {
  Checks checks(prefix);
  check_map(options, manipulator, checks, "");
  check_plan(options, manipulator, checks, "");
  return checks.take();
}

Problems problems_of(const NodeOptions& options, const Manipulator& manipulator, const std::string& prefix) {
  Checks checks(prefix);
  check_map(options.map, manipulator, checks, "map/");
  check_plan(options.map, manipulator, checks, "map/");
  checks.require(options.map_file.empty() || options.map_file.front() == '/', "map/file",
                 "must be an absolute path, or empty for none.");
  check_start(options.start, manipulator, checks);
  check_tracking(options.tracking, options.passive, checks);
  check_thresholds(options.thresholds, "thresholds/", checks);
  check_guard(options.guard, manipulator.task_space(), checks);
  checks.require(within(options.distance_rate, 0.1, 1000.0), "distance/rate", "must be 0.1 to 1000 [Hz].");
  checks.require(within(options.joint_states_timeout, 0.001, 3600.0), "joint_states_timeout",
                 "must be a positive number, 0.001 to 3600 [s].");
  checks.require(within(options.joint_states_window, 0.0, 10.0), "joint_states_window",
                 "must be 0 to 10 [s].");
  checks.require(within(options.tf_timeout, 0.0, 60.0), "tf_timeout", "must be 0 to 60 [s].");
  checks.require(within(options.state_decimation, 1, 10000), "state/decimation", "must be 1 to 10000.");
  checks.require(within(options.completed_decimation, 1, 10000), "completed/decimation",
                 "must be 1 to 10000.");
  check_display(options.display, "display/", checks);
  checks.require(within(options.probe.rate, 0.1, 100.0), "probe/rate", "must be 0.1 to 100 [Hz].");
  checks.require(within(options.uniqueness.hold, 0.0, 60.0), "uniqueness/hold", "must be 0 to 60 [s].");
  checks.require(within(options.uniqueness.most_cells.value_or(1000), 1000, 100000000),
                 "uniqueness/most_cells", "must be 1000 to 100000000; leave it out for 250000.");
  checks.require(valid_frame_prefix(options.frame_prefix), "frame_prefix",
                 "must have no space, and no slash at its ends.");
  return checks.take();
}

}  // namespace parallel_aspects
