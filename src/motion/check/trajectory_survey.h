// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHECK_TRAJECTORY_SURVEY_H
#define PARALLEL_ASPECTS_MOTION_CHECK_TRAJECTORY_SURVEY_H

#include "parallel_aspects/motion/check_trajectory.h"

namespace parallel_aspects {

/// Gathers indices and speeds of a trajectory from samples of it; proves nothing.
class TrajectorySurvey {
 public:
  /// Both must outlive it.
  TrajectorySurvey(const Manipulator& manipulator, TrajectoryCheck& check);

  /// The next sample; times must not fall, and `q` must assemble with the pose.
  void add(double time, const Pose& pose, const JointVector& q);

 private:
  void add_speeds(double time, const JointVector& q);

  const Manipulator& manipulator_;
  TrajectoryCheck& check_;
  double last_time_ = 0.0;
  JointVector last_;  // empty before the first sample
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHECK_TRAJECTORY_SURVEY_H
