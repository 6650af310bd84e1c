// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/check_queries.h"

#include "model/number_text.h"
#include "model/spherical_links.h"
#include "parallel_aspects/kinematics/jacobians.h"
#include "parallel_aspects/model/anchor_distance.h"
#include "parallel_aspects/motion/check_trajectory.h"
#include "ros/joint_states/joint_sample.h"
#include "urdf/description/nearest_name.h"

#include <algorithm>
#include <array>
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

void fill_values(const Manipulator& manipulator, const TrajectoryCheck& check,
                 CheckTrajectory::Response& response) {
  response.least_parallel_index = check.parallel_index.value;
  response.least_parallel_index_time = check.parallel_index.time;
  response.least_serial_index = check.serial_index.value;
  response.least_serial_index_time = check.serial_index.time;
  response.least_serial_index_leg = manipulator.leg(check.serial_index.leg).name;
  for (std::size_t j = 0; j < check.speeds.size(); ++j) {
    response.joint_names.push_back(manipulator.leg(j).actuated_joint);
    response.fastest.push_back(check.speeds[j].value);
    response.never_faster.push_back(check.speeds[j].bound);
    response.velocity_limits.push_back(manipulator.leg(j).limits.velocity);
  }
}

CheckTrajectory::Response response_of(const Manipulator& manipulator, const TrajectoryCheck& check) {
  CheckTrajectory::Response response;
  response.status = make_status(Status::OK);
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
  fill_values(manipulator, check, response);
  return response;
}

// Empty where the message has none.
JointVector values_of(const Manipulator& manipulator, const std::vector<std::string>& names,
                      const std::vector<double>& values, const std::string& which, Status& status) {
  if (values.empty() || status.code != Status::OK) return {};
  const JointSample sample = actuated_values(manipulator, names, values);
  if (sample.status == SampleStatus::usable) return sample.q;
  status = invalid_request(which + " cannot be used: " + sample.message);
  return {};
}

/// As the command has it: what is not an actuated joint is not followed.
std::string unknown_joint(const Manipulator& manipulator, const std::vector<std::string>& names) {
  std::vector<std::string> actuated;
  for (const Leg& leg : manipulator.legs()) actuated.push_back(leg.actuated_joint);
  for (const std::string& name : names)
    if (!contains(actuated, name))
      return "The trajectory has the unknown joint '" + name + "'" + suggestion(name, actuated, {});
  return "";
}

/// The fields that state one of the starts each.
std::string start_fields(const Manipulator& manipulator, const std::vector<PossibleStart>& starts) {
  std::string text;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const int sign = telling_sign(starts, i);
    text += (i == 0 ? " Give start.kind 1 with start.pose at " : ", or at ") +
            to_string(manipulator.task_space(), starts[i].pose);
    if (sign != 0) text += " (the same as start.kind 2 with determinant_sign " + std::to_string(sign) + ")";
  }
  return text + (starts.empty() ? "" : "; poses in the task frame.");
}

void fill_distances(const TrajectoryCheck& check, const std::vector<SampleDistances>& distances,
                    CheckTrajectory::Response& response) {
  if (distances.empty()) return;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (!distances[i].measured) continue;
    response.distance_times.push_back(check.samples[i].time);
    response.parallel_distances.push_back(distances[i].lower[0]);
    response.serial_distances.push_back(distances[i].lower[1]);
    response.limit_distances.push_back(distances[i].lower[2]);
  }
  const std::array<double, 3> least = least_distances(check, distances);
  response.least_distances.assign(least.begin(), least.end());
}

std::string first_of(const Problems& problems) { return problems.empty() ? "" : problems.front(); }

}  // namespace

CheckQueries::CheckQueries(std::shared_ptr<const Manipulator> manipulator, const RobotMonitor& monitor,
                           PoseTransformer to_base)
    : manipulator_(std::move(manipulator)),
      certifier_(manipulator_),
      monitor_(monitor),
      to_base_(std::move(to_base)) {}

CheckTrajectory::Response CheckQueries::answer(const CheckTrajectory::Request& request) const {
  Question question = read(request);
  CheckTrajectory::Response response;
  if (question.status.code == Status::OK) {
    const TrajectoryCheck result = check(question);
    response = response_of(*manipulator_, result);
    response.status.message = question.status.message;
    if (!result.refused) {
      fill_distances(result, distances_on(manipulator_, result, question.distances), response);
      return response;
    }
    question.status = invalid_request(result.reason + start_fields(*manipulator_, result.possible_starts));
  }
  response = {};
  response.status = question.status;
  response.reason = question.status.message;
  return response;
}

TrajectoryCheck CheckQueries::check(const Question& question) const {
  return question.poses.empty()
             ? check_trajectory(certifier_, question.joints, question.start, question.options)
             : check_trajectory(certifier_, question.poses, question.mode, question.options);
}

