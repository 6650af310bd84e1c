// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_LEAD_IN_H
#define PARALLEL_ASPECTS_MOTION_PLAN_LEAD_IN_H

#include "motion/plan/map_segments.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/model/pose.h"

#include <functional>
#include <vector>

namespace parallel_aspects {

/// A path from a configuration that lies close to singularities or limits into an aspect.
struct LeadIn {
  std::vector<Pose> poses;  ///< from the configuration on; each segment is proved free
  int aspect = 0;           ///< id of the one that holds the last of them, and so all; 0 where none was found
};

/// Climbs: in every round to the pose around that is farthest from singularities, of those to which a segment
/// is proved, until `is_there` is true of it. The poses, from the first one on; empty where it never is.
/// `sign` is that of det A, proved.
std::vector<Pose> climb(const AspectMap& map, const MapSegments& segments, const Pose& pose,
                        const WorkingMode& mode, int sign, const std::function<bool(const Pose&)>& is_there);

/// Climbs until the map knows the aspect.
LeadIn find_lead_in(const AspectMap& map, const MapSegments& segments, const Pose& pose,
                    const WorkingMode& mode, int sign);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_LEAD_IN_H
