// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SAME_ASPECT_H
#define PARALLEL_ASPECTS_ASPECTS_SAME_ASPECT_H

#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/pose.h"

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A configuration: a pose, and the branch of each leg.
struct PoseInMode {
  Pose pose;         ///< in the task frame
  WorkingMode mode;  ///< one sign a leg
};

/// Both yes and no are proved.
enum class SameAspect { yes, no, unknown };

/// What `same_aspect` found.
struct AspectComparison {
  SameAspect answer = SameAspect::unknown;  ///< whether both are in one aspect
  std::string message;                      ///< why

  /// Where the answer is yes: poses from the first to the second; each `PoseSegment` from one to the next is
  /// proved free of singularities and within limits.
  std::vector<Pose> path;

  /// The sign of det A at both where a path was looked for and none was found; 0 where no search can help.
  int searched_sign = 0;

  /// Where the answer is no since one of them lies in no aspect: the constraint that is proved to fail there,
  /// if it is one.
  std::optional<ConstraintKind> failing{};
};

/// Whether two configurations lie in one aspect, by what is proved of them and of the segment between them.
///  - no: they differ in the working mode or in the sign of det A, or one is proved to lie in no aspect.
///  - yes: the segment is proved free.
///  - unknown: neither; or one is too close to a singularity or a limit.
AspectComparison same_aspect(const SegmentCertifier& certifier, const PoseInMode& first,
                             const PoseInMode& second);

/// How long a path is looked for where the roadmap has none.
enum class SearchEffort {
  brief,     ///< some milliseconds; for questions of which there are many
  thorough,  ///< up to a second or so; through narrow passages, too
};

/// The same, and yes also where a path is found over the roadmap or over poses sampled for this question.
/// That none was found proves nothing. The same roadmap gives the same answer.
AspectComparison same_aspect(const PoseRoadmap& roadmap, const PoseInMode& first, const PoseInMode& second,
                             SearchEffort effort = SearchEffort::thorough);

/// "yes", "no" or "unknown".
const char* name(SameAspect answer) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SAME_ASPECT_H
