// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_ROADMAP_GRAPH_H
#define PARALLEL_ASPECTS_MOTION_ROADMAP_GRAPH_H

#include "parallel_aspects/aspects/aspect_graph.h"
#include "parallel_aspects/aspects/map_control.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/working_mode.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// A component of a roadmap: sampled poses that proved segments join, all of one aspect. Two may belong to
/// one aspect.
struct RoadmapPart {
  int id = 0;                ///< from 1: by side of the roadmap, then falling number of poses
  WorkingMode mode;          ///< one sign a leg
  int determinant_sign = 0;  ///< +1 or -1
  std::size_t samples = 0;   ///< poses of it
};

/// The components of a roadmap as nodes, and the serial gates between them that are proved.
struct RoadmapGraph {
  std::vector<RoadmapPart> parts;  ///< by id

  /// Gates and sets of parts. The segment of a crossing has three poses: a sampled one of both parts, and two
  /// on the way to where B_jj is zero, all proved free in either mode. From the last of them the actuated
  /// joints run straight to their values in the other mode, as `plan_in_roadmap` says, and back to that pose.
  /// What joins a set is proved. Only the sign of det A proves sets different: `proved_set_count` is that of
  /// the signs, and workspaces are not measured.
  AspectGraph graph;
};

/// Looks for serial gates between the components of a roadmap, from some poses of each towards random poses.
/// Of components between which none is found nothing is claimed. Nothing where cancelled.
std::optional<RoadmapGraph> compute_roadmap_graph(const PoseRoadmap& roadmap, const MapControl& control = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_ROADMAP_GRAPH_H
