// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel/panel_link.h"

#include <parallel_aspects/GetSingularityDistance.h>
#include <parallel_aspects/SetAssemblyMode.h>
#include <parallel_aspects/Status.h>

#include <ros/master.h>
#include <ros/param.h>
#include <ros/this_node.h>

#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatus.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <std_msgs/Int8MultiArray.h>
#include <std_msgs/UInt32.h>
#include <std_msgs/UInt32MultiArray.h>
#include <utility>

namespace parallel_aspects {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds patience(5000);
constexpr milliseconds between_masters(300);  // searches for a master
constexpr std::size_t kept_transitions = 200;

const char* const compute_goal = "compute_map/goal";
const char* const compute_cancel = "compute_map/cancel";
const char* const plan_goal = "plan_path/goal";
const char* const plan_cancel = "plan_path/cancel";
const char* const probe_pose = "probe/set_pose";
const char* const probe_mode = "probe/working_mode";
const char* const shown_aspects = "shown_aspects";

bool runs(const actionlib_msgs::GoalStatus& goal) {
  using actionlib_msgs::GoalStatus;
  return goal.status == GoalStatus::ACTIVE || goal.status == GoalStatus::PENDING ||
         goal.status == GoalStatus::PREEMPTING;
}

std::string new_goal_id() {
  static std::atomic<unsigned> count{0};
  return ros::this_node::getName() + "-panel-" + std::to_string(++count) + "-" +
         std::to_string(ros::WallTime::now().toNSec());
}

double largest_in(const AspectState& state) {
  double largest = 0.0;
  for (const DistanceBounds& each : {state.parallel_distance, state.serial_distance, state.limit_distance})
    for (const double bound : {each.lower, each.upper})
      if (std::isfinite(bound)) largest = std::max(largest, bound);
  return largest;
}

void take_threshold(const std::string& name, double value, std::array<LevelThresholds, 3>& thresholds) {
  constexpr std::array<const char*, 3> names{"parallel", "serial", "limit"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (name == std::string(names[i]) + "_warn") thresholds[i].warn = value;
    if (name == std::string(names[i]) + "_stop") thresholds[i].stop = value;
  }
}

}  // namespace

PanelLink::PanelLink(std::string node) : node_(std::move(node)), ping_(node_), spinner_(1, &queue_) {
  view_.node = node_;
  worker_.post([this] { connect(); });
  spinner_.start();
}

PanelLink::~PanelLink() {
  spinner_.stop();  // no callback runs from here on
  queue_.disable();
  queue_.clear();
}

// roscpp waits for the master where it subscribes, without end.
bool PanelLink::wait_for_master() const {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  while (!worker_.stopping()) {
    if (ros::master::execute("getPid", request, response, payload, false)) return true;
    worker_.sleep(between_masters);
  }
  return false;
}

void PanelLink::connect() {
  if (!wait_for_master()) return;
  ros::NodeHandle nh(node_);
  nh.setCallbackQueue(&queue_);
  advertise(nh);
  std::vector<ros::Subscriber> subscribers = subscribe(nh);
  const std::lock_guard<std::mutex> lock(mutex_);
  subscribers_ = std::move(subscribers);
}

