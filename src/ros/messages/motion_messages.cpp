// SPDX-License-Identifier: BSD-3-Clause
#include "ros/messages/motion_messages.h"

#include "ros/messages/conversions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

std::uint8_t answer_of(SameAspect answer) {
  switch (answer) {
    case SameAspect::yes:
      return PlanPathResult::YES;
    case SameAspect::no:
      return PlanPathResult::NO;
    case SameAspect::unknown:
      break;
  }
  return PlanPathResult::UNKNOWN;
}

std::vector<double> numbers(const JointVector& values) {
  return {values.data(), values.data() + values.size()};
}

}  // namespace

nav_msgs::Path path_message(const Manipulator& manipulator, const PlannedPath& path) {
  nav_msgs::Path message;
  message.header.frame_id = manipulator.base_frame();
  for (const PathPoint& point : path.points) {
    geometry_msgs::PoseStamped pose;
    pose.header = message.header;
    pose.pose = pose_message(platform_in_base(manipulator, point.pose));
    message.poses.push_back(pose);
  }
  return message;
}

trajectory_msgs::JointTrajectory trajectory_message(const Manipulator& manipulator,
                                                    const std::vector<JointWaypoint>& waypoints) {
  trajectory_msgs::JointTrajectory message;
  message.header.frame_id = manipulator.base_frame();
  for (const Leg& leg : manipulator.legs()) message.joint_names.push_back(leg.actuated_joint);
  for (const JointWaypoint& waypoint : waypoints) {
    trajectory_msgs::JointTrajectoryPoint point;
    point.positions = numbers(waypoint.q);
    point.velocities = numbers(waypoint.velocity);
    point.time_from_start.fromNSec(std::llround(waypoint.time * 1e9));
    message.points.push_back(point);
  }
  return message;
}

void write_path(const Manipulator& manipulator, const PlannedPath& path, PlanPathResult& result) {
  result.answer = answer_of(path.answer);
  result.reason = path.message;
  if (!path) return;
  result.path = path_message(manipulator, path);
  for (const PathPoint& point : path.points)
    for (const std::int8_t sign : signs_message(point.mode)) result.working_modes.push_back(sign);
  for (const PathCrossing& crossing : path.crossings) {
    result.crossings.push_back(static_cast<std::uint32_t>(crossing.point));
    result.crossings_behind.push_back(static_cast<std::uint32_t>(crossing.behind));
    result.crossing_legs.push_back(crossing.kind == Crossing::serial ? manipulator.leg(crossing.leg).name
                                                                     : std::string());
  }
  result.length = path.length;
  result.turned = path.turned;
  result.least_index = path.least_index;
  result.least_det_a = path.least_det_a;
}

void write_timing(const Manipulator& manipulator, const TimedPath& timed, PlanPathResult& result) {
  result.timing = timed.message;
  result.seconds = timed.seconds;
  result.trajectory = trajectory_message(manipulator, timed.waypoints);
}

