// SPDX-License-Identifier: BSD-3-Clause
//
// Plays joint_states of the drives along a tour through every aspect that can be reached without crossing det
// A = 0. The tour is planned from the robot that aspect_node was given. Parameters: ~server (name of that
// node), ~duration of one round [s], ~loop (until shut down, or once).
#include "parallel_aspects/ros/load_options.h"
#include "parallel_aspects/tracking/tour.h"

#include <parallel_aspects/MapProgress.h>

#include <ros/ros.h>
#include <ros/topic.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <sensor_msgs/JointState.h>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double rate = 100.0;             // of joint_states [Hz]
constexpr double seconds_to_start = 60.0;  // until the node must be ready

struct Start {
  Pose pose;
  WorkingMode mode;
};

bool larger(const Aspect& a, const Aspect& b) { return a.measure < b.measure; }

// The start that the parameters say, in the largest aspect that it leaves open.
std::optional<Start> choose_start(const AspectMap& map, const StartOptions& options) {
  std::vector<Aspect> open;
  Start start;
  if (options.pose) {
    const Eigen::Map<const Eigen::VectorXd> values(options.pose->data(),
                                                   static_cast<Eigen::Index>(options.pose->size()));
    start.pose = pose_from_coordinates(map.manipulator()->task_space(), values).value_or(Pose{});
  }
  for (const Aspect& aspect : map.aspects()) {
    const bool holds = !options.pose || map.locate(start.pose, aspect.mode).aspect == aspect.id;
    if (holds && aspect.determinant_sign == options.determinant_sign.value_or(aspect.determinant_sign))
      open.push_back(aspect);
  }
  if (open.empty()) return std::nullopt;
  const Aspect& chosen = *std::max_element(open.begin(), open.end(), larger);
  return Start{options.pose ? start.pose : chosen.deepest, chosen.mode};
}

Tour plan(const NodeSetup& setup) {
  const MapResult result = compute_aspect_map(setup.mechanism->manipulator(), setup.options.map);
  if (!result.map) {
    ROS_FATAL_STREAM("No tour: " << result.sentence);
    return {};
  }
  const auto start = choose_start(*result.map, setup.options.start);
  const Tour tour = start ? plan_tour(*result.map, start->pose, start->mode) : Tour{};
  if (tour.drives.size() < 2) ROS_FATAL("No tour: no aspect holds the start that the parameters say.");
  return tour;
}

std::string text(const std::vector<int>& aspects) {
  std::string result;
  for (const int aspect : aspects) result += (result.empty() ? "" : " - ") + std::to_string(aspect);
  return result;
}

// Drive values along the corners of a tour, at constant speed.
class Motion {
 public:
  explicit Motion(std::vector<JointVector> corners) : corners_(std::move(corners)), lengths_{0.0} {
    for (std::size_t i = 1; i < corners_.size(); ++i)
      lengths_.push_back(lengths_.back() + (corners_[i] - corners_[i - 1]).norm());
  }

  // `share` of the way, 0 to 1.
  JointVector at(double share) const {
    const double length = std::clamp(share, 0.0, 1.0) * lengths_.back();
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
};

bool wait_for_server(const std::string& server, const ros::Publisher& publisher) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(seconds_to_start);
  MapProgress::ConstPtr progress;
  while (ros::ok() && ros::WallTime::now() < deadline) {
    progress = ros::topic::waitForMessage<MapProgress>(server + "/map_progress", ros::Duration(1.0));
    if (progress && progress->state == MapProgress::COMPLETE && publisher.getNumSubscribers() > 0)
      return true;
  }
  ROS_FATAL_STREAM("The node " << server << " had no map within " << seconds_to_start << " s.");
  return false;
}

void play(const Manipulator& manipulator, const Motion& motion, double duration, bool loop,
          const ros::Publisher& publisher) {
  sensor_msgs::JointState message;
  for (const Leg& leg : manipulator.legs()) message.name.push_back(leg.driven_joint);
  JointVector offset = JointVector::Zero(static_cast<Eigen::Index>(manipulator.leg_count()));
  ros::Rate clock(rate);
  ros::Time begin = ros::Time::now();
  while (ros::ok()) {
    message.header.stamp = ros::Time::now();
    double share = (message.header.stamp - begin).toSec() / duration;
    if (share > 1.0 && !loop) return;
    if (share > 1.0) {
      begin += ros::Duration(duration);
      offset += motion.gain();
      share -= 1.0;
    }
    const JointVector q = motion.at(share) + offset;
    message.position.assign(q.begin(), q.end());
    publisher.publish(message);
    clock.sleep();
  }
}

int run(ros::NodeHandle nh, const ros::NodeHandle& private_nh) {
  const std::string server = private_nh.param<std::string>("server", "aspect_node");
  const double duration = private_nh.param("duration", 60.0);
  const NodeSetup setup = load_setup(nh, ros::NodeHandle(server));
  const Tour tour = plan(setup);
  if (tour.drives.size() < 2) return EXIT_FAILURE;
  const ros::Publisher publisher = nh.advertise<sensor_msgs::JointState>("joint_states", 100);
  if (!wait_for_server(server, publisher)) return EXIT_FAILURE;
  ROS_INFO_STREAM("The motion visits aspects " << text(tour.aspects) << ".");
  play(*setup.mechanism->manipulator(), Motion(tour.drives), duration, private_nh.param("loop", true),
       publisher);
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
