// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_ASSEMBLY_SURVEY_H
#define PARALLEL_ASPECTS_MOTION_ASSEMBLY_SURVEY_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "tracking/pose_certifier.h"

#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// Proves direct solutions in every task space. Immutable; may be used from any number of threads.
class SolutionProver {
 public:
  explicit SolutionProver(const SegmentCertifier& segments);

  /// The solution that Newton's method leads to from a pose; nothing where it is not proved.
  std::optional<ProvedSolution> prove(const JointVector& q, const Pose& near) const;

  /// Whether the solutions in the balls are different.
  bool differ(const ProvedSolution& first, const ProvedSolution& second) const;

 private:
  std::optional<WorkingMode> mode_of(const CertifiedPoint& point, double radius) const;

  const Manipulator& manipulator() const { return *segments_.manipulator(); }

  SegmentCertifier segments_;
  PoseCertifier certifier_;
  TaskVector allowance_;
};

/// Examines that many poses of a roadmap, in turn one of each component that has any left. Only proved
/// direct solutions of its actuated values are counted. The direct solver is numerical, so there may be
/// more. Nothing where it is cancelled.
std::optional<AssemblySurvey> survey_assembly_modes(const PoseRoadmap& roadmap, std::size_t poses,
                                                    const MapControl& control = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_ASSEMBLY_SURVEY_H
