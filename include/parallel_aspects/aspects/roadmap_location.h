// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ROADMAP_LOCATION_H
#define PARALLEL_ASPECTS_ASPECTS_ROADMAP_LOCATION_H

#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace parallel_aspects {

/// How much is tried to join a pose to a roadmap.
struct LocationBudget {
  std::size_t samples = 24;  ///< the nearest ones of the same working mode and sign of det A
  int parts = 100;           ///< of each segment, some microseconds each
};

/// What a roadmap tells of a configuration. Whatever is set is proved.
struct RoadmapLocation {
  int determinant_sign = 0;                ///< 1 or -1; 0 where it is not proved
  std::optional<std::uint32_t> component;  ///< of that side; nothing where no segment to it was proved free
};

/// The component that a segment proved free of singularities joins the pose to.
RoadmapLocation locate(const PoseRoadmap& roadmap, const Pose& pose, const WorkingMode& mode,
                       const LocationBudget& budget = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ROADMAP_LOCATION_H
