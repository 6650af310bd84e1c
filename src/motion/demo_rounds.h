// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_DEMO_ROUNDS_H
#define PARALLEL_ASPECTS_MOTION_DEMO_ROUNDS_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/tracking/tracker.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace parallel_aspects {

/// Whether a motion may pass through this configuration, beyond what the manipulator itself demands.
using ConfigurationFilter = std::function<bool(const Pose&, const JointVector&)>;

/// The largest amplitude of a local motion: of positions over the robot's size, half of it in rad.
inline constexpr double widest_local_motion = 0.4;

/// And the smallest.
inline constexpr double narrowest_local_motion = 2e-3;

/// A smooth round of the platform about a pose, through all degrees of freedom at once, that needs no map: a
/// Lissajous figure as large as stays clear of singularities, in one working mode, within joint limits, its
/// amplitude `widest` at most. Every
/// piece is certified by continuation, so det A keeps its sign.
///
/// Corners of the actuated joints, the first again at the end; actuated joints move straight between [rad or
/// m]. Empty where `mode` does not reach the pose or not even a small figure passes.
std::vector<JointVector> plan_local_motion(const Manipulator& manipulator, const Pose& pose,
                                           const WorkingMode& mode, const ConfigurationFilter& allowed,
                                           double widest = widest_local_motion);

/// A round trip through aspects that passes from one to the next through serial singularities, and never
/// meets det A = 0: every piece is certified by continuation.
struct Tour {
  std::vector<JointVector> joint_values;  ///< corners, the first again at the end; actuated joints move
                                          ///< straight between [rad or m]
  std::vector<int> aspects;               ///< ids in the order of the visit, the first again at the end
};

/// Plans a tour from a pose in a working mode through every aspect that it finds a way to. Empty where the
/// map cannot locate the start, and where there are constraints besides limits of actuated joints: straight
/// motions of actuated joints are not proved to keep those. Takes up to some seconds.
Tour plan_tour(const AspectMap& map, const Pose& start, const WorkingMode& mode);

/// One round of joint values that are sent one after the other at even times. The next round begins with the
/// first again.
struct SampledMotion {
  std::vector<JointVector> samples;  ///< [rad or m]
  JointVector gain;  ///< how much farther the next round is, where actuated joints turn on [rad or m]
};

/// Samples along corners between which the actuated joints move straight. Each corner is a sample, so no
/// chord between samples leaves the path. At constant speed where velocity limits allow it; a round takes
/// `duration` [s] at least. `interval` is the time from one sample to the next [s]. There must be two corners
/// or more.
SampledMotion sampled(const Manipulator& manipulator, const std::vector<JointVector>& corners,
                      double duration, double interval);

/// Plays motions to a tracker, sample by sample, before a robot plays them to one with the same options.
class Rehearsal {
 public:
  /// `interval` is the time from one sample to the next [s].
  Rehearsal(std::shared_ptr<const Manipulator> manipulator, const TrackerOptions& options, double interval);

  /// From now on the robot is at this configuration. False where a tracker cannot start there.
  bool start(const Pose& pose, const JointVector& q);

  /// Goes on with one round. True where the tracker followed every sample; otherwise nothing was played.
  bool play(const SampledMotion& motion);

  /// A motion along these corners, as `sampled`, of which the tracker follows two rounds from here on: in
  /// `duration` [s], or longer where that is too fast. No samples where it is not followed even much slower.
  SampledMotion slow_enough(const std::vector<JointVector>& corners, double duration) const;

 private:
  std::shared_ptr<const Manipulator> manipulator_;
  Tracker tracker_;
  double interval_;
  std::size_t count_ = 0;  // of samples played
  JointVector offset_;     // sum of the gains
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_DEMO_ROUNDS_H
