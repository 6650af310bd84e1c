// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/check_queries.h"

#include "ask/question_parts.h"
#include "model/message_text.h"
#include "model/spherical_links.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t most_distances = 1000;  // each takes up to some milliseconds

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

/// As the fields of a request.
std::string field_of_check(const std::string& field) {
  if (field == "path") return "poses";
  if (field == "mode") return "start.working_mode";
  if (field == "policy") return "pass_serial";
  if (field == "start_pose") return "start.kind 1 with start.pose, in the task frame,";
  if (field.rfind("start_sign", 0) != 0) return field;
  return "start.kind 2 with determinant_sign" + std::string(field.back() == '+'   ? " 1"
                                                            : field.back() == '-' ? " -1"
                                                                                  : "");
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

}  // namespace

CheckQueries::CheckQueries(std::shared_ptr<const Manipulator> manipulator, const RobotMonitor& monitor,
                           PoseTransformer to_base)
    : manipulator_(std::move(manipulator)), monitor_(monitor), to_base_(std::move(to_base)) {}

CheckTrajectory::Response CheckQueries::answer(const CheckTrajectory::Request& request) const {
  CheckTrajectory::Response response;
  ask::CheckQuestion question;
  response.status = read(request, question);
  if (response.status.code == Status::OK) {
    ask::Session session(manipulator_);  // for one thread at a time, so that long questions do not wait
    const auto outcome = ask::answer(session, question);
    if (outcome)
      write_check(*manipulator_, outcome.answer, response);
    else
      response.status = invalid_request(text_of(outcome.problems.front(), field_of_check));
  }
  if (response.status.code != Status::OK) response.reason = response.status.message;
  return response;
}

Status CheckQueries::read(const CheckTrajectory::Request& request, ask::CheckQuestion& question) const {
  const bool has_joints = !request.trajectory.points.empty(), has_poses = !request.poses.empty();
  if (request.distances > most_distances)
    return invalid_request("distances is " + std::to_string(request.distances) +
                           "; give a number of times up to " + std::to_string(most_distances) + ".");
  if (request.start.kind > Configuration::JOINTS)
    return invalid_request("start.kind is none of NOW, POSE and JOINTS; give one of them.");
  if (!request.start.joint_names.empty() || !request.start.joint_positions.empty())
    return invalid_request("start has joint values, but the trajectory tells them; leave them out.");
  if (request.pass_serial) question.policy = ask::CheckPolicy::serial;
  if (request.distances > 0) question.distances.emplace().value = request.distances;
  if (has_joints != has_poses)
    return has_joints ? read_joints(request, question) : read_poses(request, question);
  if (has_joints) {  // is refused unread
    question.trajectory.emplace();
    question.path.emplace();
  }
  return {};
}

Status CheckQueries::read_joints(const CheckTrajectory::Request& request,
                                 ask::CheckQuestion& question) const {
  Problems problems;
  const ask::JointColumns columns(*manipulator_, request.trajectory.joint_names, "trajectory", problems);
  std::vector<JointWaypoint>& waypoints = question.trajectory.emplace();
  for (const trajectory_msgs::JointTrajectoryPoint& point : request.trajectory.points) {
    const auto ordered = [&](const std::vector<double>& values, const char* field) {
      const std::string where = "points[" + std::to_string(waypoints.size()) + "]." + field;
      return problems.empty() ? columns.ordered(values, where, problems) : JointVector();
    };
    waypoints.push_back({point.time_from_start.toSec(), ordered(point.positions, "positions"),
                         ordered(point.velocities, "velocities"),
                         ordered(point.accelerations, "accelerations")});
  }
  if (!problems.empty()) return invalid_request(problems.front());
  if (request.start.kind == Configuration::NOW) return start_joints_now(question);
  if (request.start.kind == Configuration::POSE)
    return read_pose(*manipulator_, to_base_, request.start.pose, "start.pose",
                     question.start_pose.emplace());
  const int sign = request.start.determinant_sign;
  if (sign != 0) question.start_sign = sign > 0 ? ask::Sign::plus : ask::Sign::minus;
  return {};
}

Status CheckQueries::start_joints_now(ask::CheckQuestion& question) const {
  const CurrentConfiguration current = monitor_.current(ros::Time::now());
  if (current.status.code != Status::OK) return current.status;
  question.start_pose = current.solved.pose;
  const JointVector& first = question.trajectory->front().q;
  for (Eigen::Index k = 0; k < first.size(); ++k) {
    const auto j = static_cast<std::size_t>(k);
    const Leg& leg = manipulator_->leg(j);
    const double off = std::abs(first[k] - current.solved.q[k]);
    if (!is_near_start(*manipulator_, j, off))
      return invalid_request("The trajectory does not start where the robot is: joint '" +
                             leg.actuated_joint + "' is at " + number_text(current.solved.q[k]) +
                             (leg.actuated_by_angle() ? " rad, " : " m, ") + number_text(off) +
                             " off; start it there, or state another start.");
  }
  return current.status;
}

Status CheckQueries::read_poses(const CheckTrajectory::Request& request, ask::CheckQuestion& question) const {
  if (request.times.size() != request.poses.size())
    return invalid_request("There are " + std::to_string(request.poses.size()) + " poses but " +
                           std::to_string(request.times.size()) + " times; give one for each.");
  if (request.start.kind == Configuration::POSE)
    return invalid_request("start.kind is POSE, but the poses tell where it starts; give NOW or JOINTS.");
  const Status status =
      read_waypoints(*manipulator_, to_base_, request.poses, request.times, question.path.emplace());
  if (status.code != Status::OK) return status;
  if (request.start.kind == Configuration::NOW) return start_poses_now(question);
  question.mode =
      WorkingMode::from_signs({request.start.working_mode.begin(), request.start.working_mode.end()});
  return status;
}

Status CheckQueries::start_poses_now(ask::CheckQuestion& question) const {
  const CurrentConfiguration current = monitor_.current(ros::Time::now());
  if (current.status.code != Status::OK) return current.status;
  const double off = anchor_distance(*manipulator_, current.solved.pose, question.path->front().pose);
  if (!(off <= start_tolerance * manipulator_->size()))
    return invalid_request("The poses do not start where the robot is: the first is " +
                           distance_text(*manipulator_, off) + " off; start there, or state another start.");
  question.mode = working_mode(*manipulator_, current.solved.pose, current.solved.q);
  if (!question.mode)
    return invalid_request("A leg of the robot is stretched or folded now; move it out of B_jj = 0.");
  return current.status;
}

}  // namespace parallel_aspects
