// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_END_ASPECTS_H
#define PARALLEL_ASPECTS_MOTION_PLAN_END_ASPECTS_H

#include "motion/plan/gate_route.h"
#include "motion/plan/map_segments.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/motion/plan_path.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Why no aspect holds an end, by working mode.
class ExclusionReasons {
 public:
  void add(const WorkingMode& mode, const std::string& reason) { modes_[reason].push_back(mode); }

  /// A clause, with the working modes where there are several reasons.
  std::string text() const;

 private:
  std::map<std::string, std::vector<WorkingMode>> modes_;
};

/// The aspects that hold an end, and what is known of the working modes in which none is found.
struct EndAspects {
  std::vector<PoseInAspect> found;
  bool all_known = true;  ///< of every other mode it is proved that no aspect holds the end
  ExclusionReasons reasons;
};

EndAspects find_aspects(const AspectMap& map, const MapSegments& segments, const PathEnd& end);

/// That there is no path, with the reason, where it is proved without a map that no aspect holds an end.
std::optional<PlannedPath> excluded_end(const SegmentCertifier& certifier, const PathEnd& from,
                                        const PathEnd& to);

/// Climbs: in every round to the pose around that is farthest from singularities, of those to which a segment
/// is proved, until `is_there` is true of it. The poses, from the first one on; empty where it never is.
/// `sign` is that of det A, proved.
std::vector<Pose> climb(const AspectMap& map, const MapSegments& segments, const Pose& pose,
                        const WorkingMode& mode, int sign, const std::function<bool(const Pose&)>& is_there);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_END_ASPECTS_H
