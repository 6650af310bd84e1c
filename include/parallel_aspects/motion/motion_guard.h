// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_MOTION_GUARD_H
#define PARALLEL_ASPECTS_MOTION_MOTION_GUARD_H

#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/tracking/hazards.h"
#include "parallel_aspects/tracking/tracker.h"

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The motion that leads away fastest, for each metre of distance.
struct EscapeDirection {
  TaskVector twist;        ///< (w, v) of the operational point, task frame [rad/m and m/m]
  JointVector joint_rate;  ///< of the actuated joints, by A t = B q̇ [rad/m or m/m]; empty where B_jj = 0
};

/// What the actuated joints do for a twist, q̇ = B^-1 A t [rad/s or m/s for a twist in rad/s and m/s]; not
/// finite where some B_jj = 0. Neither allocates nor throws.
JointVector joint_velocities(const Manipulator& manipulator, const Pose& pose, const JointVector& q,
                             const TaskVector& twist) noexcept;

/// Straight away from the witness of a distance: among all motions of the same speed, in the metric of
/// `BoundaryDistance`, none is faster away from that pose. Nothing where there is no witness, or it is where
/// the robot is. Floating point, not proved. Neither allocates nor throws.
std::optional<EscapeDirection> escape_direction(const Manipulator& manipulator, const Pose& pose,
                                                const JointVector& q,
                                                const BoundaryDistance& distance) noexcept;

/// What the guard takes the robot to do; see docs/howto/guard.md.
struct GuardOptions {
  /// The longest time from when a command is issued until the robot follows it; it may differ from one to
  /// the next [s].
  double latency = 0.02;

  /// The longest time from one command to the next; without a next one the robot brakes by itself [s].
  double period = 0.02;

  double sample_age = 0.1;  ///< older samples than this count as unknown [s]

  double linear_deceleration = 1.0;   ///< of the operational point, at least, while it brakes [m/s^2]
  double angular_deceleration = 1.0;  ///< of the platform, at least, while it brakes [rad/s^2]

  /// After something has scaled a command down, the scale rises by a factor of e in no less than this [s],
  /// and as fast as from a twentieth where it is less; 0 for at once.
  double recovery = 0.2;

  /// How far the robot must stay from each hazard, by `Hazard` [m, root mean square over the anchors]. With
  /// 0 it only stays off the hazard itself.
  std::array<double, hazard_count> stop{};
};

/// Every problem, a message each; empty when the options can be used.
std::vector<std::string> problems_of(const GuardOptions& options);

/// Distances that were proved, and where; see `BoundaryDistanceMeter`.
struct ProvedDistances {
  Pose pose;         ///< where they were measured
  WorkingMode mode;  ///< in which working mode

  /// No pose of the hazard is nearer, by `Hazard` [m]; infinite where there is none, not a number where that
  /// is not known.
  std::array<double, hazard_count> lower{std::numeric_limits<double>::quiet_NaN(),
                                         std::numeric_limits<double>::quiet_NaN(),
                                         std::numeric_limits<double>::quiet_NaN()};
};

/// Why a command was scaled as it was.
enum class GuardReason {
  none,              ///< it was not
  hazard,            ///< the motion would come too near to a hazard
  inside_threshold,  ///< the robot is too near to a hazard, and the command does not provably lead away
  escape,            ///< the robot is too near to a hazard, and the command provably leads away: it passes
  joint_velocity,    ///< an actuated joint would be too fast
  recovery,          ///< the scale rises again
  unknown_state,     ///< the robot is not tracked, or its sample too old: the command is zero
  invalid_command,   ///< numbers that are not finite, or too many: the command is zero
  too_many_commands  ///< more within the latency than are kept: the command is zero
};

/// "none", "hazard", "inside threshold", "escape", "joint velocity", "recovery", "unknown state", "invalid
/// command" or "too many commands".
const char* name(GuardReason reason) noexcept;

/// What became of a command.
struct GuardedMotion {
  double scale = 0.0;                               ///< of the command, 0 to 1
  GuardReason reason = GuardReason::unknown_state;  ///< why it is less than 1, or that it leads away
  Hazard hazard = Hazard::parallel_singularity;     ///< valid for hazard, inside_threshold and escape
  std::size_t leg = 0;                              ///< whose joint; valid for joint_velocity
  TaskVector twist;  ///< the scaled command (w, v), task frame [rad/s and m/s]; zero where unknown
  JointVector joint_velocities;  ///< of the actuated joints for it [rad/s or m/s]; zero where unknown
};

/// Scales commanded velocities so that the robot, whatever comes next, can stop before a stop threshold.
///
/// What is proved, under the model of motion of docs/howto/guard.md: after each command the robot stays at
/// least `stop` from each hazard, also when no further command comes, for as long as every command comes from
/// this object. From a state that is below a threshold already, commands pass that provably lead away.
///
/// One object for each robot and thread: it remembers the commands of the last moments. `guard` and `halt`
/// neither allocate nor throw.
class MotionGuard {
 public:
  /// Allocates. Throws `InvalidDescription` for options out of range.
  MotionGuard(std::shared_ptr<const Manipulator> manipulator, const GuardOptions& options);
  ~MotionGuard();
  MotionGuard(MotionGuard&&) noexcept;             ///< takes the memory along
  MotionGuard& operator=(MotionGuard&&) noexcept;  ///< takes the memory along

  /// The largest part of a twist (w, v) of the operational point, task frame [rad/s and m/s], that is proved.
  /// `time`: now, by the clock of the state [s].
  GuardedMotion guard(const TrackedState& state, const ProvedDistances& proved, const TaskVector& twist,
                      double time) noexcept;

  /// The same of velocities of the actuated joints [rad/s or m/s], by the twist that they make here.
  GuardedMotion guard_joints(const TrackedState& state, const ProvedDistances& proved,
                             const JointVector& velocities, double time) noexcept;

  /// The robot has to stop, for a reason that the guard does not know.
  GuardedMotion halt(double time, GuardReason reason = GuardReason::unknown_state) noexcept;

  /// Nothing is being carried out: the robot stands still, or time began anew.
  void forget() noexcept;

  /// Stop thresholds from the next command on, by `Hazard` [m]; each finite and not negative.
  void set_stop(const std::array<double, hazard_count>& stop) noexcept;

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_MOTION_GUARD_H
