// SPDX-License-Identifier: BSD-3-Clause
#include "ros/probe/probe.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/messages/configurations.h"
#include "ros/pictures/marker_batch.h"
#include "ros/pictures/scene.h"

#include <parallel_aspects/Configuration.h>

#include <ros/console.h>

#include <chrono>
#include <geometry_msgs/PoseStamped.h>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::chrono::milliseconds between_looks(200);  // at the section that aspects are drawn at

ros::NodeHandle on_queue(const ros::NodeHandle& parent, ros::CallbackQueue& queue) {
  ros::NodeHandle nh(parent, "probe");
  nh.setCallbackQueue(&queue);
  return nh;
}

// The working mode that the mechanism was recognised in, unless only another one reaches the start.
ProbeQuestion question_at_start(const Mechanism& mechanism, const StartOptions& start) {
  const Manipulator& robot = *mechanism.manipulator();
  const AssembledConfiguration assembled = mechanism.assembled();
  ProbeQuestion question{start_pose(mechanism, start), working_modes(robot).front(), false};
  if (const auto mode = working_mode(robot, assembled.pose, assembled.q)) question.mode = *mode;
  if (inverse(robot, question.wanted, question.mode)) return question;
  for (const InverseSolution& solution : inverse_in_all_modes(robot, question.wanted))
    if (solution) question.mode = solution.mode;
  return question;
}

}  // namespace

Probe::Probe(const NodeSetup& setup, const ros::NodeHandle& private_nh, ProbeSources sources)
    : mechanism_(setup.mechanism),
      robot_(*mechanism_->manipulator()),
      sources_(std::move(sources)),
      period_(1.0 / setup.options.probe.rate),
      solver_(mechanism_->manipulator()),
      picture_(mechanism_, setup.urdf, setup.options),
      start_(question_at_start(*mechanism_, setup.options.start)),
      nh_(on_queue(private_nh, queue_)),
      pose_(nh_.advertise<geometry_msgs::PoseStamped>("pose", 10, true)),
      state_(nh_.advertise<ProbeState>("state", 10, true)),
      markers_(nh_.advertise<visualization_msgs::MarkerArray>("markers", 1, true)),
      stored_start_(nh_.advertise<Configuration>("start", 1, true)),
      stored_goal_(nh_.advertise<Configuration>("goal", 1, true)),
      spinner_(1, &queue_) {
  handle_ = std::make_unique<ProbeHandle>(nh_.resolveName("handle"), robot_,
                                          pose_message(platform_in_base(robot_, start_.wanted)),
                                          setup.options.display.radius, handle_events());
  if (!has_probe_handle())
    ROS_INFO_STREAM(
        "The probe has no handle in rviz, for the package was built without interactive_markers.");
  markers_.publish(MarkerBatch().take());  // removes what a node before this one left in rviz
  subscribe();
  worker_ = std::thread([this] { run(); });
  spinner_.start();
}

Probe::~Probe() {
  spinner_.stop();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  worker_.join();
  handle_.reset();
}

void Probe::renew() { work_out(); }

HandleEvents Probe::handle_events() {
  HandleEvents events;
  events.dragged = [this](const geometry_msgs::Pose& pose) { want_pose(pose, "the handle", true); };
  events.released = [this] {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      dragged_ = false;
    }
    work_out();
  };
  events.mode_chosen = [this](const WorkingMode& mode) { set_mode(mode); };
  events.leg_toggled = [this](std::size_t leg) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      WorkingMode& mode = question().mode;
      mode.set_sign(leg, -mode.sign(leg));
    }
    work_out();
  };
  events.others_toggled = [this] {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      question().others = !question().others;
    }
    work_out();
  };
  events.stored_as_start = [this] { store(stored_start_); };
  events.stored_as_goal = [this] { store(stored_goal_); };
  events.reset = [this] { want_present(); };
  events.hidden = [this] {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!question_) return;
      start_ = *question_;
      question_.reset();
      fresh_ = true;
    }
    changed_.notify_all();
  };
  return events;
}

void Probe::subscribe() {
  // One alone waits: what is newest is asked.
  const boost::function<void(const geometry_msgs::PoseConstPtr&)> on_pose =
      [this](const geometry_msgs::PoseConstPtr& pose) {
        want_pose(*pose, pose_subscriber_.getTopic(), false);
      };
  const boost::function<void(const std_msgs::Int8MultiArrayConstPtr&)> on_mode =
      [this](const std_msgs::Int8MultiArrayConstPtr& mode) { want_mode(*mode); };
  pose_subscriber_ = nh_.subscribe<geometry_msgs::Pose>("set_pose", 1, on_pose);
  mode_subscriber_ = nh_.subscribe<std_msgs::Int8MultiArray>("working_mode", 1, on_mode);
}

void Probe::want_pose(const geometry_msgs::Pose& pose, const std::string& from, bool dragged) {
  const std::string fault = fault_of(pose);
  if (!fault.empty()) {
    ROS_WARN_STREAM_THROTTLE(1.0, "A pose of the probe, from " << from << ", was refused: " << fault);
    return;
  }
  const auto wanted = pose_from_base(robot_, pose);
  if (!wanted) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    question().wanted = *wanted;
    dragged_ = dragged;
  }
  work_out();
}

