// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/plan_server.h"

#include "parallel_aspects/kinematics/jacobians.h"
#include "ros/messages/configurations.h"
#include "ros/messages/conversions.h"
#include "ros/messages/plan_messages.h"
#include "ros/pictures/marker_batch.h"
#include "ros/pictures/path_picture.h"

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
      certifier_(std::make_shared<SegmentCertifier>(manipulator_)),
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

void PlanServer::on_goal(const PlanPathGoalConstPtr& goal) {
  cancelled_ = false;
  if (stopping_ || server_->isPreemptRequested()) cancelled_ = true;
  PlanPathResult result;
  Question question;
  result.status = read(*goal, question);
  result.reason = result.status.message;
  if (is_ok(result.status)) return finish(plan(question), question, result);
  std::this_thread::sleep_for(before_refusal);
  server_->setAborted(result, result.status.message);
}

Status PlanServer::read_wish(const PlanPathGoal& goal, PathWish& wish) const {
  if (goal.policy > PlanPathGoal::SERIAL) return invalid_request("policy must be 0 (stay) or 1 (serial).");
  if (goal.prefer > PlanPathGoal::FAST)
    return invalid_request("prefer must be 0 (short), 1 (clear) or 2 (fast).");
  wish.policy = goal.policy == PlanPathGoal::SERIAL ? PathPolicy::serial : PathPolicy::stay;
  wish.prefer = PathPreference::shortest;
  if (goal.prefer == PlanPathGoal::CLEAR) wish.prefer = PathPreference::clear;
  if (goal.prefer == PlanPathGoal::FAST) wish.prefer = PathPreference::fast;
  if (goal.path_only && wish.prefer == PathPreference::fast)
    return invalid_request("prefer 2 (fast) needs the path in time; leave out path_only.");
  return {};
}

Status PlanServer::read(const PlanPathGoal& goal, Question& question) const {
  Status status = read_wish(goal, question.wish);
  question.timed = !goal.path_only;
  question.stay_in_domain = goal.stay_in_domain;
  const bool mapped = has_map(manipulator_->task_space());
  if (is_ok(status)) status = read_margin(goal, mapped, question.margin);
  if (is_ok(status) && question.timed) status = read_limits();
  if (is_ok(status)) status = read_ends(goal, question);
  if (is_ok(status) && !question.cusp) status = read_map(question);
  return status;
}

Status PlanServer::read_ends(const PlanPathGoal& goal, Question& question) const {
  const Status status = read_end(goal.start, "start", question.from);
  if (!is_ok(status)) return status;
  if (goal.around_cusp == 0 && goal.held_joint.empty()) return read_end(goal.goal, "goal", question.to);
  return read_cusp(*manipulator_, goal, question.from, question.cusp);
}

Status PlanServer::read_map(Question& question) const {
  question.known = worker_.known();
  if (has_map(manipulator_->task_space()) ? question.known.map == nullptr : question.known.roadmap == nullptr)
    return make_status(Status::MAP_NOT_READY,
                       "Paths are planned in the map, which is not there yet: " + worker_.progress().message);
  return {};
}

Status PlanServer::read_limits() const {
  const JointVector& acceleration = setup_.options.acceleration;
  if (acceleration.size() == 0)
    return invalid_request(
        "No acceleration limits are stated; set the parameter ~motion/acceleration and reload, or ask with "
        "path_only.");
  const Problems problems = problems_of(*manipulator_, acceleration);
  return problems.empty() ? Status() : invalid_request(problems.front() + " Or ask with path_only.");
}

Status PlanServer::read_end(const Configuration& configuration, const std::string& which,
                            PathEnd& end) const {
  const std::string fault = fault_of(*manipulator_, configuration);
  if (!fault.empty()) return invalid_request(which + ": " + fault);
  if (configuration.kind == Configuration::JOINTS || configuration.determinant_sign != 0)
    return invalid_request(which +
                           " is stated by joints or the sign of det A; give kind 0 (now) or 1 (pose), and "
                           "working_mode if one is meant.");
  if (configuration.kind == Configuration::NOW) return read_now(end);
  const std::vector<int> signs(configuration.working_mode.begin(), configuration.working_mode.end());
  if (std::any_of(signs.begin(), signs.end(), [](int sign) { return sign != 0; }))
    end.mode = WorkingMode::from_signs(signs);
  return read_pose(*manipulator_, to_base_, configuration.pose, which, end.pose);
}

Status PlanServer::read_now(PathEnd& end) const {
  const CurrentConfiguration current = monitor_.current(ros::Time::now());
  if (!is_ok(current.status)) return current.status;
  end.pose = current.solved.pose;
  end.q = current.solved.q;
  end.mode = working_mode(*manipulator_, current.solved.pose, current.solved.q);
  if (end.mode) return {};
  return invalid_request("A leg of the robot is stretched or folded now; move it out of B_jj = 0.");
}

