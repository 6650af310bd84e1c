// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_CONTINUATION_H
#define PARALLEL_ASPECTS_TRACKING_CONTINUATION_H

#include "tracking/pose_certifier.h"

namespace parallel_aspects {

enum class ContinuationStatus {
  unfinished,        ///< some of the path is left
  finished,          ///< the pose belongs to the end of the path
  too_near_singular  ///< not even the shortest step can be certified: too near to det A = 0
};

/// Follows the direct solution at a point while the actuated joints move straight from there to `end`, in
/// steps each of which is proved: for every joint value on it the solution exists, is the only one near by,
/// and det A keeps its sign. One step begins with the solution that the one before ended with. So the path
/// never slips to another assembly mode, and the end is the solution that the robot, moving so, arrives at.
///
/// Nothing allocates or throws. The certifier must outlive this.
class Continuation {
 public:
  /// `start` must have been evaluated, and its ball without motion be certified. `end` must be finite, one
  /// entry a leg. What is certified holds for every continuous path that leaves the straight one by `bend` at
  /// most, in each actuated joint [rad or m, not negative]; empty for the straight one alone.
  Continuation(const PoseCertifier& certifier, const CertifiedPoint& start, const JointVector& end,
               const JointVector& bend = {}) noexcept;

  const CertifiedPoint& at() const noexcept { return at_; }

  /// Share of the path that is gone, 0 to 1.
  double share() const noexcept { return share_; }
  ContinuationStatus status() const noexcept { return status_; }

  /// Goes on by one certified step.
  ContinuationStatus advance() noexcept;

  /// Tries a step of exactly this share; false, and nothing has changed, where it cannot be certified. Needs
  /// a live `RoundingUpward`.
  bool step(double length) noexcept;

  /// All solutions of the last step lie in the ball of this radius about the pose that it began at, in the
  /// metric of `PoseCertifier::distance` [m].
  double radius() const noexcept { return radius_; }

  /// Goes on to the end, or as far as `max_steps` lead.
  ContinuationStatus run(int max_steps) noexcept;

 private:
  const PoseCertifier& certifier_;
  CertifiedPoint at_;
  JointVector start_, end_;
  TaskVector direction_, allowance_;
  double speed_ = -1.0;  // at `at_`; negative where it is not known yet
  double share_ = 0.0;
  double radius_ = 0.0;
  double length_ = 1.0;  // of the next step to try, as a share of the path
  ContinuationStatus status_ = ContinuationStatus::unfinished;
};

/// A point at a pose that Newton's method finds from `pose` for `q`, around which a direct solution is proved
/// to exist, on its own and off det A = 0. False, with `point` of no use, where that fails. All entries must
/// be finite, one entry of `q` a leg.
bool certify_solution(const PoseCertifier& certifier, const Pose& pose, const JointVector& q,
                      CertifiedPoint& point) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_CONTINUATION_H