void Probe::want_mode(const std_msgs::Int8MultiArray& message) {
  const auto mode = stated_mode(message.data);
  if (mode && is_mode_of(robot_, message.data)) return set_mode(*mode);
  std::string modes;
  for (const WorkingMode& mode : working_modes(robot_)) {
    if (modes.size() > 100) {
      modes += ", ...";
      break;
    }
    modes += (modes.empty() ? "" : ", ") + to_string(mode);
  }
  ROS_WARN_STREAM_THROTTLE(1.0, "A working mode on " << mode_subscriber_.getTopic()
                                                     << " was refused: it needs " << robot_.leg_count()
                                                     << " signs, each 1 or -1, of one of " << modes << ".");
}

void Probe::set_mode(const WorkingMode& mode) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    question().mode = mode;
  }
  work_out();
}

void Probe::want_present() {
  const CurrentConfiguration present = sources_.present();
  if (present.status.code != Status::OK) {
    ROS_WARN_STREAM(
        "The probe stays where it is, for the pose of the robot is not known: " << present.status.message);
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    question().wanted = present.solved.pose;
    question().mode = present.tracked.mode;
    dragged_ = false;
  }
  work_out();
}

void Probe::store(const ros::Publisher& where) {
  Configuration stored;
  stored.kind = Configuration::POSE;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (reached_) {
      stored.pose.pose = *reached_;
      stored.working_mode = signs_message(reached_mode_);
    }
  }
  if (stored.working_mode.empty()) {
    ROS_WARN_STREAM("Nothing is stored on " << where.getTopic()
                                            << ": the probe has no pose yet; drag it first.");
    return;
  }
  stored.pose.header.frame_id = robot_.base_frame();
  where.publish(stored);
}

// Under the lock. The first time it is in the working mode of the robot, where that is known.
ProbeQuestion& Probe::question() {
  if (question_) return *question_;
  question_ = start_;
  const CurrentConfiguration present = sources_.present();
  if (!reached_ && present.status.code == Status::OK) question_->mode = present.tracked.mode;
  return *question_;
}

void Probe::work_out() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!question_) return;
    fresh_ = true;
  }
  changed_.notify_all();
}

void Probe::run() {
  while (const auto wish = next_wish()) {
    const auto next = std::chrono::steady_clock::now() + std::chrono::duration<double>(period_.toSec());
    answer(*wish);
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_until(lock, next, [this] { return stopping_; });
  }
}

std::optional<Probe::Wish> Probe::next_wish() {
  const auto is_due = [this] { return stopping_ || fresh_; };
  for (;;) {
    {
      std::unique_lock<std::mutex> lock(mutex_);
      if (!question_) changed_.wait(lock, is_due);
      if (changed_.wait_for(lock, between_looks, is_due)) {
        if (stopping_) return std::nullopt;
        fresh_ = false;
        return Wish{question_.value_or(start_), !question_, dragged_};
      }
    }
    if (is_outdated()) work_out();
  }
}

std::optional<PoseSlice> Probe::section_beside(const Pose& pose) const {
  const auto section = sources_.section();
  return section && !is_near(robot_, *section, pose) ? section : std::nullopt;
}

// As the robot takes the section along while the probe stays.
bool Probe::is_outdated() const {
  if (!drawn_) return false;
  const auto section = section_beside(*drawn_);
  if (!section || !section_) return section.has_value() != section_.has_value();
  return section->text() != section_->text();
}

void Probe::answer(const Wish& wish) {
  drawn_.reset();
  if (wish.hide) return markers_.publish(picture_.none());
  ProbeFinding finding = solver_.find(wish.question, sources_.aspects(), ros::Time::now());
  if (finding.reached) {
    drawn_ = finding.reached->pose;
    section_ = finding.section = section_beside(*drawn_);
    const geometry_msgs::Pose reached = finding.state.report.configuration.pose;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      reached_ = reached;
      reached_mode_ = wish.question.mode;
    }
    geometry_msgs::PoseStamped message;
    message.header = finding.state.header;
    message.pose = reached;
    pose_.publish(message);
    if (!wish.dragged) handle_->move_to(reached);
  }
  state_.publish(finding.state);
  markers_.publish(picture_.of(finding, dots_of(finding)));
  handle_->tick(wish.question.mode, wish.question.others);
}

std::vector<visualization_msgs::Marker> Probe::dots_of(const ProbeFinding& finding) const {
  // Beside the place that is wanted, dots of the nearest one would be taken for it.
  if (!finding.reached || finding.reached->distance > 0.0) return {};
  auto dots = sources_.dots({finding.question.mode,
                             static_cast<int>(finding.state.report.configuration.aspect),
                             {finding.reached->pose, finding.reached->q}});
  for (visualization_msgs::Marker& dot : dots) {
    dot.ns = "probe/" + dot.ns;
    dot.color = color(0xE07B00);  // as the handle
  }
  return dots;
}

}  // namespace parallel_aspects
