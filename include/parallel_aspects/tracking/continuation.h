// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_CONTINUATION_H
#define PARALLEL_ASPECTS_TRACKING_CONTINUATION_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

namespace parallel_aspects {

/// A point of the path q(t) = q0 + t (q1 - q0), t in [0, 1], and the pose there.
struct PathPoint {
  double t = 0.0;
  JointVector q;
  Pose pose;
};

/// Follows the pose of one assembly mode while the drives move straight from q0 to q1, in steps each of which
/// passes the Newton-Kantorovich test: for every drive value on the step the direct solution exists, is the
/// only one near the pose, and det A keeps its sign. So the path never slips to another assembly mode.
///
/// Bounds are evaluated in double precision and tested with a margin a million times wider than their
/// rounding.
class Continuation {
 public:
  /// `pose` must be a direct solution at `q0`. All values finite, one entry a leg.
  Continuation(const Manipulator& manipulator, const Pose& pose, const JointVector& q0,
               const JointVector& q1) noexcept;

  const PathPoint& at() const noexcept { return at_; }
  bool finished() const noexcept { return at_.t >= 1.0; }

  /// Goes on by one certified step, as long as the test allows. False, and no move, where not even the
  /// shortest step passes: the path comes too close to det A = 0.
  bool advance() noexcept;

 private:
  bool step_is_certified(double inverse_norm, double length) const noexcept;
  bool correct(PathPoint& point) const noexcept;

  const Manipulator& manipulator_;
  JointVector q0_, q1_;
  PathPoint at_;
  double length_ = 1.0;  // of the next step to try, as a share of the path
};

/// Newton's method on f(X, q) = 0 from `pose`. True when it ends with a step below 1e-13 of the robot's size.
bool refine_pose(const Manipulator& manipulator, const JointVector& q, Pose& pose) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_CONTINUATION_H
