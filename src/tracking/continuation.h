// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_CONTINUATION_H
#define PARALLEL_ASPECTS_TRACKING_CONTINUATION_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/tracking/tracker.h"
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

/// Two samples of the actuated joints that follow one another, and what is known of the path between them.
struct SampleStep {
  const JointVector& from;
  const JointVector& to;
  double seconds;                  ///< between them
  SampleGap gap;                   ///< whether `bend` says nothing of the path
  const JointVector& bend;         ///< else how far it leaves the straight one [rad or m]
  const JointVector& uncertainty;  ///< how far the actuated joints are from both values, at most [rad or m]
};

/// Where the actuated joints can have been since the last sample at which the pose was proved: a box, of the
/// bounds that are stated of them. Between two samples these are the bend of the path, where there is no gap,
/// and their velocity limits. Never allocates.
class JointReach {
 public:
  /// Nowhere but where the first step begins.
  void begin() noexcept;

  /// A step of them. Where nothing bounds it nothing is known from then on.
  void add(const Manipulator& manipulator, const SampleOptions& options, const SampleStep& step) noexcept;

  void forget() noexcept { known_ = false; }
  bool known() const noexcept { return known_ && lower_.size() > 0; }

  /// Whether the direct solution at `point`, which the robot was in, is proved to exist, to move continuously
  /// and to keep det A from zero wherever the actuated joints are in the box. Then the robot has not left it,
  /// whatever its path was, and a straight path leads to where it is now. Takes up to some 10 ms.
  bool keeps_to(const PoseCertifier& certifier, const CertifiedPoint& point) const noexcept;

 private:
  bool known_ = false;
  JointVector lower_, upper_;  // empty before the first step
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_CONTINUATION_H
