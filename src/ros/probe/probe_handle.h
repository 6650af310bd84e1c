// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PROBE_PROBE_HANDLE_H
#define PARALLEL_ASPECTS_ROS_PROBE_PROBE_HANDLE_H

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <cstddef>
#include <functional>
#include <geometry_msgs/Pose.h>
#include <memory>
#include <string>
#include <visualization_msgs/InteractiveMarker.h>

namespace parallel_aspects {

/// What somebody did with the handle. Called from a thread of its own.
struct HandleEvents {
  std::function<void(const geometry_msgs::Pose&)> dragged;  ///< in the base frame
  std::function<void()> released;
  std::function<void(const WorkingMode&)> mode_chosen;
  std::function<void(std::size_t)> leg_toggled;  ///< its sign in the working mode
  std::function<void()> others_toggled;          ///< whether the other working modes are shown
  std::function<void()> stored_as_start, stored_as_goal;
  std::function<void()> reset;   ///< to the present pose
  std::function<void()> hidden;  ///< until it is moved again
};

/// An interactive marker with what the platform can do: arrows for directions, rings for rotations, and a
/// ball in the middle, at a pose in the base frame. `radius`: of the sphere that a robot of SO3 takes, as its
/// model has no size [m].
visualization_msgs::InteractiveMarker handle_marker(const Manipulator& manipulator,
                                                    const geometry_msgs::Pose& pose, double radius);

/// Whether the package was built with interactive_markers. Without them the probe has topics alone.
bool has_probe_handle() noexcept;

/// The handle of the probe in rviz, with its menu. Where the package was built without interactive_markers it
/// does nothing.
class ProbeHandle {
 public:
  /// `topic`: resolved; updates and feedback are below it.
  ProbeHandle(const std::string& topic, const Manipulator& manipulator, const geometry_msgs::Pose& pose,
              double radius, HandleEvents events);
  ~ProbeHandle();

  /// Takes it to where the probe is; while somebody drags it, rviz waits for the end of that.
  void move_to(const geometry_msgs::Pose& pose);

  /// Ticks what is chosen in the menu.
  void tick(const WorkingMode& mode, bool others);

 private:
  class Server;
  std::unique_ptr<Server> server_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PROBE_PROBE_HANDLE_H
