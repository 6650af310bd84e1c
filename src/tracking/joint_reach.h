// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_JOINT_REACH_H
#define PARALLEL_ASPECTS_TRACKING_JOINT_REACH_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/tracking/joint_samples.h"
#include "tracking/pose_certifier.h"

namespace parallel_aspects {

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

#endif  // PARALLEL_ASPECTS_TRACKING_JOINT_REACH_H
