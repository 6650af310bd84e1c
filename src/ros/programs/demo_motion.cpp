// SPDX-License-Identifier: BSD-3-Clause
//
// Plays joint_states of the actuated joints, for any robot that aspect_node serves. It begins with a local
// motion about the start pose, which needs no map. Once the node's map is complete, it plans a tour through
// every aspect that can be reached without crossing det A = 0, and goes over to it at the end of a round.
// Last comes a pick and place that the aspect of the start cannot do, with the reason in the log. Parameters:
// ~server (name of that node), ~duration of one round of the tour [s], ~local_duration of one round of the
// local motion [s], ~task_duration of the pick and place [s], ~loop (until shut down; or until tour and task
// are over, or one local round where there are none), ~patience: no tour of a map that took longer than this,
// as it is computed again here [s].
#include "motion/demo_rounds.h"
#include "motion/plan/pick_and_place.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"
#include "ros/parameters/load_options.h"

#include <parallel_aspects/MapProgress.h>

#include <ros/ros.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <future>
#include <iterator>
#include <memory>
#include <optional>
#include <sensor_msgs/JointState.h>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double interval = 0.01;          // from one joint_states to the next [s]
constexpr double seconds_to_start = 60.0;  // until the node must listen
constexpr double longest_delay = 5.0;      // of a sample behind its time; then time is set anew [s]

struct Start {
  Pose pose;
  WorkingMode mode;
};

struct DemoOptions {
  std::string server;
  double duration, local_duration, task_duration, patience;
  bool loop;
};

DemoOptions options_from(const ros::NodeHandle& private_nh) {
  return {private_nh.param<std::string>("server", "aspect_node"),
          private_nh.param("duration", 60.0),
          private_nh.param("local_duration", 20.0),
          private_nh.param("task_duration", 20.0),
          private_nh.param("patience", 60.0),
          private_nh.param("loop", true)};
}

bool closes(const Mechanism& mechanism, const Pose& pose, const JointVector& q) {
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism.joint_names().size()));
  return mechanism.complete(pose, q, positions);
}

