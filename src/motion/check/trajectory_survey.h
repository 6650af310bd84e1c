// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHECK_TRAJECTORY_SURVEY_H
#define PARALLEL_ASPECTS_MOTION_CHECK_TRAJECTORY_SURVEY_H

#include "parallel_aspects/motion/check_trajectory.h"

namespace parallel_aspects {

/// Gathers indices of a trajectory from samples of it, and those where they are asked for.
class TrajectorySurvey {
 public:
  /// Both must outlive it.
  TrajectorySurvey(const Manipulator& manipulator, bool keep_samples, TrajectoryCheck& check);

  /// The next sample; times must not fall, and `q` must assemble with the pose. Since the last one the
  /// platform was no farther from either than `radius`, in the metric of `PoseCertifier::distance` [m].
  void add(double time, const Pose& pose, const JointVector& q, double radius);

 private:
  const Manipulator& manipulator_;
  bool keep_samples_;
  TrajectoryCheck& check_;
  double lever_ = 0.0;  // at least the RMS displacement of the anchors over that metric
  double travel_ = 0.0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHECK_TRAJECTORY_SURVEY_H
