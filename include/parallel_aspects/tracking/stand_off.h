// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_STAND_OFF_H
#define PARALLEL_ASPECTS_TRACKING_STAND_OFF_H

#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/tracking/joint_samples.h"

#include <functional>
#include <memory>

namespace parallel_aspects {

class PoseCertifier;

/// How near det A = 0 noise of the encoders lets the assembly mode be determined. Where two assembly modes
/// meet, the actuated joints distinguish them by the square of the distance only, so that the stand-off grows
/// with the square root of the noise. Once it is made it never allocates, never throws.
class StandOff {
 public:
  /// For samples with the noise and the bend of these options. Allocates.
  StandOff(std::shared_ptr<const Manipulator> manipulator, const SampleOptions& options);

  /// Whether a robot that stands still at `pose` in `mode` is followed, whatever the encoders say within
  /// their noise: proved for the noise that is worst to first order. `bend`: what the actuated joints were
  /// last taken to leave the straight path between samples by [rad or m]; empty where that is not known.
  bool can_distinguish(const Pose& pose, const WorkingMode& mode,
                       const JointVector& bend = {}) const noexcept;

  /// An estimate of how far from `singular`, a pose with det A = 0, the robot must stay for that, on the
  /// straight path from `pose` [m, root mean square over the anchors]. The whole way where the mode cannot be
  /// told at `pose`.
  double along_path(const Pose& pose, const Pose& singular, const WorkingMode& mode,
                    const JointVector& bend = {}) const noexcept;

 private:
  std::shared_ptr<const Manipulator> manipulator_;
  std::shared_ptr<const PoseCertifier> certifier_;
  JointVector noise_;         // [rad or m]
  JointVector resting_bend_;  // what noise alone makes of `path_bend` [rad or m]
};

/// The largest stand-off that was found.
struct StandOffEstimate {
  double largest = 0.0;  ///< [m]
  Pose at;               ///< the pose with det A = 0 that asks for it
  int poses = 0;         ///< with det A = 0 that were looked at
};

/// The largest stand-off of as many poses with det A = 0, next to seeded random configurations: an estimate
/// from below, as others may ask for more. It ends early, with what it has, where `goes_on` says no.
/// Allocates.
StandOffEstimate estimate_stand_off(
    const std::shared_ptr<const Manipulator>& manipulator, const SampleOptions& options, int poses,
    const std::function<bool()>& goes_on = [] { return true; });

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_STAND_OFF_H