// Where the robot is when the demo begins: the pose that the parameters say, in every working mode that
// assembles there; first the one that the mechanism was recognised in, then falling distance from
// singularities.
std::vector<Start> possible_starts(const Mechanism& mechanism, const StartOptions& options) {
  const Manipulator& robot = *mechanism.manipulator();
  const AssembledConfiguration assembled = mechanism.assembled();
  Pose pose = assembled.pose;
  if (options.pose) {
    const Eigen::Map<const Eigen::VectorXd> values(options.pose->data(),
                                                   static_cast<Eigen::Index>(options.pose->size()));
    pose = pose_from_coordinates(robot.motions(), values).value_or(pose);
  }
  const auto usual = working_mode(robot, assembled.pose, assembled.q);
  std::vector<std::pair<double, Start>> starts;
  for (const InverseSolution& solution : inverse_in_all_modes(robot, pose)) {
    if (solution.status != InverseStatus::solved) continue;
    const SingularityIndices indices = singularity_indices(robot, pose, solution.q);
    if (options.determinant_sign && *options.determinant_sign * indices.determinant <= 0.0) continue;
    const double rank = indices.smallest_singular_value + (usual && solution.mode == *usual ? 1e3 : 0.0);
    starts.push_back({rank, {pose, solution.mode}});
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Start> result;
  for (const auto& ranked : starts) result.push_back(ranked.second);
  return result;
}

// A round about the start, and what the tracker has seen once it was played.
struct LocalMotion {
  Start start;
  SampledMotion motion;
  Rehearsal rehearsal;
};

// As wide as the node's own tracker follows it from there, with what encoders may be off by.
std::optional<LocalMotion> plan_local(const NodeSetup& setup, const Start& start, double duration) {
  const Mechanism& mechanism = *setup.mechanism;
  const auto allowed = [&](const Pose& pose, const JointVector& q) { return closes(mechanism, pose, q); };
  for (double amplitude = widest_local_motion; amplitude > narrowest_local_motion; amplitude *= 0.5) {
    const auto corners =
        plan_local_motion(*mechanism.manipulator(), start.pose, start.mode, allowed, amplitude);
    Rehearsal rehearsal(mechanism.manipulator(), setup.options.tracking, interval);
    if (corners.size() < 2 || !rehearsal.start(start.pose, corners.front())) return std::nullopt;
    SampledMotion motion = rehearsal.slow_enough(corners, duration);
    if (!motion.samples.empty() && rehearsal.play(motion))
      return LocalMotion{start, std::move(motion), std::move(rehearsal)};
  }
  return std::nullopt;
}

// In the first start that leaves room to move.
std::optional<LocalMotion> plan_local(const NodeSetup& setup, double duration) {
  for (const Start& start : possible_starts(*setup.mechanism, setup.options.start))
    if (auto local = plan_local(setup, start, duration)) return local;
  return std::nullopt;
}

std::string text(const std::vector<int>& aspects) {
  std::string result;
  for (const int aspect : aspects) result += (result.empty() ? "" : " - ") + std::to_string(aspect);
  return result;
}

// A motion, and the text that is logged when it begins.
struct Act {
  SampledMotion motion;
  std::string text;
};

// Plans the acts that need a map on a thread of its own, once the node has its own.
class ActPlanner {
 public:
  ActPlanner(ros::NodeHandle nh, NodeSetup setup, LocalMotion local, const DemoOptions& options)
      : nh_(std::move(nh)), setup_(std::move(setup)), local_(std::move(local)), options_(options) {
    subscriber_ = nh_.subscribe(options.server + "/map_progress", 10, &ActPlanner::on_progress, this);
  }
  ~ActPlanner() { cancelled_ = too_late_ = true; }

  // Whether no more acts come than can be taken.
  bool is_done() const { return is_done_; }

  // Those that were planned since the last time.
  std::vector<Act> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(acts_, {});
  }

 private:
  void on_progress(const MapProgress::ConstPtr& progress) {
    if (is_done_ || thread_.valid() || progress->state == MapProgress::COMPUTING) return;
    is_done_ = progress->state != MapProgress::COMPLETE || progress->seconds > options_.patience;
    if (is_done_) return;
    const ros::WallDuration patience(options_.patience);
    timer_ = nh_.createWallTimer(
        patience, [this](const ros::WallTimerEvent&) { too_late_ = true; }, true);
    thread_ = std::async(std::launch::async, [this] {
      plan();
      is_done_ = true;
    });
  }

  void plan() {
    MapControl control;
    control.cancelled = &cancelled_;
    const auto map =
        compute_aspect_map(setup_.mechanism->mapped_manipulator(), setup_.options.map, control).map;
    if (!map) return;
    add(tour(*map));
    add(task(map));
  }

  void add(Act act) {
    if (act.motion.samples.empty()) {
      if (!act.text.empty()) ROS_INFO_STREAM(act.text);
      return;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    acts_.push_back(std::move(act));
  }

  Act tour(const AspectMap& map) const {
    const Tour tour = plan_tour(map, local_.start.pose, local_.start.mode);
    if (tour.joint_values.size() < 2) return {};
    SampledMotion motion = local_.rehearsal.slow_enough(tour.joint_values, options_.duration);
    if (motion.samples.empty()) {
      ROS_WARN("There is no tour: a tracker with the options of the node does not follow it at any speed.");
      return {};
    }
    const double seconds = interval * static_cast<double>(motion.samples.size());
    std::ostringstream said;
    said << "The motion visits aspects " << text(tour.aspects) << ", in " << seconds << " s.";
    return {std::move(motion), said.str()};
  }

  Act task(const std::shared_ptr<const AspectMap>& map) const {
    MapControl control;
    control.cancelled = &too_late_;
    SampledMotion motion;
    const auto accepts = [&](const std::vector<JointVector>& corners) {
      motion = local_.rehearsal.slow_enough(corners, options_.task_duration);
      return !motion.samples.empty();
    };
    PickAndPlace task = plan_pick_and_place(map, local_.start.pose, local_.start.mode, accepts, control);
    return {std::move(motion), std::move(task.reason)};
  }

  ros::NodeHandle nh_;
  const NodeSetup setup_;
  const LocalMotion local_;
  const DemoOptions options_;
  std::atomic<bool> cancelled_{false}, too_late_{false}, is_done_{false};
  std::mutex mutex_;
  std::vector<Act> acts_;
  ros::WallTimer timer_;
  ros::Subscriber subscriber_;
  std::future<void> thread_;  // waits for its end first
};

// Publishes one motion after the other. Every sample is sent, with stamps at even times: what was rehearsed
// is what the node gets. On a busy computer some come late, and then the next ones at once.
class Player {
 public:
  Player(const Manipulator& robot, ros::Publisher publisher)
      : publisher_(std::move(publisher)),
        offset_(JointVector::Zero(static_cast<Eigen::Index>(robot.leg_count()))) {
    for (const Leg& leg : robot.legs()) message_.name.push_back(leg.actuated_joint);
  }

  // One round; returns early when ROS shuts down.
  void play(const SampledMotion& motion) {
    for (const JointVector& sample : motion.samples) {
      if (!ros::ok()) return;
      wait();
      publish(sample + offset_);
      ros::spinOnce();
    }
    offset_ += motion.gain;
  }

 private:
  // Until the time of the next stamp.
  void wait() {
    const ros::Time now = ros::Time::now();
    next_ += ros::Duration(interval);
    if (std::abs((now - next_).toSec()) > longest_delay) next_ = now;
    ros::Time::sleepUntil(next_);
  }

  void publish(const JointVector& q) {
    message_.header.stamp = next_;
    message_.position.assign(q.data(), q.data() + q.size());
    publisher_.publish(message_);
  }

  ros::Publisher publisher_;
  sensor_msgs::JointState message_;
  ros::Time next_;
  JointVector offset_;  // turns made so far
};

bool wait_for_server(const std::string& server, const ros::Publisher& publisher) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(seconds_to_start);
  while (ros::ok() && ros::WallTime::now() < deadline) {
    if (publisher.getNumSubscribers() > 0) return true;
    ros::WallDuration(0.05).sleep();
  }
  ROS_FATAL_STREAM("The node " << server << " did not listen within " << seconds_to_start << " s.");
  return false;
}

