// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_DIAGNOSTICS_H
#define PARALLEL_ASPECTS_ROS_NODE_DIAGNOSTICS_H

#include "ros/monitor/frame_watch.h"
#include "ros/monitor/map_worker.h"
#include "ros/monitor/robot_monitor.h"

#include <ros/node_handle.h>

#include <atomic>
#include <cstdint>
#include <diagnostic_updater/diagnostic_updater.h>
#include <mutex>
#include <string>

namespace parallel_aspects {

/// /diagnostics of one robot, as four statuses. `tracking`: whether its configuration is known.
/// `joint_states`: rates, age, refusals and losses of the input. `map`: whether there is one. `tf`: whether
/// nodes contradict each other there. ERROR where the state is not to be relied on, WARN where an operator
/// should look.
class Diagnostics {
 public:
  /// `monitor`, `worker` and `frames` must outlive the object.
  Diagnostics(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh, const Manipulator& manipulator,
              const RobotMonitor& monitor, const MapWorker& worker, const FrameWatch& frames);

  /// Time between two calls of `publish` [s]; parameter ~diagnostic_period.
  double period() { return updater_.getPeriod(); }

  /// A state was published. From any thread.
  void count_output() noexcept { outputs_.fetch_add(1, std::memory_order_relaxed); }

  /// What to say while no threshold is set. From any thread.
  void offer(std::string thresholds);

  void publish();

 private:
  /// What was counted up to one moment.
  struct Snapshot {
    ros::WallTime time;
    MonitorCounts inputs;
    std::uint64_t outputs = 0;
  };
  using Wrapper = diagnostic_updater::DiagnosticStatusWrapper;

  Snapshot take() const;
  void report_tracking(Wrapper& status) const;
  void report_joint_states(Wrapper& status) const;
  void report_map(Wrapper& status) const;
  void report_frames(Wrapper& status) const;

  const Manipulator& manipulator_;
  const RobotMonitor& monitor_;
  const MapWorker& worker_;
  const FrameWatch& frames_;
  std::atomic<std::uint64_t> outputs_{0};
  mutable std::mutex mutex_;
  std::string offer_;  // of thresholds; empty until it is known
  Snapshot before_, now_;
  diagnostic_updater::Updater updater_;
};

/// Level of /diagnostics that a status of the tracking means.
std::uint8_t diagnostic_level(const Status& status) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_DIAGNOSTICS_H
