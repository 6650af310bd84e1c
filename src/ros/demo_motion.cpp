// SPDX-License-Identifier: BSD-3-Clause
//
// Plays joint_states of the drives, for any robot that aspect_node serves. It begins with a local motion
// about the start pose, which needs no map. Once the node's map is complete, it plans a tour through every
// aspect that can be reached without crossing det A = 0, and goes over to it at the end of a round.
// Parameters: ~server (name of that node), ~duration of one round of the tour [s], ~local_duration of one
// round of the local motion [s], ~loop (until shut down; or until one tour is over, or one local round where
// there is no tour), ~patience: no tour of a map that took longer than this, as it is computed again here
// [s].
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/kinematics/jacobians.h"
#include "parallel_aspects/ros/load_options.h"
#include "parallel_aspects/singularity/indices.h"
#include "parallel_aspects/tracking/local_motion.h"
#include "parallel_aspects/tracking/tour.h"

#include <parallel_aspects/MapProgress.h>

#include <ros/ros.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <future>
#include <optional>
#include <sensor_msgs/JointState.h>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double rate = 100.0;             // of joint_states [Hz]
constexpr double seconds_to_start = 60.0;  // until the node must listen

struct Start {
  Pose pose;
  WorkingMode mode;
};

struct DemoOptions {
  std::string server;
  double duration, local_duration, patience;
  bool loop;
};

