// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/plan_server.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/messages/configurations.h"
#include "ros/messages/conversions.h"
#include "ros/pictures/answer_pictures.h"
#include "ros/pictures/marker_batch.h"
#include "ros/questions/plan_question.h"

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

bool is_ok(const Status& status) { return status.code == Status::OK; }

Status read_margin(const PlanPathGoal& goal, bool mapped, double& margin) {
  margin = goal.parallel_margin;
  if (!(margin >= 0.0 && margin < 1.0))
    return invalid_request("parallel_margin must be a number from 0 to below 1; give 0 for none.");
  if (!mapped && margin > 0.0)
    return invalid_request(
        "parallel_margin needs a map, and with six degrees of freedom there is none; give 0.");
  return {};
}

}  // namespace

PlanServer::PlanServer(const ros::NodeHandle& nh, const NodeSetup& setup, const RobotMonitor& monitor,
                       const MapWorker& worker, PoseTransformer to_base)
    : setup_(setup),
      manipulator_(setup.mechanism->mapped_manipulator()),
      monitor_(monitor),
      worker_(worker),
      to_base_(std::move(to_base)),
      goals_(nh, "plan_path") {
  ros::NodeHandle handle = nh;
  path_ = handle.advertise<nav_msgs::Path>("planned_path", 1, true);
  trajectory_ = handle.advertise<trajectory_msgs::JointTrajectory>("planned_trajectory", 1, true);
  markers_ = handle.advertise<visualization_msgs::MarkerArray>("planned_path_markers", 1, true);
  markers_.publish(MarkerBatch().take());  // removes what a node before this one left in rviz
  server_ = std::make_unique<Server>(
      goals_.server_handle(), "plan_path", [this](const PlanPathGoalConstPtr& goal) { on_goal(goal); },
      false);
  server_->registerPreemptCallback([this] { cancelled_ = true; });
  server_->start();
}

void PlanServer::shutdown() {
  stopping_ = true;
  cancelled_ = true;
  server_->shutdown();
}

ask::Acceleration PlanServer::acceleration_for(const PlanPathGoal& goal) const {
  if (goal.path_only) return {};
  return {setup_.mechanism->acceleration(), "set the parameter ~motion/acceleration and reload",
          goal.prefer == PlanPathGoal::FAST ? "" : "ask with path_only"};
}

void PlanServer::on_goal(const PlanPathGoalConstPtr& goal) {
  cancelled_ = false;
  if (stopping_ || server_->isPreemptRequested()) cancelled_ = true;
  PlanPathResult result;
  Question question;
  result.status = read(*goal, question);
  result.reason = result.status.message;
  if (is_ok(result.status)) {
    ask::Session& session = session_for(question);
    session.set_acceleration(acceleration_for(*goal));
    return finish(ask::answer(session, question.asked, control()), question, result);
  }
  std::this_thread::sleep_for(before_refusal);
  server_->setAborted(result, result.status.message);
}

Status PlanServer::read(const PlanPathGoal& goal, Question& question) const {
  question.stay_in_domain = goal.stay_in_domain;
  Status status = read_ends(goal, question);
  if (is_ok(status)) status = read_wish(*manipulator_, goal, question.asked);
  const bool mapped = has_map(manipulator_->task_space()) || question.asked.map.hold;
  if (is_ok(status)) status = read_margin(goal, mapped, question.margin);
  if (is_ok(status)) status = read_map(question);
  return status;
}

Status PlanServer::read_ends(const PlanPathGoal& goal, Question& question) const {
  Status status = read_end(goal.start, "start", question.asked.start);
  if (!is_ok(status)) return status;
  question.note = status.message;
  if (goal.around_cusp > 0) return {};
  status = read_end(goal.goal, "goal", question.asked.goal);
  if (is_ok(status) && !status.message.empty())
    question.note += (question.note.empty() ? "" : " ") + status.message;
  return is_ok(status) ? Status() : status;
}

// That of a slice is computed for the question.
Status PlanServer::read_map(Question& question) const {
  question.known = worker_.known();
  const bool is_known =
      has_map(manipulator_->task_space()) ? question.known.map != nullptr : question.known.roadmap != nullptr;
  if (is_known || question.asked.map.hold) return {};
  return make_status(Status::MAP_NOT_READY,
                     "Paths are planned in the map, which is not there yet: " + worker_.progress().message);
}

