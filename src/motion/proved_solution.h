// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PROVED_SOLUTION_H
#define PARALLEL_ASPECTS_MOTION_PROVED_SOLUTION_H

#include "parallel_aspects/aspects/segment_certifier.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "tracking/pose_certifier.h"

#include <optional>

namespace parallel_aspects {

/// A direct solution that is proved: the ball about the pose holds exactly one pose that the actuated values,
/// as the numbers that they are, assemble with. A path in the ball without singularities and within all
/// constraints leads from there to `pose` itself, in this working mode, so that both lie in one aspect.
struct ProvedSolution {
  Pose pose;                 ///< in the task frame
  WorkingMode mode;          ///< of both
  int determinant_sign = 0;  ///< of both, 1 or -1
  double radius = 0.0;       ///< of the ball, in the metric of `PoseCertifier::distance` [m]
};

/// Proves direct solutions in every task space. Immutable; may be used from any number of threads.
class SolutionProver {
 public:
  explicit SolutionProver(const SegmentCertifier& segments);

  /// The solution that Newton's method leads to from a pose; nothing where one of this is not proved.
  std::optional<ProvedSolution> prove(const JointVector& q, const Pose& near) const;

  /// Whether what lies in the balls is not the same.
  bool differ(const ProvedSolution& first, const ProvedSolution& second) const;

 private:
  std::optional<WorkingMode> mode_of(const CertifiedPoint& point, double radius) const;

  const Manipulator& manipulator() const { return *segments_.manipulator(); }

  SegmentCertifier segments_;
  PoseCertifier certifier_;
  TaskVector allowance_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PROVED_SOLUTION_H