void play(Act& act, Player& player) {
  if (!act.text.empty()) ROS_INFO_STREAM(act.text);
  act.text.clear();  // logged once
  player.play(act.motion);
}

// The local motion until there are others; then these, in their order, or each once.
void play_all(SampledMotion local, ActPlanner& planner, bool loop, Player& player) {
  std::vector<Act> acts{{std::move(local), ""}};
  bool any_planned = false;
  while (ros::ok()) {
    const bool is_last = planner.is_done();
    std::vector<Act> planned = planner.take();
    if (is_last && !loop && any_planned && planned.empty()) return;
    if (!planned.empty() && (!loop || !any_planned)) acts.clear();
    any_planned = any_planned || !planned.empty();
    std::move(planned.begin(), planned.end(), std::back_inserter(acts));
    for (Act& act : acts) play(act, player);
    if (is_last && !loop) return;
  }
}

int run(ros::NodeHandle nh, const ros::NodeHandle& private_nh) {
  const DemoOptions options = options_from(private_nh);
  const NodeSetup setup = load_setup(nh, ros::NodeHandle(options.server));
  const auto local = plan_local(setup, options.local_duration);
  if (!local) {
    ROS_FATAL(
        "No motion: the robot does not assemble at the start that the parameters say, or not clear of "
        "singularities; set start/pose to another pose.");
    return EXIT_FAILURE;
  }
  const ros::Publisher publisher = nh.advertise<sensor_msgs::JointState>("joint_states", 1000);
  if (!wait_for_server(options.server, publisher)) return EXIT_FAILURE;
  ActPlanner planner(nh, setup, *local, options);
  Player player(*setup.mechanism->manipulator(), publisher);
  play_all(local->motion, planner, options.loop, player);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace parallel_aspects

int main(int argc, char** argv) {
  ros::init(argc, argv, "demo_motion");
  const ros::NodeHandle nh, private_nh("~");  // the log ends with the last of its handles
  try {
    return parallel_aspects::run(nh, private_nh);
  } catch (const parallel_aspects::InvalidDescription& invalid) {
    for (const std::string& problem : invalid.problems()) ROS_FATAL_STREAM(problem);
    return EXIT_FAILURE;
  }
}
