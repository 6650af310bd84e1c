// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHECK_TRAJECTORY_H
#define PARALLEL_ASPECTS_MOTION_CHECK_TRAJECTORY_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A pose that the platform passes, and when.
struct PoseWaypoint {
  double time = 0.0;  ///< [s]
  Pose pose;          ///< in the task frame
};

/// Whether a trajectory is safe at every time from its first waypoint to its last.
enum class TrajectoryAnswer {
  safe,     ///< proved: no singularity is met, every leg reaches and all constraints hold
  unsafe,   ///< proved not to be safe
  unknown,  ///< neither is proved
};

/// "yes", "no" or "unknown".
const char* name(TrajectoryAnswer answer) noexcept;

/// The first violation of a trajectory, between two times.
struct TrajectoryViolation {
  Violation kind = Violation::none;          ///< what is proved to be violated at `before`
  std::optional<std::size_t> leg;            ///< at fault, where it is one
  std::optional<ConstraintKind> constraint;  ///< that does not hold, where it is one
  double after = 0.0;                        ///< proved free from the start to here [s]
  double before = 0.0;                       ///< proved to be violated here or earlier [s]
};

/// A singularity that is passed, and where the trajectory goes on behind it. Passed an odd number of times
/// within the bracket.
struct TrajectoryCrossing {
  Violation kind = Violation::singularity;  ///< or `out_of_reach`: B_jj = 0
  std::optional<std::size_t> leg;           ///< whose B_jj vanishes
  double after = 0.0;                       ///< later than this [s]
  double before = 0.0;                      ///< passed by this time [s]
  std::optional<WorkingMode> mode;          ///< that it goes on in; nothing where it is not followed further
  int determinant_sign = 0;                 ///< of det A that it goes on with; 0 where that is not known
};

/// The least value that was met, of samples.
struct SampledLeast {
  double value = std::numeric_limits<double>::infinity();  ///< infinite where nothing was sampled
  double time = 0.0;                                       ///< [s]
  std::optional<std::size_t> leg;                          ///< whose it is, of a value by leg
};

/// The fastest motion of an actuated joint over all of the continuous time.
struct FastestMotion {
  double value = 0.0;  ///< proved: it is at least once as fast [rad/s or m/s]
  double bound = 0.0;  ///< proved: it is never faster; infinite where that is not known
  double time = 0.0;   ///< about when it is as fast as `value` [s]
};

/// One time of a trajectory, in floating point.
struct TrajectorySample {
  double time = 0.0;            ///< [s]
  Pose pose;                    ///< in the task frame
  JointVector q;                ///< [rad or m]
  double parallel_index = 0.0;  ///< by `parallel_index`
  TaskVector serial_indices;    ///< by `serial_indices`
  /// Between two samples the platform is no farther from either pose than these differ, as RMS over the
  /// anchors [m]. Proved.
  double travel = 0.0;
};

/// An assembly mode that a trajectory of the actuated joints may start in.
struct PossibleStart {
  Pose pose;                 ///< in the task frame
  int determinant_sign = 0;  ///< of det A, +1 or -1; 0 where that is not proved
};

/// What is known of a trajectory.
struct TrajectoryCheck {
  TrajectoryAnswer answer = TrajectoryAnswer::unknown;  ///< of all of its continuous time
  std::string reason;                                   ///< a sentence
  bool refused = false;                                 ///< it was not checked; `reason` says what to correct
  std::vector<PossibleStart> possible_starts;           ///< those to choose from, where refused for that
  std::optional<WorkingMode> mode;                      ///< at the start, where it is known
  double free_until = 0.0;                              ///< proved free from the start to here [s]
  std::optional<TrajectoryViolation> violation;         ///< where unsafe: the first
  std::vector<TrajectoryCrossing> crossings;            ///< of singularities, proved, up to `followed_until`
  double followed_until = 0.0;                          ///< none up to here but in those brackets [s]
  std::string not_followed;                             ///< why not to the end, a sentence; else empty
  SampledLeast parallel_index;                          ///< by `parallel_index`, up to `free_until`
  SampledLeast serial_index;                            ///< by `serial_indices`, up to `free_until`
  std::vector<FastestMotion> speeds;                    ///< of each actuated joint, up to `free_until`
  std::vector<TrajectorySample> samples;  ///< up to `free_until`, at rising times; empty unless asked for
};

/// How a trajectory is checked.
struct TrajectoryCheckOptions {
  double bracket = 1e-6;      ///< width of that of the first violation, over the time between two waypoints
  int max_parts = 4000;       ///< of the time between two waypoints that are tried to be proved
  int samples = 200;          ///< of indices, at least
  bool keep_samples = false;  ///< whether the result has them
  MapControl control{};       ///< where cancelled, what is left is not proved

