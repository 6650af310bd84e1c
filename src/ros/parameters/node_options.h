// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PARAMETERS_NODE_OPTIONS_H
#define PARALLEL_ASPECTS_ROS_PARAMETERS_NODE_OPTIONS_H

#include "model/spherical_links.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/tracking/hazards.h"
#include "parallel_aspects/tracking/tracker.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Which assembly mode the robot is in when its first joint sample arrives. At most one of the two is given.
struct StartOptions {
  std::optional<std::vector<double>> pose;  ///< coordinates as `coordinate_names` [m or rad]
  std::optional<int> determinant_sign;      ///< sign of det A, 1 or -1
  /// How far a direct solution may be from the stated pose, RMS over the anchors, in the
  /// `DistanceUnit` of the robot [m or rad]; positive. Default: 1/20 of the robot's size.
  std::optional<double> tolerance;
};

struct DisplayOptions {
  bool gallery = true;         ///< whether every working mode is drawn beside the robot
  double gallery_scale = 0.5;  ///< size of the gallery against the robot, 0.01 to 10
  double radius = 1.0;  ///< of the sphere that a robot of SO3 takes, as its model has no size [m]; positive
  double rate = 20.0;   ///< how often the drawn position is renewed [Hz], 0.1 to 100
};

/// Thresholds on the proved distances, in the `DistanceUnit` of the robot [m or rad]; 0 for none.
struct ThresholdParameters {
  double parallel_warn = 0.0, parallel_stop = 0.0;
  double serial_warn = 0.0, serial_stop = 0.0;
  double limit_warn = 0.0, limit_stop = 0.0;
  double hysteresis = 0.1;  ///< a level is left above its threshold times 1 plus this, 0 to 10
};

/// How commanded velocities are guarded.
struct GuardParameters {
  bool enabled = false;
  double latency = 0.02;          ///< from when a command is published until the robot follows it [s], 0 to 1
  double command_timeout = 0.05;  ///< age at which a command gives zero [s], 0.001 to 1
  double sample_age = 0.05;       ///< age at which a joint sample gives zero [s], 0.001 to 1
  double linear_deceleration = 0.0;   ///< of the operational point, at least [m/s^2]; must be stated
  double angular_deceleration = 0.0;  ///< of the platform, at least [rad/s^2]; must be stated if it turns
  double recovery = 0.2;              ///< in which the scale rises from 0 to 1 [s], 0 to 60
  /// The point whose velocity is commanded, in the platform frame [m].
  std::vector<double> reference_point{0.0, 0.0, 0.0};
};

/// The pose that people drag and type in rviz.
struct ProbeOptions {
  std::optional<bool> enabled;  ///< by default where the package was built with interactive_markers
  double rate = 20.0;           ///< how often it is worked out at most [Hz], 0.1 to 100
};

/// Uniqueness domains, where these are computed.
struct UniquenessParameters {
  bool enabled = false;           ///< whether they are, once the map is complete
  double hold = 0.1;              ///< how long before the warning begins or ends [s], 0 to 60
  std::optional<int> most_cells;  ///< as in `UniquenessOptions`, 1,000 to 100,000,000
};

/// How far a direct solution may be from the stated pose, as a length of the model [m].
double tolerance_of(const StartOptions& start, const Manipulator& manipulator);

/// What the thresholds of each hazard are, as lengths of the model [m].
DistanceThresholds::Options thresholds_of(const ThresholdParameters& parameters, DistanceUnit unit);

/// Every parameter of the node but the description of the robot.
struct NodeOptions {
  MapOptions map;
  std::string map_file;  ///< where the map is kept, an absolute path; empty for none
  StartOptions start;
  DisplayOptions display;
  TrackerOptions tracking;
  PassiveOptions passive;
  ThresholdParameters thresholds;
  GuardParameters guard;
  ProbeOptions probe;
  UniquenessParameters uniqueness;
  double distance_rate = 50.0;        ///< how often distances are measured [Hz], 0.1 to 1000
  double joint_states_timeout = 0.5;  ///< age at which the last sample is stale [s], 0.001 to 3600
  /// Of messages with some of the actuated joints: two values of an actuated joint are no farther apart [s],
  /// 0 to 10.
  double joint_states_window = 0.1;
  double tf_timeout = 0.2;       ///< how long a query waits for tf [s], 0 to 60
  int state_decimation = 1;      ///< ~state is published with every n-th sample, 1 to 10,000
  int completed_decimation = 1;  ///< likewise ~joint_states and tf
  bool read_only = false;        ///< refuses all that changes the node while it runs
  /// Of the frames that the node adds, by default the robot's name; where it is set, of its links as well.
  std::string frame_prefix;
};

/// Everything wrong with the options of a map; messages that name parameters below `prefix`.
Problems problems_of(const MapOptions& options, const Manipulator& manipulator, const std::string& prefix);

/// Everything wrong with thresholds; messages that name parameters below `prefix`.
Problems problems_of(const ThresholdParameters& thresholds, const std::string& prefix);

/// The same of what is drawn.
Problems problems_of(const DisplayOptions& display, const std::string& prefix);

/// Everything wrong with the options for this manipulator; messages that name parameters below `prefix`,
/// which ends in a slash. Empty when all is well.
Problems problems_of(const NodeOptions& options, const Manipulator& manipulator, const std::string& prefix);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PARAMETERS_NODE_OPTIONS_H
