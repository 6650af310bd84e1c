// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/robot_server.h"

#include "ros/messages/hazard_messages.h"
#include "ros/messages/map_messages.h"
#include "ros/monitor/threshold_offer.h"
#include "urdf/description/nearest_name.h"

#include <ros/console.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>

namespace parallel_aspects {
namespace {

const ros::WallDuration until_silence(5.0);  // after the start, if nothing has arrived

// For messages: a name or a reason may be as long as whoever asks likes.
std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 200;
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

ros::NodeHandle on_queue(ros::NodeHandle nh, ros::CallbackQueue& queue) {
  nh.setCallbackQueue(&queue);
  return nh;
}

}  // namespace

RobotServer::RobotServer(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh, NodeSetup setup)
    : setup_(std::move(setup)),
      tracking_nh_(on_queue(private_nh, tracking_queue_)),
      service_nh_(on_queue(private_nh, service_queue_)),
      work_nh_(on_queue(private_nh, work_queue_)),
      joint_states_nh_(on_queue(nh, tracking_queue_)),
      tf_listener_(tf_, on_queue(nh, tf_queue_), false),
      monitor_(setup_.mechanism, setup_.options, joint_states_nh_.resolveName("joint_states")),
      display_(setup_, service_nh_),
      state_(tracking_nh_.advertise<AspectState>("state", 100, true)),
      transitions_(tracking_nh_.advertise<AspectTransition>("transitions", 100)),
      last_transition_(tracking_nh_.advertise<AspectTransition>("last_transition", 10, true)),
      joint_states_(tracking_nh_.advertise<sensor_msgs::JointState>("joint_states", 100)),
      candidates_(work_nh_.advertise<AssemblyCandidates>("candidates", 10, true)),
      map_progress_(service_nh_.advertise<MapProgress>("map_progress", 10, true)),
      worker_(
          setup_.mechanism->mapped_manipulator(), setup_.options.map_file,
          [this](const MapProgress& progress, const auto& map) { on_map_progress(progress, map); },
          setup_.options.uniqueness,
          [this](const auto& uniqueness, const auto& cancelled) {
            display_.set_domains(uniqueness, {{}, &cancelled});
          }),
      queries_(
          setup_.mechanism->manipulator(), monitor_, worker_,
          [this](const auto& pose, std::string& message) { return to_base(pose, message); },
          setup_.options.read_only),
      motions_(setup_.mechanism->mapped_manipulator(), monitor_, worker_,
               [this](const auto& pose, std::string& message) { return to_base(pose, message); }),
      maps_(setup_, worker_),
      workspaces_(service_nh_, worker_),
      frame_watch_(setup_.options.frame_prefix + "/", setup_.mechanism->link_names()),
      diagnostics_(on_queue(nh, service_queue_), service_nh_, *setup_.mechanism->manipulator(), monitor_,
                   worker_, frame_watch_),
      goals_(service_nh_, "compute_map"),
      thinned_(setup_.options.state_decimation),
      completed_(setup_.options.completed_decimation),
      tracking_spinner_(1, &tracking_queue_),
      service_spinner_(2, &service_queue_),
      work_spinner_(1, &work_queue_),
      tf_spinner_(1, &tf_queue_) {
  tf_.setUsingDedicatedThread(true);  // the spinner's
  tf_spinner_.start();
  for (const std::string& note : setup_.mechanism->notes()) ROS_INFO_STREAM(note);
  advertise();
  subscribe();
  if (setup_.options.guard.enabled) start_guard();
  if (setup_.options.probe.enabled.value_or(has_probe_handle())) start_probe();
  accept_reconfiguration();
  state_.publish(
      unknown_state(*setup_.mechanism->manipulator(), monitor_.current(ros::Time::now()).status, {}));
  tracking_spinner_.start();
  service_spinner_.start();
  work_spinner_.start();
  // Last, so that no message waits until the others are done, and is taken for old.
  subscriber_ = joint_states_nh_.subscribe("joint_states", 1000, &RobotServer::on_joint_states, this,
                                           ros::TransportHints().tcpNoDelay());
  first_map_ = worker_.compute(setup_.options.map, FileUse::load);
}

RobotServer::~RobotServer() {
  log_timer_.stop();
  stop_probe();
  stopping_ = true;
  workspaces_.cancel();
  subscriber_.shutdown();
  command_subscriber_.shutdown();
  if (compute_map_) compute_map_->shutdown();
  if (plan_path_) plan_path_->shutdown();
  tracking_spinner_.stop();
  service_spinner_.stop();
  work_spinner_.stop();
  tf_spinner_.stop();
}

NodeSetup RobotServer::setup() const {
  NodeSetup setup = setup_;
  setup.options = reconfiguration_->in_force(std::move(setup.options));
  return setup;
}

void RobotServer::advertise() {
  serve<GetWorkingMode>("get_working_mode", queries_);
  serve<GetCurrentAspect>("get_current_aspect", queries_);
  serve<GetSingularityDistance>("get_singularity_distance", queries_);
  serve<GetJacobian>("get_jacobian", queries_);
  serve<ListAspects>("list_aspects", queries_);
  serve<GetMap>("get_map", maps_);
  serve<GetRegularWorkspace>("get_regular_workspace", workspaces_);
  serve<SetAssemblyMode>("set_assembly_mode", queries_);
  serve<ChooseWorkingMode>("choose_working_mode", motions_);
  serve<Connect>("connect", motions_);
  serve<CheckTrajectory>("check_trajectory", motions_);
  compute_map_ = std::make_unique<ComputeMapServer>(
      goals_.server_handle(), "compute_map",
      [this](const ComputeMapGoalConstPtr& goal) { on_compute_map(goal); }, false);
  compute_map_->start();
  cancel_subscriber_ = service_nh_.subscribe("compute_map/cancel", 10, &RobotServer::on_cancel_map, this);
  plan_path_ = std::make_unique<PlanServer>(
      service_nh_, setup_, monitor_, worker_,
      [this](const auto& pose, std::string& message) { return to_base(pose, message); });
}

void RobotServer::subscribe() {
  tf_subscriber_ = service_nh_.subscribe("/tf", 1000, &RobotServer::on_tf, this);
  tf_static_subscriber_ = service_nh_.subscribe("/tf_static", 1000, &RobotServer::on_tf_static, this);
  // By the wall clock: a simulation that stands still, or begins anew, must not silence these.
  age_timer_ = tracking_nh_.createSteadyTimer(ros::WallDuration(setup_.options.joint_states_timeout / 4.0),
                                              [this](const ros::SteadyTimerEvent&) { check_age(); });
  work_timer_ = work_nh_.createWallTimer(ros::WallDuration(1.0 / setup_.options.distance_rate),
                                         [this](const ros::WallTimerEvent&) { work(); });
  display_timer_ = service_nh_.createWallTimer(ros::WallDuration(1.0 / setup_.options.display.rate),
                                               [this](const ros::WallTimerEvent&) { show(); });
  diagnostics_timer_ =
      service_nh_.createWallTimer(ros::WallDuration(diagnostics_.period()),
                                  [this](const ros::WallTimerEvent&) { diagnostics_.publish(); });
  stand_off_timer_ = service_nh_.createWallTimer(
      ros::WallDuration(0.0), [this](const ros::WallTimerEvent&) { report_stand_off(); }, true);
  silence_timer_ = service_nh_.createWallTimer(
      until_silence, [this](const ros::WallTimerEvent&) { report_silence(); }, true);
  log_timer_ = service_nh_.createWallTimer(ros::WallDuration(0.1), [this](const ros::WallTimerEvent&) {
    log_.write();
    for (const std::string& message : frame_watch_.news(ros::WallTime::now())) ROS_WARN_STREAM(message);
  });
}

// In the thread of joint_states, for what a command may do depends on the last of these.
void RobotServer::start_guard() {
  guarded_velocity_ = tracking_nh_.advertise<geometry_msgs::TwistStamped>("guarded_velocity", 10);
  guarded_joint_velocities_ =
      tracking_nh_.advertise<std_msgs::Float64MultiArray>("guarded_joint_velocities", 10);
  command_subscriber_ = tracking_nh_.subscribe("velocity_command", 1, &RobotServer::on_velocity_command, this,
                                               ros::TransportHints().tcpNoDelay());
  command_timer_ = tracking_nh_.createSteadyTimer(
      ros::WallDuration(setup_.options.guard.command_timeout / 4.0), [this](const ros::SteadyTimerEvent&) {
        if (const auto zero = monitor_.expire_command(ros::Time::now(), ros::SteadyTime::now()))
          publish_guarded(*zero);
      });
}

void RobotServer::start_probe() {
  ProbeSources sources;
  sources.aspects = [this] { return worker_.known(); };
  sources.present = [this] { return monitor_.current(ros::Time::now()); };
  sources.section = [this] { return display_.section(); };
  sources.dots = [this](const DrawnConfiguration& other) { return display_.dots_of(other); };
  probe_ = std::make_unique<Probe>(setup_, service_nh_, std::move(sources));
}

// The thread of the map may be about to renew it.
void RobotServer::stop_probe() {
  std::unique_ptr<Probe> last;
  const std::lock_guard<std::mutex> lock(probe_mutex_);
  last = std::move(probe_);
}

void RobotServer::on_velocity_command(const geometry_msgs::TwistStamped& command) {
  publish_guarded(monitor_.guard(command, turned(command), ros::Time::now(), ros::SteadyTime::now()));
}

void RobotServer::publish_guarded(const GuardedCommand& command) {
  guarded_velocity_.publish(command.twist);
  guarded_joint_velocities_.publish(command.joint_velocities);
  if (!command.warning.empty()) log_.warn(command.warning);
}

// By the last transform that is known, for there is no time to wait for another.
TurnedTwist RobotServer::turned(const geometry_msgs::TwistStamped& command) const {
  const std::string& base = setup_.mechanism->manipulator()->base_frame();
  const std::string& frame = command.header.frame_id;
  if (frame.empty() || frame == base) return turned_twist(command.twist, Eigen::Matrix3d::Identity());
  try {
    const geometry_msgs::Quaternion q = tf_.lookupTransform(base, frame, ros::Time(0)).transform.rotation;
    return turned_twist(command.twist, Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix());
  } catch (const std::runtime_error& failure) {
    TurnedTwist unknown;
    unknown.fault = no_transform(frame, failure);
    return unknown;
  }
}

std::string RobotServer::no_transform(const std::string& frame, const std::exception& failure) const {
  const std::string& base = setup_.mechanism->manipulator()->base_frame();
  std::vector<std::string> frames;
  tf_._getFrameStrings(frames);
  frames.push_back(base);
  const bool known = contains(frames, frame);
  const std::string meant = known ? "" : similar_name(frame, frames);
  return "tf does not connect " + shortened(frame) + " with " + base + ": " +
         (meant.empty() ? shortened(failure.what()) : "it does not know it; did you mean '" + meant + "'?");
}

void RobotServer::accept_reconfiguration() {
  // For whoever shows the distances of ~state, and states thresholds.
  service_nh_.setParam("distance_unit", DistanceUnit(*setup_.mechanism->manipulator()).name());
  reconfiguration_ = std::make_unique<Reconfiguration>(
      service_nh_, setup_.options,
      [this](const ThresholdParameters& wanted) {
        monitor_.set_thresholds(thresholds_of(wanted, DistanceUnit(*setup_.mechanism->manipulator())));
      },
      [this](const DisplayOptions& wanted) {
        display_.set_options(wanted);
        display_timer_.setPeriod(ros::WallDuration(1.0 / wanted.rate));
      });
}

// A service that was reached returns true: what became of the request is in the response.
template <typename Service, typename Answers>
void RobotServer::serve(const std::string& name, const Answers& answers) {
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  const boost::function<bool(Request&, Response&)> callback = [&answers](Request& request,
                                                                         Response& response) {
    response = answers.answer(request);
    return true;
  };
  services_.push_back(service_nh_.advertiseService(name, callback));
}

// The state goes out before anything else is worked out.
void RobotServer::on_joint_states(const ros::MessageEvent<const sensor_msgs::JointState>& event) {
  monitor_.beat(ros::SteadyTime::now());
  const MonitorUpdate update =
      monitor_.update(*event.getConstMessage(), ros::Time::now(), event.getPublisherName());
  if (!update.warning.empty()) log_.warn(update.warning);
  if (!update.state) return;
  if (update.warning.empty() && update.state->status.code == Status::OK) log_.withdraw();
  const bool other_joints = update.state->status.code == Status::NO_JOINT_STATES;  // said when names are new
  const bool changed = thinned_.differs(*update.state) || other_joints || !update.transitions.empty();
  if (changed && update.warning.empty() && !update.state->status.message.empty())
    log_.warn(update.state->status.message);
  if (thinned_.next() || changed) {
    state_.publish(*update.state);
    diagnostics_.count_output();
  }
  for (const AspectTransition& transition : update.transitions) {
    transitions_.publish(transition);
    last_transition_.publish(transition);
    if (transition.kind == AspectTransition::UNIQUENESS && !transition.domain_shared)
      log_.warn(transition.message);
    else
      log_.say(transition.message);
  }
  if (update.tracked && (completed_.next() || changed))
    publish_robot(*update.tracked, update.state->header.stamp);
}

void RobotServer::on_tf(const Transforms& event) { watch(event, FrameWatch::Topic::tf); }

void RobotServer::on_tf_static(const Transforms& event) { watch(event, FrameWatch::Topic::tf_static); }

void RobotServer::watch(const Transforms& event, FrameWatch::Topic topic) {
  const ros::WallTime now = ros::WallTime::now();
  for (const geometry_msgs::TransformStamped& transform : event.getConstMessage()->transforms)
    frame_watch_.hear(transform.child_frame_id, event.getPublisherName(), topic, now);
}

void RobotServer::publish_robot(const TrackedState& tracked, const ros::Time& stamp) {
  if (const auto completed = monitor_.complete(tracked, stamp)) joint_states_.publish(*completed);
  send_platform(platform_in_base(*setup_.mechanism->manipulator(), tracked.pose), stamp);
}

void RobotServer::send_platform(const Eigen::Isometry3d& platform, const ros::Time& stamp) {
  geometry_msgs::TransformStamped message;
  message.header.frame_id = setup_.mechanism->manipulator()->base_frame();
  message.header.stamp = stamp;
  message.child_frame_id = setup_.options.frame_prefix + "/" + setup_.mechanism->platform_frame();
  message.transform = transform_message(platform);
  tf_broadcaster_.sendTransform(message);
}

void RobotServer::check_age() {
  const auto state = monitor_.expire(ros::Time::now(), ros::SteadyTime::now());
  if (!state) return;
  log_.warn(state->status.message);
  state_.publish(*state);
  diagnostics_.count_output();
}

void RobotServer::work() {
  monitor_.set_distance_map(worker_.known().distances_of(setup_.mechanism->manipulator()));
  monitor_.set_domains(worker_.domains());
  const auto candidates = monitor_.work();
  if (!candidates) return;
  candidates_.publish(*candidates);
  display_.set_candidates(*candidates);
}

// Takes some tenths of a second, so it is not for the constructor.
void RobotServer::report_stand_off() {
  const StandOffEstimate estimate =
      estimate_stand_off(setup_.mechanism->manipulator(), setup_.options.tracking.samples, 50, ros::ok);
  const DistanceUnit unit = DistanceUnit(*setup_.mechanism->manipulator());
  const DistanceThresholds::Options thresholds = thresholds_of(setup_.options.thresholds, unit);
  const std::string warning =
      warning_of(estimate, thresholds[static_cast<std::size_t>(Hazard::parallel_singularity)].stop, unit);
  if (estimate.poses > 0) ROS_INFO_STREAM(message_of(estimate, unit));
  if (!warning.empty()) ROS_WARN_STREAM(warning);
  const std::string offer = threshold_offer(*setup_.mechanism, estimate);
  diagnostics_.offer(offer);
  if (unit.is_angle() && is_set(thresholds))
    ROS_INFO_STREAM("The thresholds of this robot are angles [rad], as all its axes meet.");
  if (!is_set(thresholds)) ROS_WARN_STREAM(offer);
}

void RobotServer::report_silence() {
  const MonitorCounts counts = monitor_.counts();
  if (counts.usable + counts.invalid + counts.foreign > 0) return;
  const std::uint32_t publishers = subscriber_.getNumPublishers();
  const std::string who = publishers == 0 ? "No node publishes it; start the driver, or remap joint_states."
                                          : "Nodes that publish it: " + std::to_string(publishers) + ".";
  ROS_WARN_STREAM(monitor_.current(ros::Time::now()).status.message << " " << who);
}

void RobotServer::show() { display_.show(monitor_.current(ros::Time::now()), worker_.progress().message); }

void RobotServer::on_map_progress(const MapProgress& progress, const std::shared_ptr<const AspectMap>& map) {
  if (map) {
    monitor_.set_map(map);
    display_.set_map(map);
    display_.set_domains(nullptr);  // those were of the map before
    if (map->aspects().empty())
      ROS_WARN_STREAM(progress.message);
    else
      ROS_INFO_STREAM(progress.message << "\n" << aspect_table(*map));
  } else if (progress.state == MapProgress::COMPLETE) {
    ROS_INFO_STREAM(progress.message);
  } else if (progress.state == MapProgress::REFUSED) {
    ROS_WARN_STREAM("The map was not computed: " << progress.message);
  } else {
    ROS_INFO_STREAM_THROTTLE(1.0, progress.message);
  }
  map_progress_.publish(progress);
  if (progress.state != MapProgress::COMPLETE) return;
  const std::lock_guard<std::mutex> lock(probe_mutex_);
  if (probe_) probe_->renew();
}

// Without a goal's name everything is cancelled, and with it the map that no goal has asked for.
void RobotServer::on_cancel_map(const actionlib_msgs::GoalID& goal) {
  if (goal.id.empty() && goal.stamp.isZero() && !setup_.options.read_only) worker_.cancel(first_map_);
}

Status RobotServer::status_of_goal(const MapOptions& options) const {
  if (setup_.options.read_only) return refused_as_read_only();
  const Problems problems = problems_of(options, *setup_.mechanism->manipulator(), "goal/");
  return problems.empty() ? Status() : invalid_request(problems.front());
}

// The map file is of the node's own options; a map of others does not go there. One that is complete besides
// serves them as well.
void RobotServer::on_compute_map(const ComputeMapGoalConstPtr& goal) {
  ComputeMapResult result;
  result.count_at_most = -1;
  MapOptions options = setup_.options.map;
  if (goal->resolution != 0.0) options.resolution = goal->resolution;
  if (goal->extra_levels != 0) options.extra_levels = goal->extra_levels;
  options.complete = options.complete || goal->complete;
  result.status = status_of_goal(options);
  if (result.status.code != Status::OK) {
    std::this_thread::sleep_for(before_refusal);
    compute_map_->setAborted(result, result.status.message);
    return;
  }
  const bool as_configured = goal->resolution == 0.0 && goal->extra_levels == 0;
  finish(wait_for_map(worker_.compute(options, as_configured ? FileUse::save : FileUse::none)), result);
}

// What became of the computation, or that it was cancelled; feedback until then.
MapProgress RobotServer::wait_for_map(MapWorker::Job job) {
  ComputeMapFeedback feedback;
  int polls_since_cancel = 0;
  do {
    const bool cancel = stopping_ || compute_map_->isPreemptRequested();
    if (cancel) worker_.cancel(job);
    feedback.progress = worker_.wait(job, std::chrono::milliseconds(20));
    compute_map_->publishFeedback(feedback);
    polls_since_cancel += cancel ? 1 : 0;
  } while (feedback.progress.state == MapProgress::COMPUTING && polls_since_cancel < 3 && !stopping_);
  if (polls_since_cancel > 0 && feedback.progress.state == MapProgress::COMPUTING) {
    // The thread ends its piece of work; what it finds is not used.
    feedback.progress.state = MapProgress::CANCELLED;
    feedback.progress.message = "The computation was cancelled.";
  }
  return feedback.progress;
}

void RobotServer::finish(const MapProgress& progress, ComputeMapResult result) {
  if (progress.state == MapProgress::COMPLETE) {
    if (const auto map = worker_.map()) result.aspects = summary_messages(map);
    result.proved_count = progress.proved_count;
    result.count_at_most = progress.count_at_most;
    result.seconds = progress.seconds;
    return compute_map_->setSucceeded(result, progress.message);
  }
  const bool cancelled = progress.state == MapProgress::CANCELLED;
  result.status = make_status(cancelled ? Status::CANCELLED : Status::FAILED, progress.message);
  if (cancelled && compute_map_->isPreemptRequested())
    return compute_map_->setPreempted(result, progress.message);
  compute_map_->setAborted(result, progress.message);
}

std::optional<geometry_msgs::Pose> RobotServer::to_base(const geometry_msgs::PoseStamped& pose,
                                                        std::string& message) const {
  const std::string& base = setup_.mechanism->manipulator()->base_frame();
  if (pose.header.frame_id.empty() || pose.header.frame_id == base) return pose.pose;
  geometry_msgs::PoseStamped given = pose;
  const geometry_msgs::Quaternion& q = given.pose.orientation;
  if (q.x == 0.0 && q.y == 0.0 && q.z == 0.0 && q.w == 0.0) given.pose.orientation.w = 1.0;
  try {
    return tf_.transform(given, base, ros::Duration(setup_.options.tf_timeout)).pose;
  } catch (const std::runtime_error& failure) {  // of tf2, or of a time that no clock has
    message = no_transform(given.header.frame_id, failure);
    return std::nullopt;
  }
}

}  // namespace parallel_aspects