MapControl PlanServer::control(const std::string& doing) {
  MapControl control;
  control.cancelled = &cancelled_;
  control.progress = [this, doing](double share) {
    PlanPathFeedback feedback;
    feedback.progress = share;
    feedback.message = doing;
    server_->publishFeedback(feedback);
  };
  return control;
}

PathWish PlanServer::timed(const PathWish& wish, const Plan& plan, const MapControl& control) const {
  PathWish result = wish;
  if (wish.prefer == PathPreference::fast)
    result.time = path_timer(*plan.certifier, plan.between, setup_.options.acceleration, control);
  return result;
}

PlanServer::Plan PlanServer::plan(const Question& question) {
  if (question.cusp) return plan_around(question);
  const MapControl steps = control("Looking for gates and a path.");
  steps.progress(0.0);
  Plan plan;
  plan.certifier = certifier_;
  if (question.known.roadmap) {
    plan.path = plan_in_roadmap(*question.known.roadmap, question.from, question.to,
                                timed(question.wish, plan, steps), steps);
    return plan;
  }
  plan.path.message = prepare(question);
  if (!plan.path.message.empty()) return plan;
  plan.certifier = prepared_.certifier;
  plan.between = [planner = prepared_.planner](const Pose& from, const Pose& to, double t) {
    return planner->between(from, to, t);
  };
  plan.path = prepared_.planner->plan(question.from, question.to, timed(question.wish, plan, steps), steps);
  return plan;
}

PlanServer::Plan PlanServer::plan_around(const Question& question) {
  const MapControl steps = control("Looking for a path around the cusp.");
  steps.progress(0.0);
  CuspPath found = plan_around_cusp(manipulator_, question.from, *question.cusp, steps);
  Plan plan;
  plan.status = std::move(found.status);
  plan.path = std::move(found.path);
  plan.turns_around_cusps = std::move(found.turns_around_cusps);
  plan.between = std::move(found.between);
  plan.certifier = certifier_;
  return plan;
}

// A path that is not proved to do so is not given.
void PlanServer::keep_to_domain(const Question& question, const PathDomains& domains, Plan& plan) const {
  if (!question.stay_in_domain || !plan.path || domains.in_one == SameAspect::yes) return;
  plan.path = PlannedPath();
  plan.path.message = "A path was found, but " + domains.message;
}

// A margin beyond those of the robot takes a map of its own. Empty, or why there is no planner.
std::string PlanServer::prepare(const Question& question) {
  Margins margins = manipulator_->constraints().margins;
  const double margin = question.margin > margins.parallel ? question.margin : 0.0;
  if (prepared_.planner && prepared_.map == question.known.map && prepared_.margin == margin) return {};
  prepared_ = {question.known.map, margin, nullptr, certifier_};
  std::shared_ptr<const AspectMap> map = question.known.map;
  if (margin > 0.0) {
    margins.parallel = margin;
    const auto robot = manipulator_->with_margins(margins);
    const MapResult result =
        compute_aspect_map(robot, setup_.options.map, control("Computing a map that keeps the margin."));
    if (!result) return "No map keeps that margin: " + result.message;
    prepared_.certifier = std::make_shared<SegmentCertifier>(robot);
    map = result.map;
  }
  prepared_.planner = std::make_shared<PathPlanner>(map);
  return {};
}

void PlanServer::finish(Plan plan, const Question& question, PlanPathResult result) {
  const PathDomains domains =
      domains_along(plan.path, plan.between, worker_.domains(), question.cusp.has_value());
  keep_to_domain(question, domains, plan);
  TimedPath timed;
  if (plan.path && question.timed && !cancelled_) {
    const MapControl steps = control("Timing the path.");
    steps.progress(0.0);
    timed = time_path(*plan.certifier, plan.path, plan.between, setup_.options.acceleration, steps);
  }
  if (cancelled_) {
    result.status = make_status(Status::CANCELLED, "Planning was cancelled.");
    result.reason = result.status.message;
    if (server_->isPreemptRequested()) return server_->setPreempted(result, result.status.message);
    return server_->setAborted(result, result.status.message);
  }
  if (!is_ok(plan.status)) {
    result.status = plan.status;
    result.reason = plan.status.message;
    return server_->setAborted(result, result.reason);
  }
  write_path(*manipulator_, plan.path, result);
  write_domains(domains, result);
  result.turns_around_cusps.assign(plan.turns_around_cusps.begin(), plan.turns_around_cusps.end());
  if (const std::string cusps = several_cusps(plan.turns_around_cusps); !cusps.empty())
    result.reason += (result.reason.empty() ? "" : " ") + cusps;
  write_timing(*manipulator_, timed, result);
  if (plan.path) publish(plan, result);
  server_->setSucceeded(result, result.reason);
}

/// The trajectory even where there is none, so that that of another path does not stay.
void PlanServer::publish(const Plan& plan, const PlanPathResult& result) {
  path_.publish(result.path);
  markers_.publish(path_markers(*manipulator_, plan.path, plan.between, setup_.options.display.radius));
  trajectory_.publish(result.trajectory);
}

}  // namespace parallel_aspects