namespace {

using Names = std::vector<std::string>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::uint8_t answer_message(TrajectoryAnswer answer) {
  return answer == TrajectoryAnswer::safe     ? ModeChoice::YES
         : answer == TrajectoryAnswer::unsafe ? ModeChoice::NO
                                              : ModeChoice::UNKNOWN;
}

std::uint8_t answer_message(SameAspect answer) {
  return answer == SameAspect::yes  ? ModeChoice::YES
         : answer == SameAspect::no ? ModeChoice::NO
                                    : ModeChoice::UNKNOWN;
}

geometry_msgs::Pose in_base(const Manipulator& manipulator, const Pose& pose) {
  return pose_message(platform_in_base(manipulator, pose));
}

ModeChoice empty_choice(const WorkingMode& mode, TrajectoryAnswer answer, const std::string& reason) {
  ModeChoice message;
  message.working_mode = signs_message(mode);
  message.answer = answer_message(answer);
  message.reason = reason;
  message.violation_after = message.violation_before = none;
  message.clearance = message.clearance_time = message.least_time = message.least_index = none;
  return message;
}

ModeChoice choice_message(const ModeOnPath& mode) {
  ModeChoice message = empty_choice(mode.mode, mode.check.answer, mode.check.reason);
  message.determinant_sign = static_cast<std::int8_t>(mode.determinant_sign);
  message.aspect = static_cast<std::uint32_t>(mode.aspect);
  message.free_until = mode.check.free_until;
  if (mode.check.violation) {
    message.violation_after = mode.check.violation->after;
    message.violation_before = mode.check.violation->before;
  }
  if (!mode.clearance) return message;
  message.clearance = mode.clearance->lower;
  message.clearance_time = mode.clearance->time;
  message.travel = mode.travel;
  message.least_time = mode.least_time;
  return message;
}

ModeChoice choice_message(const Manipulator& manipulator, const ModeInRegion& mode) {
  ModeChoice message = empty_choice(mode.mode, mode.answer, mode.reason);
  message.determinant_sign = static_cast<std::int8_t>(mode.determinant_sign);
  message.undecided = mode.undecided;
  if (mode.answer == TrajectoryAnswer::safe) message.least_index = mode.least_index.lower;
  for (const Pose& witness : mode.witnesses) message.witnesses.push_back(in_base(manipulator, witness));
  return message;
}

ChangeOfPosture change_message(const Manipulator& manipulator, const PostureChange& change) {
  ChangeOfPosture message;
  message.time = change.time;
  message.pose = in_base(manipulator, change.pose);
  message.singular_pose = in_base(manipulator, change.singular);
  message.leg = manipulator.leg(change.leg).name;
  message.from_mode = signs_message(change.from);
  message.to_mode = signs_message(change.to);
  message.detour = change.detour;
  return message;
}

std::uint8_t kind_of(Violation violation) {
  switch (violation) {
    case Violation::out_of_reach:
      return TrajectoryEvent::SERIAL_SINGULARITY;
    case Violation::joint_limit:
      return TrajectoryEvent::ACTUATED_LIMIT;
    case Violation::constraint:
      return TrajectoryEvent::CONSTRAINT;
    case Violation::singularity:
    case Violation::none:
      break;
  }
  return TrajectoryEvent::PARALLEL_SINGULARITY;
}

std::string name_of(const Manipulator& manipulator, const std::optional<std::size_t>& leg) {
  return leg ? manipulator.leg(*leg).name : "";
}

TrajectoryEvent event_of(const Manipulator& manipulator, const TrajectoryViolation& violation) {
  TrajectoryEvent event;
  event.kind = kind_of(violation.kind);
  event.leg = name_of(manipulator, violation.leg);
  if (violation.constraint) event.constraint = name(*violation.constraint);
  event.after = violation.after;
  event.before = violation.before;
  return event;
}

TrajectoryEvent event_of(const Manipulator& manipulator, const TrajectoryCrossing& crossing) {
  TrajectoryEvent event;
  event.kind = kind_of(crossing.kind);
  event.leg = name_of(manipulator, crossing.leg);
  event.after = crossing.after;
  event.before = crossing.before;
  if (crossing.mode) event.working_mode = signs_message(*crossing.mode);
  event.determinant_sign = static_cast<std::int8_t>(crossing.determinant_sign);
  return event;
}

void fill_values(const Manipulator& manipulator, const ask::CheckAnswer& answer,
                 CheckTrajectory::Response& response) {
  const TrajectoryCheck& check = answer.check;
  response.least_parallel_index = check.parallel_index.value;
  response.least_parallel_index_time = check.parallel_index.time;
  response.least_serial_index = check.serial_index.value;
  response.least_serial_index_time = check.serial_index.time;
  response.least_serial_index_leg = name_of(manipulator, check.serial_index.leg);
  for (const ask::JointSpeed& each : answer.speeds) {
    response.joint_names.push_back(each.joint);
    response.fastest.push_back(each.speed.value);
    response.never_faster.push_back(each.speed.bound);
    response.velocity_limits.push_back(each.limit);
  }
}

void fill_distances(const ask::CheckAnswer& answer, CheckTrajectory::Response& response) {
  for (std::size_t i = 0; i < answer.distances.size(); ++i) {
    const SampleDistances& distances = answer.distances[i];
    if (!distances.measured) continue;
    response.distance_times.push_back(answer.check.samples[i].time);
    response.parallel_distances.push_back(distances.lower[0]);
    response.serial_distances.push_back(distances.lower[1]);
    response.limit_distances.push_back(distances.lower[2]);
  }
  for (const auto& least : answer.least_distance().value_or(ask::NamedValues()))
    response.least_distances.push_back(least.second);
}

}  // namespace

