// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PROBE_PROBE_H
#define PARALLEL_ASPECTS_ROS_PROBE_PROBE_H

#include "ros/monitor/map_worker.h"
#include "ros/monitor/robot_monitor.h"
#include "ros/parameters/load_options.h"
#include "ros/pictures/picture.h"
#include "ros/probe/probe_handle.h"
#include "ros/probe/probe_picture.h"
#include "ros/probe/probe_solver.h"

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <std_msgs/Int8MultiArray.h>
#include <string>
#include <thread>
#include <vector>

namespace parallel_aspects {

/// Where the probe gets what it does not know itself. Called from its threads.
struct ProbeSources {
  std::function<KnownAspects()> aspects;
  std::function<CurrentConfiguration()> present;
  /// Which poses aspects are drawn at, where those are a section of the map.
  std::function<std::optional<PoseSlice>()> section;
  /// Dots of a configuration in the pictures of the map.
  std::function<std::vector<visualization_msgs::Marker>(const DrawnConfiguration&)> dots;
};

/// A pose that somebody drags or types, and what is known of it: on topics, and as a second robot in rviz.
///
/// It reads what the robot does, and changes nothing of it. Messages and the handle only note what is wanted;
/// one thread works it out, the newest alone, and no more often than `ProbeOptions::rate`. It sleeps while
/// nothing is wanted, and else looks now and then whether the section has moved that aspects are drawn at.
class Probe {
 public:
  /// Topics are below `private_nh`. What `sources` call must outlive the object.
  Probe(const NodeSetup& setup, const ros::NodeHandle& private_nh, ProbeSources sources);
  ~Probe();
  Probe(const Probe&) = delete;
  Probe& operator=(const Probe&) = delete;

  /// There is a new map: what is shown is worked out again. Call from any thread.
  void renew();

 private:
  struct Wish {
    ProbeQuestion question;
    bool hide = false;
    bool dragged = false;  // somebody still holds the handle
  };

  HandleEvents handle_events();
  void subscribe();
  void want_pose(const geometry_msgs::Pose& pose, const std::string& from, bool dragged);
  void want_mode(const std_msgs::Int8MultiArray& message);
  void set_mode(const WorkingMode& mode);
  void want_present();
  void store(const ros::Publisher& where);
  ProbeQuestion& question();
  void work_out();

  void run();
  std::optional<Wish> next_wish();
  void answer(const Wish& wish);
  std::optional<PoseSlice> section_beside(const Pose& pose) const;
  bool is_outdated() const;
  std::vector<visualization_msgs::Marker> dots_of(const ProbeFinding& finding) const;

  const std::shared_ptr<const Mechanism> mechanism_;
  const Manipulator& robot_;
  const ProbeSources sources_;
  const ros::WallDuration period_;
  ProbeSolver solver_;                // of the worker
  ProbePicture picture_;              // of the worker
  std::optional<Pose> drawn_;         // by the worker; nothing while nothing is shown
  std::optional<PoseSlice> section_;  // in its words

  std::mutex mutex_;
  std::condition_variable changed_;
  ProbeQuestion start_;                    // where the handle is before it is moved
  std::optional<ProbeQuestion> question_;  // nothing before the first time, and while hidden
  bool fresh_ = false;                     // it has not been answered
  bool dragged_ = false;
  bool stopping_ = false;
  std::optional<geometry_msgs::Pose> reached_;  // of the last answer, with its working mode
  WorkingMode reached_mode_;

  ros::CallbackQueue queue_;
  ros::NodeHandle nh_;
  ros::Publisher pose_, state_, markers_, stored_start_, stored_goal_;
  ros::Subscriber pose_subscriber_, mode_subscriber_;
  std::unique_ptr<ProbeHandle> handle_;
  ros::AsyncSpinner spinner_;
  std::thread worker_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PROBE_PROBE_H
