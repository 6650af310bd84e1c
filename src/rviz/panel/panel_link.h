// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_PANEL_PANEL_LINK_H
#define PARALLEL_ASPECTS_RVIZ_PANEL_PANEL_LINK_H

#include "rviz/panel/panel_model.h"
#include "rviz/panel/plan_model.h"

#include <parallel_aspects/ComputeMapAction.h>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include "rviz/link/background_worker.h"
#include <actionlib_msgs/GoalStatusArray.h>
#include <dynamic_reconfigure/Config.h>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {

/// One node, as the panel sees it: hears its topics and asks its services, on threads of its own. No method
/// waits for the network. The node may start, end and load another robot at any time.
class PanelLink {
 public:
  /// `node`: its full name.
  explicit PanelLink(std::string node);
  ~PanelLink();
  PanelLink(const PanelLink&) = delete;
  PanelLink& operator=(const PanelLink&) = delete;

  NodeView view() const;
  PlanView plan() const;
  ProbeView probe() const;

  void choose(const SolvedConfiguration& candidate);  ///< says that this is the assembly mode
  void compute_map();
  void cancel_map();
  void plan_path(const PlanPathGoal& goal);
  void cancel_plan();
  void show(const std::set<std::uint32_t>& aspects);  ///< says to the display which aspects to draw
  void move_probe(const geometry_msgs::Pose& pose, const std::vector<std::int8_t>& working_mode);
  void publish_once(const trajectory_msgs::JointTrajectory& trajectory, const std::string& topic);

 private:
  using AspectList = std::shared_ptr<const ListAspects::Response>;
  using ProgressEvent = ros::MessageEvent<const MapProgress>;

  void connect();
  bool wait_for_master() const;
  std::vector<ros::Subscriber> subscribe(ros::NodeHandle& nh);
  void advertise(ros::NodeHandle& nh);
  void on_state(const AspectState& state);
  void on_transition(const AspectTransition& transition);
  void on_thresholds(const dynamic_reconfigure::Config& config);
  void on_progress(const ProgressEvent& event);
  void on_plan_result(const PlanPathActionResult& result);
  void on_plan_feedback(const PlanPathActionFeedback& feedback);
  bool connected() const;  // under the lock, as the next two
  bool hears(const char* topic) const;
  void start_anew();
  void ask_aspects();
  void ask_index(const AspectSummary& aspect, const AspectList& list);
  void take_index(std::uint32_t aspect, double index);
  void say(const std::string& answer);
  template <typename Message>
  bool publish(const char* topic, const Message& message);

  const std::string node_;
  const NodePing ping_;
  mutable std::mutex mutex_;
  NodeView view_;
  PlanView plan_;
  std::string plan_id_;
  ProbeView probe_;
  ros::WallTime heard_;
  const void* connection_ = nullptr;  // of the map's progress: another one is another start of the node
  ros::CallbackQueue queue_;          // outlives what is called from it
  std::vector<ros::Subscriber> subscribers_;  // of the state first
  std::map<std::string, ros::Publisher> publishers_;
  ros::AsyncSpinner spinner_;
  BackgroundWorker worker_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_PANEL_PANEL_LINK_H
