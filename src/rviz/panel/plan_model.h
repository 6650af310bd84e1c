// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_PANEL_PLAN_MODEL_H
#define PARALLEL_ASPECTS_RVIZ_PANEL_PLAN_MODEL_H

#include "rviz/panel/panel_model.h"

#include <parallel_aspects/Configuration.h>
#include <parallel_aspects/PlanPathAction.h>
#include <parallel_aspects/ProbeState.h>

#include <cstddef>
#include <cstdint>
#include <geometry_msgs/PoseStamped.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A pose to plan from or to.
struct PlanEnd {
  geometry_msgs::PoseStamped pose;
  std::vector<std::int8_t> working_mode;  ///< empty for any
};

/// What the probe says: where it is, and what was stored by its menu.
struct ProbeView {
  std::optional<PlanEnd> now, start, goal;  ///< nothing where there is none
  std::uint64_t stored = 0;                 ///< counts starts and goals
};

/// What a person has chosen.
struct PlanChoice {
  std::optional<PlanEnd> start;  ///< nothing: where the robot is
  std::optional<PlanEnd> goal;   ///< nothing: not chosen
  bool through_gates = false;    ///< whether legs may change their posture on the way
  bool in_time = false;          ///< whether a trajectory is wanted
  double parallel_margin = 0.0;  ///< least parallel index to be kept; 0 for what the node keeps anyway
};

/// What became of the last plan.
struct PlanView {
  bool runs = false;
  double progress = 0.0;  ///< 0 to 1
  std::string message;    ///< what is being done, or why there is no result
  std::shared_ptr<const PlanPathResult> result;
  std::uint64_t number = 0;  ///< counts results
};

/// Nothing where the probe is at no pose.
std::optional<PlanEnd> end_at(const ProbeState& probe);

PlanEnd end_at(const Configuration& stored);

PlanPathGoal goal_of(const PlanChoice& choice);

/// Where the middle of an aspect is; nothing where the map has no such aspect.
std::optional<PlanEnd> end_in_aspect(const NodeView& view, std::uint32_t aspect);

Permission may_plan(const NodeView& view, const PlanChoice& choice, const PlanView& plan);

/// `topic`: as it was typed. `names` are examined as ROS does.
Permission may_publish(const PlanView& plan, const std::string& topic);

/// The text about a result.
std::string text_of(const PlanPathResult& result);

/// A planned path, to be walked along by a share of its length, 0 to 1.
class PlannedMotion {
 public:
  PlannedMotion() = default;  ///< of no path
  explicit PlannedMotion(const PlanPathResult& result);

  bool empty() const noexcept { return poses_.empty(); }

  /// As the path is proved: positions run straight, quaternions straight and normalised, the short way.
  geometry_msgs::Pose pose_at(double share) const;

  /// The working mode there; at a crossing the one behind it.
  std::vector<std::int8_t> mode_at(double share) const;

  /// Where legs change their postures.
  const std::vector<double>& crossings() const noexcept { return crossings_; }

  /// How long it takes [s]: that of the trajectory, or five seconds.
  double seconds() const noexcept { return seconds_; }

 private:
  std::size_t segment_at(double share) const;

  std::vector<geometry_msgs::Pose> poses_;
  std::vector<double> shares_;  // of the length, at each pose, rising from 0 to 1
  std::vector<std::vector<std::int8_t>> modes_;
  std::vector<double> crossings_;
  double seconds_ = 5.0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_PANEL_PLAN_MODEL_H
