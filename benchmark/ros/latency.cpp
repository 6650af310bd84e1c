// SPDX-License-Identifier: BSD-3-Clause
//
// joint_states in to ~state out, against a bare relay node: messages to both in turn, from one program, in
// one run. Parameters: ~rate [Hz], ~seconds.
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <parallel_aspects/AspectState.h>

#include <ros/ros.h>

#include "support/robots/shipped.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <mutex>
#include <sensor_msgs/JointState.h>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

/// Times between messages out and what comes back, found by their stamps.
class Stopwatch {
 public:
  void start(const ros::Time& stamp) {
    const std::lock_guard<std::mutex> lock(mutex_);
    started_[stamp] = ros::WallTime::now();
  }
  void stop(const ros::Time& stamp) {
    const ros::WallTime now = ros::WallTime::now();
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = started_.find(stamp);
    if (found == started_.end()) return;
    microseconds_.push_back(1e6 * (now - found->second).toSec());
    started_.erase(found);
  }

  /// Smallest value that this share is not above [us].
  double quantile(double share) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (microseconds_.empty()) return std::nan("");
    std::sort(microseconds_.begin(), microseconds_.end());
    const double last = static_cast<double>(microseconds_.size() - 1);
    return microseconds_[static_cast<std::size_t>(share * last)];
  }
  std::size_t count() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return microseconds_.size();
  }
  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    started_.clear();
    microseconds_.clear();
  }

 private:
  std::mutex mutex_;
  std::map<ros::Time, ros::WallTime> started_;
  std::vector<double> microseconds_;
};

/// A slow sine of every actuated joint about a pose, or about the configuration that the robot was recognised
/// in.
class Motion {
 public:
  Motion(const std::string& robot, const std::vector<double>& coordinates)
      : mechanism_(test::shipped(robot)), middle_(mechanism_->assembled().q) {
    const Manipulator& manipulator = *mechanism_->manipulator();
    for (const Leg& leg : manipulator.legs()) message_.name.push_back(leg.actuated_joint);
    width_ = 1e-3 * std::min(1.0, manipulator.size());
    const PoseCoordinates values =
        Eigen::Map<const Eigen::VectorXd>(coordinates.data(), static_cast<Eigen::Index>(coordinates.size()));
    const auto pose = pose_from_coordinates(manipulator.motions(), values);
    if (!pose) return;
    for (const InverseSolution& solution : inverse_in_all_modes(manipulator, *pose))
      if (solution.status == InverseStatus::solved) middle_ = solution.q;
  }
  const sensor_msgs::JointState& at(const ros::Time& stamp, double phase) {
    message_.header.stamp = stamp;
    message_.position.assign(middle_.data(), middle_.data() + middle_.size());
    for (double& position : message_.position) position += width_ * std::sin(phase);
    return message_;
  }
  std::size_t legs() const { return message_.name.size(); }

 private:
  std::shared_ptr<const Mechanism> mechanism_;
  sensor_msgs::JointState message_;
  JointVector middle_;
  double width_ = 0.0;
};

void print(const char* name, Stopwatch& watch) {
  std::printf("%-12s %8zu %10.0f %10.0f %10.0f\n", name, watch.count(), watch.quantile(0.5),
              watch.quantile(0.99), watch.quantile(0.999));
}

int measure() {
  ros::NodeHandle nh, own("~");
  const double rate = own.param("rate", 1000.0), seconds = own.param("seconds", 10.0);
  Motion motion(own.param<std::string>("robot", "five_bar"),
                nh.param("aspect_node/start/pose", std::vector<double>()));
  Stopwatch node, relay;
  std::size_t known = 0;
  const auto hints = ros::TransportHints().tcpNoDelay();
  const ros::Subscriber states = nh.subscribe<AspectState>(
      "aspect_node/state", 1000,
      [&](const AspectState::ConstPtr& state) {
        node.stop(state->header.stamp);
        known += state->status.code == Status::OK ? 1 : 0;
      },
      ros::VoidConstPtr(), hints);
  const ros::Subscriber relayed = nh.subscribe<sensor_msgs::JointState>(
      "relayed", 1000,
      [&](const sensor_msgs::JointState::ConstPtr& message) { relay.stop(message->header.stamp); },
      ros::VoidConstPtr(), hints);
  const ros::Publisher to_node = nh.advertise<sensor_msgs::JointState>("joint_states", 1000);
  const ros::Publisher to_relay = nh.advertise<sensor_msgs::JointState>("to_relay", 1000);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  while (ros::ok() && (to_node.getNumSubscribers() == 0 || to_relay.getNumSubscribers() == 0 ||
                       states.getNumPublishers() == 0 || relayed.getNumPublishers() == 0))
    ros::WallDuration(0.05).sleep();
  const int warm_up = static_cast<int>(2.0 * rate), all = warm_up + static_cast<int>(seconds * rate);
  ros::WallRate pace(2.0 * rate);
  for (int i = 0; i < all && ros::ok(); ++i) {
    if (i == warm_up) {
      node.clear();
      relay.clear();
      known = 0;
    }
    for (const bool first : {true, false}) {
      const ros::Time stamp = ros::Time::now();
      (first ? node : relay).start(stamp);
      (first ? to_node : to_relay).publish(motion.at(stamp, 1e-3 * i));
      pace.sleep();
    }
  }
  ros::WallDuration(0.5).sleep();
  std::printf("%zu actuated joints at %.0f Hz for %.0f s; %zu states say OK\n", motion.legs(), rate, seconds,
              known);
  std::printf("%-12s %8s %10s %10s %10s\n", "", "messages", "p50 [us]", "p99 [us]", "p99.9 [us]");
  print("relay", relay);
  print("aspect_node", node);
  std::printf("%-12s %8s %10.2f %10.2f %10.2f\n", "ratio", "", node.quantile(0.5) / relay.quantile(0.5),
              node.quantile(0.99) / relay.quantile(0.99), node.quantile(0.999) / relay.quantile(0.999));
  return 0;
}

}  // namespace
}  // namespace parallel_aspects

int main(int argc, char** argv) {
  ros::init(argc, argv, "latency");
  return parallel_aspects::measure();
}
