// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_REHEARSAL_H
#define PARALLEL_ASPECTS_MOTION_REHEARSAL_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/tracking/tracker.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace parallel_aspects {

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

#endif  // PARALLEL_ASPECTS_MOTION_REHEARSAL_H