std::vector<ros::Subscriber> PanelLink::subscribe(ros::NodeHandle& nh) {
  const auto with_lock = [this](auto take) {
    return [this, take](const auto& message) {
      const std::lock_guard<std::mutex> lock(mutex_);
      take(*message);
    };
  };
  const boost::function<void(const AssemblyCandidatesConstPtr&)> on_candidates =
      with_lock([this](const AssemblyCandidates& message) { view_.candidates = message; });
  const boost::function<void(const ProbeStateConstPtr&)> on_probe =
      with_lock([this](const ProbeState& message) { probe_.now = end_at(message); });
  const auto on_stored = [this, with_lock](std::optional<PlanEnd> ProbeView::*end) {
    return boost::function<void(const ConfigurationConstPtr&)>(
        with_lock([this, end](const Configuration& stored) {
          probe_.*end = end_at(stored);
          ++probe_.stored;
        }));
  };
  const boost::function<void(const actionlib_msgs::GoalStatusArrayConstPtr&)> on_goals =
      with_lock([this](const actionlib_msgs::GoalStatusArray& message) {
        view_.map_goal_runs = std::any_of(message.status_list.begin(), message.status_list.end(), runs);
      });
  const boost::function<void(const std_msgs::UInt32ConstPtr&)> on_selected =
      with_lock([this](const std_msgs::UInt32& message) {
        view_.selected = message.data;
        ++view_.clicks;
      });
  return {nh.subscribe("state", 1, &PanelLink::on_state, this, ros::TransportHints().tcpNoDelay()),
          nh.subscribe("transitions", 100, &PanelLink::on_transition, this),
          nh.subscribe("thresholds/parameter_updates", 10, &PanelLink::on_thresholds, this),
          nh.subscribe("map_progress", 10, &PanelLink::on_progress, this),
          nh.subscribe("plan_path/result", 10, &PanelLink::on_plan_result, this),
          nh.subscribe("plan_path/feedback", 10, &PanelLink::on_plan_feedback, this),
          nh.subscribe<AssemblyCandidates>("candidates", 1, on_candidates),
          nh.subscribe<std_msgs::UInt32>("selected_aspect", 1, on_selected),
          nh.subscribe<ProbeState>("probe/state", 1, on_probe),
          nh.subscribe<Configuration>("probe/start", 10, on_stored(&ProbeView::start)),
          nh.subscribe<Configuration>("probe/goal", 10, on_stored(&ProbeView::goal)),
          nh.subscribe<actionlib_msgs::GoalStatusArray>("compute_map/status", 1, on_goals)};
}

void PanelLink::advertise(ros::NodeHandle& nh) {
  std::map<std::string, ros::Publisher> publishers{
      {compute_goal, nh.advertise<ComputeMapActionGoal>(compute_goal, 10)},
      {compute_cancel, nh.advertise<actionlib_msgs::GoalID>(compute_cancel, 10)},
      {plan_goal, nh.advertise<PlanPathActionGoal>(plan_goal, 10)},
      {plan_cancel, nh.advertise<actionlib_msgs::GoalID>(plan_cancel, 10)},
      {probe_pose, nh.advertise<geometry_msgs::Pose>(probe_pose, 10)},
      {probe_mode, nh.advertise<std_msgs::Int8MultiArray>(probe_mode, 10)},
      {shown_aspects, nh.advertise<std_msgs::UInt32MultiArray>(shown_aspects, 1, true)}};
  const std::lock_guard<std::mutex> lock(mutex_);
  publishers_ = std::move(publishers);
}

NodeView PanelLink::view() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  NodeView view = view_;
  view.connected = connected();
  view.hears = hears(compute_goal) && hears(compute_cancel);
  view.silence = (ros::WallTime::now() - heard_).toSec();
  return view;
}

PlanView PanelLink::plan() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  PlanView plan = plan_;
  if (plan.runs && !connected()) {
    plan.runs = false;
    plan.message = "The node ended while it planned.";
  }
  return plan;
}

bool PanelLink::connected() const {
  return ping_.answers() && !subscribers_.empty() && subscribers_.front().getNumPublishers() > 0;
}

bool PanelLink::hears(const char* topic) const {
  const auto publisher = publishers_.find(topic);
  return publisher != publishers_.end() && publisher->second.getNumSubscribers() > 0;
}

ProbeView PanelLink::probe() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return probe_;
}

void PanelLink::on_state(const AspectState& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  heard_ = ros::WallTime::now();
  if (state.status.code == Status::OK)
    view_.largest_distance = std::max(view_.largest_distance, largest_in(state));
  view_.state = state;
}