  /// Of actuated joints: whether legs may pass B_jj = 0, which is then no violation but only one of the
  /// `crossings`; det A keeps its sign. All other constraints are proved of both postures there. Not where
  /// there is a serial margin, which B_jj = 0 violates.
  bool pass_serial = false;
};

/// Every reason why poses cannot be checked, a message each: no waypoint, numbers that are not finite or
/// beyond 10^12, times that do not rise by a nanosecond, a working mode that the robot does not have, a first
/// pose out of reach or below a margin.
Problems problems_of(const Manipulator& manipulator, const std::vector<PoseWaypoint>& waypoints,
                     const WorkingMode& mode);

/// Checks a path of the platform in one working mode: between waypoints it runs as `pose_between`, at even
/// parameter in time. Refused, with the first problem as its reason, where there are `problems_of`.
TrajectoryCheck check_trajectory(const SegmentCertifier& certifier,
                                 const std::vector<PoseWaypoint>& waypoints, const WorkingMode& mode,
                                 const TrajectoryCheckOptions& options = {});

/// Which actuated joints are proved to be faster than their velocity limits, or else which may be, with both
/// numbers; empty where there is none. Both are empty where all are proved to keep them.
std::string exceeded_speeds(const Manipulator& manipulator, const TrajectoryCheck& check, bool proved);

/// A point of trajectory_msgs/JointTrajectory: one entry a leg, in the order of the legs.
struct JointWaypoint {
  double time = 0.0;         ///< [s]
  JointVector q;             ///< [rad or m]
  JointVector velocity;      ///< [rad/s or m/s]; empty where not given
  JointVector acceleration;  ///< [rad/s^2 or m/s^2]; empty where not given
};

/// In which assembly mode a trajectory of the actuated joints starts. With neither, in the only one there is.
struct TrajectoryStart {
  std::optional<Pose> pose;  ///< about that of the first waypoint
  int determinant_sign = 0;  ///< of det A, +1 or -1; 0 where it is not stated
};

/// How far actuated joints may be off those that a stated start asks for: this angle, or this share of the
/// robot's size.
inline constexpr double start_tolerance = 0.01;

/// Whether a joint of that leg that is `off` its start [rad or m] is within the tolerance; not so where it is
/// not a number.
bool is_near_start(const Manipulator& manipulator, std::size_t leg, double off) noexcept;

/// The sign of det A that alone distinguishes one of several starts from the others; 0 where there is none.
int telling_sign(const std::vector<PossibleStart>& starts, std::size_t which) noexcept;

/// Every reason why actuated joints cannot be checked, a message each: no waypoint, numbers that are not
/// finite, beyond 10^12 or not one a leg, times that do not rise by a nanosecond, accelerations without
/// velocities, a start pose that is off the first waypoint by more than `start_tolerance`.
Problems problems_of(const Manipulator& manipulator, const std::vector<JointWaypoint>& waypoints,
                     const TrajectoryStart& start);

/// Checks a trajectory of the actuated joints, between waypoints as the joint_trajectory_controller of
/// ros_controllers runs: a quintic where both have velocities and accelerations, a cubic where both have
/// velocities, else straight. The platform is followed from the start by certified continuation. A leg that
/// passes through B_jj = 0 is a violation. Refused, with the reason, where there are `problems_of`, where the
/// assembly mode at the start is not known, and where it is below a margin.
TrajectoryCheck check_trajectory(const SegmentCertifier& certifier,
                                 const std::vector<JointWaypoint>& waypoints, const TrajectoryStart& start,
                                 const TrajectoryCheckOptions& options = {});

/// How far a sample of a trajectory is at least from parallel singularities, serial ones and limits of the
/// actuated joints, as `BoundaryDistanceMeter` measures it, proved [m].
struct SampleDistances {
  bool measured = false;          ///< here; else by how far the robot moves to where it was
  std::array<double, 3> lower{};  ///< bounds, in that order
};

/// Of every sample of a check, measured at `points` of them, evenly by time; none for no points.
std::vector<SampleDistances> distances_on(const std::shared_ptr<const Manipulator>& manipulator,
                                          const TrajectoryCheck& check, std::size_t points);

/// The least that is proved over all of the continuous time up to `free_until`.
std::array<double, 3> least_distances(const TrajectoryCheck& check,
                                      const std::vector<SampleDistances>& distances);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHECK_TRAJECTORY_H
