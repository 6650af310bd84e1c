// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_ASSEMBLY_SURVEY_H
#define PARALLEL_ASPECTS_MOTION_ASSEMBLY_SURVEY_H

#include "parallel_aspects/aspects/map_control.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/aspects/segment_certifier.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "tracking/pose_certifier.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

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

/// Numbers of poses, by the number of direct solutions that their actuated values have.
using PosesBySolutions = std::map<std::size_t, std::size_t>;

/// Two different direct solutions of the same actuated values, and a path from one to the other, all proved:
/// the aspect that holds it is no uniqueness domain.
struct AssemblyChange {
  JointVector actuated;  ///< of both [rad or m]
  ProvedSolution from, to;
  std::vector<Pose> path;  ///< of their poses; each `PoseSegment` is proved free of singularities
};

/// Of the poses of one component of a roadmap, all in one aspect.
struct ComponentSurvey {
  WorkingMode mode;
  int determinant_sign = 0;              ///< 1 or -1
  std::uint32_t component = 0;           ///< of that side of the roadmap, from 0
  std::size_t samples = 0;               ///< poses that the roadmap has in it
  std::size_t poses = 0;                 ///< of these, that were looked at
  PosesBySolutions in_aspect;            ///< solutions that are proved to be in the same aspect, so at least
  std::size_t unknown = 0;               ///< solutions that may be in it, too
  std::optional<AssemblyChange> change;  ///< where one was found
};

/// How many direct solutions the actuated values of a roadmap's poses have, and in which aspects.
struct AssemblySurvey {
  std::size_t poses = 0;       ///< that were looked at
  std::size_t incomplete = 0;  ///< poses whose solutions the direct solver says it may not have found all
  PosesBySolutions solutions;  ///< poses, by the solutions that were found, in whichever aspect
  std::vector<ComponentSurvey> components;  ///< of which there are poses, as the roadmap has them
};

/// Looks at that many poses of a roadmap, in turn one of each component that has any left. Of the direct
/// solutions of its actuated values only those are counted that are proved. The direct solver is numerical,
/// so that there may be more. Nothing where it is cancelled.
std::optional<AssemblySurvey> survey_assembly_modes(const PoseRoadmap& roadmap, std::size_t poses,
                                                    const MapControl& control = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_ASSEMBLY_SURVEY_H