DemoOptions options_from(const ros::NodeHandle& private_nh) {
  return {private_nh.param<std::string>("server", "aspect_node"), private_nh.param("duration", 60.0),
          private_nh.param("local_duration", 20.0), private_nh.param("patience", 60.0),
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
    pose = pose_from_coordinates(robot.task_space(), values).value_or(pose);
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

struct LocalMotion {
  Start start;
  std::vector<JointVector> drives;
};

// In the first start that leaves room to move.
std::optional<LocalMotion> plan_local(const NodeSetup& setup) {
  const Mechanism& mechanism = *setup.mechanism;
  for (const Start& start : possible_starts(mechanism, setup.options.start)) {
    auto drives =
        plan_local_motion(*mechanism.manipulator(), start.pose, start.mode,
                          [&](const Pose& pose, const JointVector& q) { return closes(mechanism, pose, q); });
    if (!drives.empty()) return LocalMotion{start, std::move(drives)};
  }
  return std::nullopt;
}

std::string text(const std::vector<int>& aspects) {
  std::string result;
  for (const int aspect : aspects) result += (result.empty() ? "" : " - ") + std::to_string(aspect);
  return result;
}

// Drive values along corners, at constant speed.
class Motion {
 public:
  Motion(std::vector<JointVector> corners, double duration)
      : corners_(std::move(corners)), lengths_{0.0}, duration_(duration) {
    for (std::size_t i = 1; i < corners_.size(); ++i)
      lengths_.push_back(lengths_.back() + (corners_[i] - corners_[i - 1]).norm());
  }

  double duration() const { return duration_; }

  // After `seconds` of one round.
  JointVector at(double seconds) const {
    const double length = std::clamp(seconds / duration_, 0.0, 1.0) * lengths_.back();
    const auto next = std::upper_bound(lengths_.begin(), lengths_.end() - 1, length);
    const auto i = static_cast<std::size_t>(next - lengths_.begin());
    const double piece = lengths_[i] - lengths_[i - 1];
    const double t = piece > 0.0 ? (length - lengths_[i - 1]) / piece : 0.0;
    return corners_[i - 1] + t * (corners_[i] - corners_[i - 1]);
  }

  // What a round adds to drives that turn on.
  JointVector gain() const { return corners_.back() - corners_.front(); }

 private:
  std::vector<JointVector> corners_;
  std::vector<double> lengths_;
  double duration_;
};

// Lasts longer than asked for where a drive would be faster than its velocity limit.
Motion within_velocities(const Manipulator& robot, const std::vector<JointVector>& corners, double duration) {
  double length = 0.0, stretch = 1.0;
  for (std::size_t i = 1; i < corners.size(); ++i) length += (corners[i] - corners[i - 1]).norm();
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const JointVector change = corners[i] - corners[i - 1];
    const double seconds = duration * change.norm() / length;
    for (std::size_t j = 0; j < robot.leg_count() && seconds > 0.0; ++j) {
      const double speed = std::abs(change[static_cast<Eigen::Index>(j)]) / seconds;
      stretch = std::max(stretch, speed / robot.leg(j).limits.velocity);
    }
  }
  return Motion(corners, duration * stretch);
}

// Plans the tour on a thread of its own, once the node has its map.
class TourPlanner {
 public:
  TourPlanner(ros::NodeHandle nh, NodeSetup setup, Start start, const DemoOptions& options)
      : setup_(std::move(setup)), start_(std::move(start)), patience_(options.patience) {
    subscriber_ = nh.subscribe(options.server + "/map_progress", 10, &TourPlanner::on_progress, this);
  }
  ~TourPlanner() { cancelled_ = true; }

  // Whether it is known what comes of the tour.
  bool ready() const {
    return refused_ ||
           (tour_.valid() && tour_.wait_for(std::chrono::seconds(0)) == std::future_status::ready);
  }

  // Whether the node's map is still to come.
  bool waiting() const { return !refused_ && !tour_.valid(); }

  // Empty where there is none; only once `ready`, and only once.
  Tour take() { return refused_ ? Tour{} : tour_.get(); }

 private:
  void on_progress(const MapProgress::ConstPtr& progress) {
    if (refused_ || tour_.valid() || progress->state == MapProgress::COMPUTING) return;
    refused_ = progress->state != MapProgress::COMPLETE || progress->seconds > patience_;
    if (!refused_) tour_ = std::async(std::launch::async, [this] { return plan(); });
  }

  Tour plan() const {
    MapControl control;
    control.cancelled = &cancelled_;
    const auto map = compute_aspect_map(setup_.mechanism->manipulator(), setup_.options.map, control).map;
    return map ? plan_tour(*map, start_.pose, start_.mode) : Tour{};
  }

  const NodeSetup setup_;
  const Start start_;
  const double patience_;
  std::atomic<bool> cancelled_{false};
  bool refused_ = false;
  std::future<Tour> tour_;
  ros::Subscriber subscriber_;
};

// Publishes one motion after the other.
class Player {
 public:
  Player(const Manipulator& robot, ros::Publisher publisher)
      : publisher_(std::move(publisher)),
        offset_(JointVector::Zero(static_cast<Eigen::Index>(robot.leg_count()))) {
    for (const Leg& leg : robot.legs()) message_.name.push_back(leg.driven_joint);
  }

  // One round; returns early when ROS shuts down.
  void play(const Motion& motion) {
    ros::Rate clock(rate);
    const ros::Time begin = ros::Time::now();
    for (double seconds = 0.0; ros::ok() && seconds < motion.duration();
         seconds = (ros::Time::now() - begin).toSec()) {
      publish(motion.at(seconds));
      ros::spinOnce();
      clock.sleep();
    }
    offset_ += motion.gain();
  }

 private:
  void publish(const JointVector& drives) {
    const JointVector q = drives + offset_;
    message_.header.stamp = ros::Time::now();
    message_.position.assign(q.data(), q.data() + q.size());
    publisher_.publish(message_);
  }

  ros::Publisher publisher_;
  sensor_msgs::JointState message_;
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

// The local motion until the tour is planned, then the tour.
void play_all(const Manipulator& robot, const Motion& local, TourPlanner& planner, const DemoOptions& options,
              Player& player) {
  std::optional<Motion> tour;
  bool known = false;
  const ros::Time begin = ros::Time::now();
  while (ros::ok()) {
    if (!known && planner.ready()) {
      known = true;
      const Tour planned = planner.take();
      if (planned.drives.size() > 1) {
        tour = within_velocities(robot, planned.drives, options.duration);
        ROS_INFO_STREAM("The motion visits aspects " << text(planned.aspects) << ".");
      }
    }
    player.play(tour ? *tour : local);
    const bool given_up = planner.waiting() && (ros::Time::now() - begin).toSec() > options.patience;
    if ((known || given_up) && !options.loop) return;
  }
}

int run(ros::NodeHandle nh, const ros::NodeHandle& private_nh) {
  const DemoOptions options = options_from(private_nh);
  const NodeSetup setup = load_setup(nh, ros::NodeHandle(options.server));
  const auto local = plan_local(setup);
  if (!local) {
    ROS_FATAL(
        "No motion: the robot does not assemble at the start that the parameters say, or not clear of "
        "singularities; set start/pose to another pose.");
    return EXIT_FAILURE;
  }
  const ros::Publisher publisher = nh.advertise<sensor_msgs::JointState>("joint_states", 100);
  if (!wait_for_server(options.server, publisher)) return EXIT_FAILURE;
  TourPlanner planner(nh, setup, local->start, options);
  const Manipulator& robot = *setup.mechanism->manipulator();
  Player player(robot, publisher);
  play_all(robot, within_velocities(robot, local->drives, options.local_duration), planner, options, player);
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
