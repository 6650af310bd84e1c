// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel/plan_model.h"

#include "model/message_text.h"

#include <parallel_aspects/Status.h>

#include <Eigen/Geometry>
#include <ros/names.h>

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

Configuration configuration_of(const std::optional<PlanEnd>& end) {
  Configuration configuration;
  if (!end) return configuration;  // NOW
  configuration.kind = Configuration::POSE;
  configuration.pose = end->pose;
  configuration.pose.header.stamp = ros::Time();  // by the latest transform
  configuration.working_mode = end->working_mode;
  return configuration;
}

Eigen::Vector3d position_of(const geometry_msgs::Pose& pose) {
  return {pose.position.x, pose.position.y, pose.position.z};
}

Eigen::Vector4d turn_of(const geometry_msgs::Pose& pose) {
  return {pose.orientation.x, pose.orientation.y, pose.orientation.z, pose.orientation.w};
}

double angle_between(const geometry_msgs::Pose& a, const geometry_msgs::Pose& b) {
  return 2.0 * std::acos(std::min(1.0, std::abs(turn_of(a).dot(turn_of(b)))));
}

double distance_between(const geometry_msgs::Pose& a, const geometry_msgs::Pose& b) {
  return (position_of(a) - position_of(b)).norm();
}

// Length and rotation count alike, each as a share of that of the whole path.
std::vector<double> shares_along(const std::vector<geometry_msgs::Pose>& poses) {
  double length = 0.0, turned = 0.0;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    length += distance_between(poses[i], poses[i + 1]);
    turned += angle_between(poses[i], poses[i + 1]);
  }
  constexpr double least = 1e-12;
  std::vector<double> shares{0.0};
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    double step = length > least ? distance_between(poses[i], poses[i + 1]) / length : 0.0;
    if (turned > 1e-6) step += angle_between(poses[i], poses[i + 1]) / turned;
    shares.push_back(shares.back() + step);
  }
  const double whole = shares.back();
  for (double& share : shares) share = whole > 0.0 ? share / whole : 0.0;
  shares.back() = 1.0;
  return shares;
}

std::string legs_of(const PlanPathResult& result) {
  std::string text;
  for (const std::string& leg : result.crossing_legs) text += (text.empty() ? "" : ", ") + leg;
  return text;
}

}  // namespace

std::optional<PlanEnd> end_at(const ProbeState& probe) {
  if (!std::isfinite(probe.off)) return std::nullopt;
  PlanEnd end;
  end.pose.header.frame_id = probe.header.frame_id;
  end.pose.pose = probe.report.configuration.pose;
  end.working_mode = probe.working_mode;
  return end;
}

PlanEnd end_at(const Configuration& stored) { return {stored.pose, stored.working_mode}; }

PlanPathGoal goal_of(const PlanChoice& choice) {
  PlanPathGoal goal;
  goal.start = configuration_of(choice.start);
  goal.goal = configuration_of(choice.goal);
  goal.policy = choice.through_gates ? PlanPathGoal::SERIAL : PlanPathGoal::STAY;
  goal.path_only = !choice.in_time;
  goal.parallel_margin = choice.parallel_margin;
  return goal;
}

std::optional<PlanEnd> end_in_aspect(const NodeView& view, std::uint32_t aspect) {
  if (!view.aspects) return std::nullopt;
  for (const AspectSummary& each : view.aspects->aspects) {
    if (each.id != aspect) continue;
    PlanEnd end;
    end.pose.pose = each.deepest_pose;  // an empty frame is the base frame
    end.working_mode = each.working_mode;
    return end;
  }
  return std::nullopt;
}

Permission may_plan(const NodeView& view, const PlanChoice& choice, const PlanView& plan) {
  if (const Permission asked = may_ask(view); !asked) return asked;
  if (plan.runs) return {"A path is being planned."};
  if (!choice.goal) return {"There is no goal yet: choose an aspect, or move the probe."};
  if (!choice.start && view.state->status.code != Status::OK)
    return {"It is not known where the robot is, so start elsewhere. " + view.state->status.message};
  return {};
}

Permission may_publish(const PlanView& plan, const std::string& topic) {
  std::string fault;
  if (!plan.result || plan.result->trajectory.points.empty())
    return {"There is no trajectory yet: plan with \"in time\"."};
  if (topic.empty()) return {"Type the topic first. Whoever listens there may move the robot."};
  if (!ros::names::validate(topic, fault)) return {fault};
  return {};
}

std::string text_of(const PlanPathResult& result) {
  if (result.status.code != Status::OK) return result.status.message;
  if (result.answer == PlanPathResult::NO) return "No path: " + result.reason;
  if (result.answer != PlanPathResult::YES) return "Not known: " + result.reason;
  std::string text = "Proved path, " + number_text(result.length, 4) + " m";
  if (result.turned > 1e-9) text += " and " + number_text(result.turned, 3) + " rad";
  if (result.seconds > 0.0) text += " in " + number_text(result.seconds, 3) + " s";
  text += result.crossings.empty() ? ". It stays in one aspect"
                                   : ". Changes of posture: " + std::to_string(result.crossings.size()) +
                                         " (" + legs_of(result) + ")";
  text += ". Least index " + number_text(result.least_index, 3) + ".";
  return result.trajectory.points.empty() && !result.timing.empty() ? text + " " + result.timing : text;
}

PlannedMotion::PlannedMotion(const PlanPathResult& result) {
  for (const geometry_msgs::PoseStamped& each : result.path.poses) poses_.push_back(each.pose);
  if (poses_.empty()) return;
  shares_ = shares_along(poses_);
  const std::size_t legs = result.working_modes.size() / poses_.size();
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const auto first = result.working_modes.begin() + static_cast<std::ptrdiff_t>(i * legs);
    modes_.emplace_back(first, first + static_cast<std::ptrdiff_t>(legs));
  }
  for (const std::uint32_t crossing : result.crossings)
    if (crossing < shares_.size()) crossings_.push_back(shares_[crossing]);
  if (result.seconds > 0.0) seconds_ = result.seconds;
}

// The last one that begins there or before: behind a crossing, whose segment has no length.
std::size_t PlannedMotion::segment_at(double share) const {
  const auto behind = std::upper_bound(shares_.begin(), shares_.end(), std::clamp(share, 0.0, 1.0));
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, behind - shares_.begin() - 1));
}

geometry_msgs::Pose PlannedMotion::pose_at(double share) const {
  const std::size_t i = segment_at(share);
  if (i + 1 >= poses_.size()) return poses_.back();
  const double t = std::clamp((share - shares_[i]) / (shares_[i + 1] - shares_[i]), 0.0, 1.0);
  const Eigen::Vector3d at = (1.0 - t) * position_of(poses_[i]) + t * position_of(poses_[i + 1]);
  Eigen::Vector4d to = turn_of(poses_[i + 1]);
  if (turn_of(poses_[i]).dot(to) < 0.0) to = -to;
  const Eigen::Vector4d turn = ((1.0 - t) * turn_of(poses_[i]) + t * to).normalized();
  geometry_msgs::Pose pose;
  pose.position.x = at.x();
  pose.position.y = at.y();
  pose.position.z = at.z();
  pose.orientation.x = turn[0];
  pose.orientation.y = turn[1];
  pose.orientation.z = turn[2];
  pose.orientation.w = turn[3];
  return pose;
}

std::vector<std::int8_t> PlannedMotion::mode_at(double share) const { return modes_[segment_at(share)]; }

}  // namespace parallel_aspects