void write_check(const Manipulator& manipulator, const ask::CheckAnswer& answer,
                 CheckTrajectory::Response& response) {
  const TrajectoryCheck& check = answer.check;
  response.answer = check.answer == TrajectoryAnswer::safe     ? CheckTrajectory::Response::YES
                    : check.answer == TrajectoryAnswer::unsafe ? CheckTrajectory::Response::NO
                                                               : CheckTrajectory::Response::UNKNOWN;
  response.reason = check.reason;
  response.free_until = check.free_until;
  response.followed_until = check.followed_until;
  response.not_followed = check.not_followed;
  if (check.violation) response.first_violation.push_back(event_of(manipulator, *check.violation));
  for (const TrajectoryCrossing& crossing : check.crossings)
    response.crossings.push_back(event_of(manipulator, crossing));
  fill_values(manipulator, answer, response);
  fill_distances(answer, response);
}

Status read_region(const Manipulator& manipulator, const ChooseWorkingMode::Request& request,
                   ask::ChooseQuestion& question) {
  const Names& names = request.coordinates;
  if (names.empty() || request.lower.size() != names.size() || request.upper.size() != names.size())
    return invalid_request("coordinates, lower and upper must have as many entries each, one or more.");
  std::vector<HeldCoordinate> held;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (request.lower[i] == request.upper[i])
      held.push_back({names[i], request.lower[i]});
    else
      question.region.push_back({names[i], request.lower[i], request.upper[i]});
  Problems problems;
  if (!held.empty()) question.hold = make_slice(manipulator, held, problems);
  return problems.empty() ? Status() : invalid_request(problems.front());
}

void write_choice(const Manipulator& manipulator, const ask::ChooseAnswer& answer,
                  ChooseWorkingMode::Response& response) {
  response.answer = answer_message(answer.verdict());
  response.reason = answer.reason();
  for (const ModeOnPath& mode : answer.path.modes) response.modes.push_back(choice_message(mode));
  for (const ModeInRegion& mode : answer.region.modes)
    response.modes.push_back(choice_message(manipulator, mode));
  for (const Pose& pose : answer.apart().value_or(std::vector<Pose>()))
    response.apart.push_back(in_base(manipulator, pose));
  if (!answer.with_changes) return;
  const ChangingPath& path = *answer.with_changes;
  response.answer_with_changes = answer_message(path.answer);
  response.reason_with_changes = path.reason;
  if (!path.pieces.empty()) response.first_mode = signs_message(path.pieces.front().mode);
  for (const PostureChange& change : path.changes)
    response.posture_changes.push_back(change_message(manipulator, change));
}

ModeConnection connection_message(const Manipulator& manipulator, const ask::ConnectionInMode& connection) {
  ModeConnection message;
  message.working_mode = signs_message(connection.mode);
  message.answer = answer_message(connection.comparison.answer);
  message.reason = connection.comparison.message;
  for (const Pose& pose : connection.comparison.path) message.path.push_back(in_base(manipulator, pose));
  message.clearance = connection.clearance ? connection.clearance->lower : none;
  message.narrowest = in_base(manipulator, connection.narrowest.value_or(Pose()));
  return message;
}

}  // namespace parallel_aspects