Status PlanServer::read_end(const Configuration& configuration, const std::string& which,
                            ask::EndQuestion& end) const {
  const std::string fault = fault_of(*manipulator_, configuration);
  if (!fault.empty()) return invalid_request(which + ": " + fault);
  if (configuration.kind == Configuration::JOINTS || configuration.determinant_sign != 0)
    return invalid_request(which +
                           " is stated by joints or the sign of det A; give kind 0 (now) or 1 (pose), and "
                           "working_mode if one is meant.");
  if (configuration.kind == Configuration::NOW) return read_now(end);
  end.mode = stated_mode(configuration.working_mode);
  return read_pose(*manipulator_, to_base_, configuration.pose, which, end.pose.emplace());
}

Status PlanServer::read_now(ask::EndQuestion& end) const {
  const CurrentConfiguration current = monitor_.current(ros::Time::now());
  if (!is_ok(current.status)) return current.status;
  const auto mode = working_mode(*manipulator_, current.solved.pose, current.solved.q);
  if (!mode)
    return invalid_request("A leg of the robot is stretched or folded now; move it out of B_jj = 0.");
  end.tracked = PathEnd{current.solved.pose, mode, current.solved.q};
  return {};
}

ask::Control PlanServer::control() {
  ask::Control control;
  control.cancelled = &cancelled_;
  control.progress = [this](const char* step, double share) {
    PlanPathFeedback feedback;
    feedback.progress = share;
    feedback.message = step;
    server_->publishFeedback(feedback);
  };
  return control;
}

// A margin beyond those of the robot takes a map of its own.
ask::Session& PlanServer::session_for(const Question& question) {
  Margins margins = manipulator_->constraints().margins;
  const double margin = question.margin > margins.parallel ? question.margin : 0.0;
  const bool is_same = prepared_.known.map == question.known.map &&
                       prepared_.known.roadmap == question.known.roadmap && prepared_.margin == margin;
  if (prepared_.session && is_same) return *prepared_.session;
  prepared_ = {question.known, margin, nullptr};
  if (margin > 0.0) {
    margins.parallel = margin;
    prepared_.session =
        std::make_unique<ask::Session>(manipulator_->with_margins(margins), setup_.options.map);
  } else {
    prepared_.session = std::make_unique<ask::Session>(manipulator_, setup_.options.map);
    prepared_.session->know(question.known.map);
    prepared_.session->know(question.known.roadmap);
  }
  return *prepared_.session;
}

// A path that is not proved to do so is not given.
void PlanServer::keep_to_domain(const Question& question, const PathDomains& domains,
                                ask::PlanAnswer& answer) const {
  if (!question.stay_in_domain || !answer.path || domains.in_one == SameAspect::yes) return;
  answer.path = PlannedPath();
  answer.path.message = "A path was found, but " + domains.message;
  answer.timed.reset();
}

void PlanServer::finish(ask::Outcome<ask::PlanAnswer> outcome, const Question& question,
                        PlanPathResult result) {
  if (outcome.status == MapStatus::cancelled || cancelled_) {
    result.status = make_status(Status::CANCELLED, "Planning was cancelled.");
    result.reason = result.status.message;
    if (server_->isPreemptRequested()) return server_->setPreempted(result, result.status.message);
    return server_->setAborted(result, result.status.message);
  }
  if (!outcome) {
    result.status = refused(outcome.problems);
    result.reason = result.status.message;
    std::this_thread::sleep_for(before_refusal);
    return server_->setAborted(result, result.reason);
  }
  ask::PlanAnswer& answer = outcome.answer;
  const bool around_anchor = answer.slice && answer.slice->joint;
  const PathDomains domains = domains_along(answer.path, answer.between, worker_.domains(), around_anchor);
  keep_to_domain(question, domains, answer);
  write_answer(*manipulator_, answer, result);
  if (!question.note.empty()) result.reason = question.note + " " + result.reason;
  write_domains(domains, result);
  if (answer.path) publish(answer, result);
  server_->setSucceeded(result, result.reason);
}

/// The trajectory even where there is none, so that that of another path does not stay.
void PlanServer::publish(const ask::PlanAnswer& answer, const PlanPathResult& result) {
  path_.publish(result.path);
  markers_.publish(path_markers(*manipulator_, answer.path, answer.between, setup_.options.display.radius));
  trajectory_.publish(result.trajectory);
}

}  // namespace parallel_aspects