void PanelLink::on_transition(const AspectTransition& transition) {
  const std::lock_guard<std::mutex> lock(mutex_);
  view_.transitions.push_back(transition);
  if (view_.transitions.size() > kept_transitions) view_.transitions.erase(view_.transitions.begin());
}

void PanelLink::on_thresholds(const dynamic_reconfigure::Config& config) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const dynamic_reconfigure::DoubleParameter& each : config.doubles)
    take_threshold(each.name, each.value, view_.thresholds);
}

// What belongs to the robot that the node had before.
void PanelLink::start_anew() {
  ++view_.start;
  view_.aspects.reset();
  view_.deepest_index.reset();
  view_.largest_distance = 0.0;
  view_.map_goal_runs = false;
  view_.selected = 0;
  view_.last_answer.clear();
  probe_ = {std::nullopt, std::nullopt, std::nullopt, probe_.stored};
  plan_.message = plan_.runs ? "The node ended, or loaded another robot, while it planned." : "";
  plan_.runs = false;
  plan_.result.reset();
  plan_id_.clear();
  worker_.post([this] {
    bool read_only = false;
    ros::param::get(node_ + "/read_only", read_only);
    const std::string unit = ros::param::param<std::string>(node_ + "/distance_unit", "m");
    const std::lock_guard<std::mutex> lock(mutex_);
    view_.read_only = read_only;
    view_.unit = unit == DistanceUnit::of_angles().name() ? DistanceUnit::of_angles() : DistanceUnit();
  });
}

void PanelLink::on_progress(const ProgressEvent& event) {
  const MapProgress& progress = *event.getMessage();
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool anew = connection_ != event.getConnectionHeaderPtr().get();
  connection_ = event.getConnectionHeaderPtr().get();
  if (anew) start_anew();
  view_.progress = progress;
  if (anew || progress.state == MapProgress::COMPLETE) worker_.post([this] { ask_aspects(); });
}

void PanelLink::ask_aspects() {
  ListAspects service;
  const std::string fault = worker_.call(node_ + "/list_aspects", service, patience);
  if (!fault.empty()) return say(fault);
  const std::lock_guard<std::mutex> lock(mutex_);
  view_.aspects = std::make_shared<const ListAspects::Response>(service.response);
  view_.deepest_index.reset();
  for (const AspectSummary& aspect : view_.aspects->aspects)
    worker_.post([this, &aspect, list = view_.aspects] { ask_index(aspect, list); });
}

void PanelLink::ask_index(const AspectSummary& aspect, const AspectList& list) {
  GetSingularityDistance service;
  service.request.configuration.kind = Configuration::POSE;
  service.request.configuration.pose.pose = aspect.deepest_pose;
  service.request.configuration.working_mode = aspect.working_mode;
  service.request.configuration.determinant_sign = aspect.determinant_sign;
  if (!worker_.call(node_ + "/get_singularity_distance", service, patience).empty()) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (list != view_.aspects || service.response.reports.empty()) return;
  take_index(aspect.id, service.response.reports.front().inverse_condition_number);
}

void PanelLink::take_index(std::uint32_t aspect, double index) {
  std::map<std::uint32_t, double> indices;
  if (view_.deepest_index) indices = *view_.deepest_index;
  indices[aspect] = index;
  view_.deepest_index = std::make_shared<const std::map<std::uint32_t, double>>(std::move(indices));
}

void PanelLink::say(const std::string& answer) {
  const std::lock_guard<std::mutex> lock(mutex_);
  view_.last_answer = answer;
}

void PanelLink::choose(const SolvedConfiguration& candidate) {
  worker_.post_urgent([this, candidate] {
    SetAssemblyMode service;
    Configuration& meant = service.request.configuration;
    meant.kind = Configuration::POSE;
    meant.pose.header.frame_id = candidate.header.frame_id;  // with no stamp: by the latest transform
    meant.pose.pose = candidate.pose;
    meant.working_mode = candidate.working_mode;
    meant.determinant_sign = candidate.determinant_sign;
    const std::string fault = worker_.call(node_ + "/set_assembly_mode", service, patience);
    say(fault.empty() ? service.response.status.message : fault);
  });
}