CheckQueries::Question CheckQueries::read(const CheckTrajectory::Request& request) const {
  Question question;
  question.status = make_status(Status::OK);
  question.options.pass_serial = request.pass_serial;
  question.options.keep_samples = request.distances > 0;
  question.distances = request.distances;
  const bool has_joints = !request.trajectory.points.empty(), has_poses = !request.poses.empty();
  if (has_joints == has_poses)
    question.status =
        invalid_request("Give one of trajectory, with points of the actuated joints, and poses.");
  else if (request.distances > most_distances)
    question.status = invalid_request("distances is " + std::to_string(request.distances) +
                                      "; give a number of times up to 1000.");
  else if (request.start.kind > Configuration::JOINTS)
    question.status = invalid_request("start.kind is none of NOW, POSE and JOINTS; give one of them.");
  else if (!request.start.joint_names.empty() || !request.start.joint_positions.empty())
    question.status =
        invalid_request("start has joint values, but the trajectory tells them; leave them out.");
  else if (has_poses && request.pass_serial)
    question.status =
        invalid_request("pass_serial is for actuated joints, since poses end at B_jj = 0; leave it out.");
  else if (has_joints)
    read_joints(request, question);
  else
    read_poses(request, question);
  if (question.status.code != Status::OK) return question;
  return question;
}

void CheckQueries::read_joints(const CheckTrajectory::Request& request, Question& question) const {
  const trajectory_msgs::JointTrajectory& message = request.trajectory;
  const std::string unknown = unknown_joint(*manipulator_, message.joint_names);
  if (!unknown.empty()) question.status = invalid_request(unknown);
  for (std::size_t i = 0; i < message.points.size() && unknown.empty(); ++i) {
    const trajectory_msgs::JointTrajectoryPoint& point = message.points[i];
    const std::string which = "Waypoint " + std::to_string(i + 1);
    const auto read = [&](const std::vector<double>& values) {
      return values_of(*manipulator_, message.joint_names, values, which, question.status);
    };
    question.joints.push_back({point.time_from_start.toSec(), read(point.positions), read(point.velocities),
                               read(point.accelerations)});
    if (question.status.code != Status::OK) return;
  }
  if (question.status.code != Status::OK) return;
  const std::string problem = first_of(problems_of(*manipulator_, question.joints, {}));
  if (!problem.empty())
    question.status = invalid_request(problem);
  else if (request.start.kind == Configuration::NOW)
    start_joints_now(question);
  else if (request.start.kind == Configuration::POSE)
    question.status =
        read_pose(*manipulator_, to_base_, request.start.pose, "start.pose", question.start.pose.emplace());
  else
    question.start.determinant_sign = request.start.determinant_sign;
}

void CheckQueries::start_joints_now(Question& question) const {
  const CurrentConfiguration current = monitor_.current(ros::Time::now());
  question.status = current.status;
  if (current.status.code != Status::OK) return;
  question.start.pose = current.solved.pose;
  for (std::size_t j = 0; j < manipulator_->leg_count(); ++j) {
    const Leg& leg = manipulator_->leg(j);
    const auto k = static_cast<Eigen::Index>(j);
    const double off = std::abs(question.joints.front().q[k] - current.solved.q[k]);
    if (!is_near_start(*manipulator_, j, off))
      question.status = invalid_request("The trajectory does not start where the robot is: joint '" +
                                        leg.actuated_joint + "' is at " + number_text(current.solved.q[k]) +
                                        (leg.actuated_by_angle() ? " rad, " : " m, ") + number_text(off) +
                                        " off; start it there, or state another start.");
  }
}

void CheckQueries::read_poses(const CheckTrajectory::Request& request, Question& question) const {
  if (request.times.size() != request.poses.size()) {
    question.status = invalid_request("There are " + std::to_string(request.poses.size()) + " poses but " +
                                      std::to_string(request.times.size()) + " times; give one for each.");
    return;
  }
  for (std::size_t i = 0; i < request.poses.size(); ++i) {
    Pose pose;
    const Status read =
        read_pose(*manipulator_, to_base_, request.poses[i], "Pose " + std::to_string(i + 1), pose);
    if (read.code != Status::OK || question.status.message.empty()) question.status = read;
    if (read.code != Status::OK) return;
    question.poses.push_back({request.times[i], pose});
  }
  if (request.start.kind == Configuration::NOW) return start_poses_now(question);
  const std::vector<int> signs(request.start.working_mode.begin(), request.start.working_mode.end());
  const auto mode = WorkingMode::from_signs(signs);
  if (request.start.kind == Configuration::POSE)
    question.status =
        invalid_request("start.kind is POSE, but the poses tell where it starts; give NOW or JOINTS.");
  else if (!mode || mode->leg_count() != manipulator_->leg_count())
    question.status = invalid_request("start.working_mode needs a sign for each leg, 1 or -1.");
  else
    question.mode = *mode;
}

void CheckQueries::start_poses_now(Question& question) const {
  const CurrentConfiguration current = monitor_.current(ros::Time::now());
  question.status = current.status;
  if (current.status.code != Status::OK) return;
  const double off = anchor_distance(*manipulator_, current.solved.pose, question.poses.front().pose);
  const auto mode = working_mode(*manipulator_, current.solved.pose, current.solved.q);
  if (!(off <= start_tolerance * manipulator_->size()))
    question.status =
        invalid_request("The poses do not start where the robot is: the first is " +
                        distance_text(*manipulator_, off) + " off; start there, or state another start.");
  else if (!mode)
    question.status =
        invalid_request("A leg of the robot is stretched or folded now; move it out of B_jj = 0.");
  else
    question.mode = *mode;
}

}  // namespace parallel_aspects
