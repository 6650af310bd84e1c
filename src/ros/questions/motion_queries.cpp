// SPDX-License-Identifier: BSD-3-Clause
#include "ros/questions/motion_queries.h"

#include "ask/question_parts.h"
#include "model/message_text.h"
#include "model/spherical_links.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "ros/messages/configurations.h"
#include "ros/messages/motion_messages.h"
#include "ros/questions/plan_question.h"

#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t most_distances = 1000;  // each takes up to some milliseconds

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

/// What belongs to the other kind of question; empty where nothing does.
std::string foreign_field(const ChooseWorkingMode::Request& request) {
  if (request.kind == ChooseWorkingMode::Request::PATH) {
    if (!request.coordinates.empty() || !request.lower.empty() || !request.upper.empty())
      return "A path has no ranges; leave coordinates, lower and upper empty, or ask with kind 1 (region).";
    return "";
  }
  if (!request.poses.empty() || !request.times.empty() || !request.prefer.empty() || request.changes)
    return "A region has no path; leave poses, times, prefer and changes empty, or ask with kind 0 (path).";
  return "";
}

}  // namespace

MotionQueries::MotionQueries(std::shared_ptr<const Manipulator> manipulator, const RobotMonitor& monitor,
                             const MapWorker& worker, PoseTransformer to_base)
    : manipulator_(std::move(manipulator)),
      monitor_(monitor),
      worker_(worker),
      to_base_(std::move(to_base)),
      session_(manipulator_) {}

CheckTrajectory::Response MotionQueries::answer(const CheckTrajectory::Request& request) const {
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

Status MotionQueries::read(const CheckTrajectory::Request& request, ask::CheckQuestion& question) const {
  const bool has_joints = !request.trajectory.points.empty(), has_poses = !request.poses.empty();
  if (request.distances > most_distances)
    return invalid_request("distances is " + std::to_string(request.distances) +
                           "; give a number of times up to " + std::to_string(most_distances) + ".");
  if (request.start.kind > Configuration::JOINTS)
    return invalid_request("start.kind is none of NOW, POSE and JOINTS; give one of them.");
  if (!request.start.joint_names.empty() || !request.start.joint_positions.empty())
    return invalid_request("start has joint values, but the trajectory states them; leave them out.");
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

Status MotionQueries::read_joints(const CheckTrajectory::Request& request,
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

Status MotionQueries::start_joints_now(ask::CheckQuestion& question) const {
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

Status MotionQueries::read_poses(const CheckTrajectory::Request& request,
                                 ask::CheckQuestion& question) const {
  if (request.times.size() != request.poses.size())
    return invalid_request("There are " + std::to_string(request.poses.size()) + " poses but " +
                           std::to_string(request.times.size()) + " times; give one for each.");
  if (request.start.kind == Configuration::POSE)
    return invalid_request("start.kind is POSE, but the poses state where it starts; give NOW or JOINTS.");
  const Status status =
      read_waypoints(*manipulator_, to_base_, request.poses, request.times, question.path.emplace());
  if (status.code != Status::OK) return status;
  if (request.start.kind == Configuration::NOW) return start_poses_now(question);
  question.mode = stated_mode(request.start.working_mode);
  return status;
}

Status MotionQueries::start_poses_now(ask::CheckQuestion& question) const {
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

ChooseWorkingMode::Response MotionQueries::answer(const ChooseWorkingMode::Request& request) const {
  ChooseWorkingMode::Response response;
  response.answer = response.answer_with_changes = ModeChoice::UNKNOWN;
  const std::string foreign = foreign_field(request);
  if (request.kind > ChooseWorkingMode::Request::REGION)
    response.status = invalid_request("kind must be 0 (path) or 1 (region).");
  else if (!foreign.empty())
    response.status = invalid_request(foreign);
  else
    response.status = choose(request, response);
  return response;
}

Status MotionQueries::choose(const ChooseWorkingMode::Request& request,
                             ChooseWorkingMode::Response& response) const {
  ask::ChooseQuestion question;
  question.brief = true;
  question.changes = request.changes;
  std::string names;
  if (!request.prefer.empty() && !(question.prefer = ask::choice_named<Preference>(request.prefer, names)))
    return invalid_request("prefer must be " + names + ", or empty for clear.");
  Status status;
  if (request.kind == ChooseWorkingMode::Request::PATH)
    status = read_path(request, question.path.emplace());
  else
    status = read_region(*manipulator_, request, question);
  if (status.code != Status::OK) return status;
  ask::Session session(manipulator_);  // for one thread at a time, so that long questions do not wait
  session.know(worker_.map());
  const auto outcome = ask::answer(session, question);
  const auto field_of_request = [](const std::string& field) {
    return field == "region" ? std::string("The region") : field;
  };
  if (!outcome) return invalid_request(text_of(outcome.problems.front(), field_of_request));
  write_choice(*manipulator_, outcome.answer, response);
  return status;
}

Status MotionQueries::read_path(const ChooseWorkingMode::Request& request,
                                std::vector<PoseWaypoint>& waypoints) const {
  if (!request.times.empty() && request.times.size() != request.poses.size())
    return invalid_request("times must be empty, or have an entry for each of poses.");
  std::vector<geometry_msgs::PoseStamped> poses(request.poses.size());
  std::vector<double> times = request.times;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    poses[i].header = request.header;
    poses[i].pose = request.poses[i];
    if (request.times.empty()) times.push_back(static_cast<double>(i));
  }
  return read_waypoints(*manipulator_, to_base_, poses, times, waypoints);
}

// One roadmap for all questions, so that the same question gets the same answer.
ask::Outcome<ask::ConnectAnswer> MotionQueries::connect(const ask::ConnectQuestion& question) const {
  const std::lock_guard<std::mutex> lock(session_mutex_);
  session_.know(worker_.map());
  if (const auto known = worker_.known().roadmap) session_.know(known);
  ask::ProblemList problems;
  if (const auto roadmap = session_.roadmap({}, {}, problems)) session_.know(roadmap);
  if (!problems.empty()) return {MapStatus::refused, std::move(problems), {}};
  return ask::answer(session_, question);
}

Connect::Response MotionQueries::answer(const Connect::Request& request) const {
  Connect::Response response;
  ask::ConnectQuestion question;
  question.brief = true;
  question.mode = stated_mode(request.working_mode);
  if (!is_mode_of(*manipulator_, request.working_mode)) {
    response.status =
        invalid_request("working_mode must have a sign, 1 or -1, for each leg that has two, or be empty.");
    return response;
  }
  response.status = read_pose(*manipulator_, to_base_, request.start, "start", question.start.emplace());
  if (response.status.code != Status::OK) return response;
  const Status read = read_pose(*manipulator_, to_base_, request.goal, "goal", question.goal.emplace());
  if (read.code != Status::OK || response.status.message.empty()) response.status = read;
  if (read.code != Status::OK) return response;
  const auto outcome = connect(question);
  if (!outcome) response.status = refused(outcome.problems);
  for (const ask::ConnectionInMode& each : outcome.answer.answers)
    response.answers.push_back(connection_message(*manipulator_, each));
  return response;
}

}  // namespace parallel_aspects