// Whether it was heard: an action's server that is not there yet would never answer.
template <typename Message>
bool PanelLink::publish(const char* topic, const Message& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto publisher = publishers_.find(topic);
  if (publisher == publishers_.end()) return false;
  publisher->second.publish(message);
  return publisher->second.getNumSubscribers() > 0;
}

void PanelLink::compute_map() {
  ComputeMapActionGoal goal;
  goal.header.stamp = goal.goal_id.stamp = ros::Time::now();
  goal.goal_id.id = new_goal_id();
  if (!publish(compute_goal, goal)) say(node_ + "/compute_map is not there.");
}

void PanelLink::cancel_map() {
  if (!publish(compute_cancel, actionlib_msgs::GoalID())) say(node_ + "/compute_map is not there.");
}

void PanelLink::plan_path(const PlanPathGoal& wanted) {
  PlanPathActionGoal goal;
  goal.header.stamp = goal.goal_id.stamp = ros::Time::now();
  goal.goal_id.id = new_goal_id();
  goal.goal = wanted;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    plan_id_ = goal.goal_id.id;
    plan_.runs = true;
    plan_.progress = 0.0;
    plan_.message = "Asks the node.";
  }
  if (publish(plan_goal, goal)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  plan_.runs = false;
  plan_.message = node_ + "/plan_path is not there.";
}

void PanelLink::cancel_plan() {
  actionlib_msgs::GoalID goal;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    goal.id = plan_id_;
  }
  publish(plan_cancel, goal);
}

void PanelLink::on_plan_feedback(const PlanPathActionFeedback& feedback) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (feedback.status.goal_id.id != plan_id_ || !plan_.runs) return;
  plan_.progress = feedback.feedback.progress;
  plan_.message = feedback.feedback.message;
}

void PanelLink::on_plan_result(const PlanPathActionResult& result) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (result.status.goal_id.id != plan_id_ || !plan_.runs) return;
  plan_.runs = false;
  const bool answered = result.result.answer == PlanPathResult::YES || !result.result.reason.empty();
  plan_.message = answered ? text_of(result.result) : "The node took the goal back. " + result.status.text;
  plan_.result = std::make_shared<const PlanPathResult>(result.result);
  ++plan_.number;
}

void PanelLink::show(const std::set<std::uint32_t>& aspects) {
  std_msgs::UInt32MultiArray message;
  message.data.assign(aspects.begin(), aspects.end());
  publish(shown_aspects, message);
}

void PanelLink::move_probe(const geometry_msgs::Pose& pose, const std::vector<std::int8_t>& working_mode) {
  std_msgs::Int8MultiArray mode;
  mode.data = working_mode;
  if (!working_mode.empty()) publish(probe_mode, mode);
  publish(probe_pose, pose);
}

// Advertised until something else is published, so that who comes some seconds later hears it too.
void PanelLink::publish_once(const trajectory_msgs::JointTrajectory& trajectory, const std::string& topic) {
  worker_.post_urgent([this, trajectory, topic] {
    if (!wait_for_master()) return;
    ros::NodeHandle nh;
    ros::Publisher publisher = nh.advertise<trajectory_msgs::JointTrajectory>(topic, 1);
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(0.001 * patience.count());
    while (publisher.getNumSubscribers() == 0 && ros::WallTime::now() < end &&
           worker_.sleep(milliseconds(20)))
      continue;
    const bool heard = publisher.getNumSubscribers() > 0;
    if (heard) publisher.publish(trajectory);
    say(heard ? "Published once on " + publisher.getTopic() + "."
              : "Nobody listens on " + publisher.getTopic() + "; nothing was published.");
    worker_.sleep(milliseconds(500));  // for what is still to be sent
  });
}

}  // namespace parallel_aspects
