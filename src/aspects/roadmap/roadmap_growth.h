// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ROADMAP_ROADMAP_GROWTH_H
#define PARALLEL_ASPECTS_ASPECTS_ROADMAP_ROADMAP_GROWTH_H

#include "aspects/components/disjoint_sets.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Where the anchors of a platform are [m], divided by the root of their number: distances between such
/// points are root mean square displacements of the anchors.
using AnchorPoint = Eigen::Matrix<double, 3 * max_legs, 1>;

AnchorPoint anchor_point(const Manipulator& manipulator, const Pose& pose);

/// What growth needs of the roadmap.
struct RoadmapGround {
  const SegmentCertifier& certifier;
  const std::vector<Pose>& poses;
  const std::vector<AnchorPoint>& points;  ///< of the poses
  std::size_t neighbors;
};

/// Joins the poses of a side: each to its nearest, then components to one another, shortest segments first
/// and none between poses that are joined already. The result does not depend on the number of threads. Ends
/// early, of no use, when cancelled.
void grow(RoadmapSide& side, const RoadmapGround& ground, const MapControl& control);

/// Looks for a proved path between two poses of one working mode and sign of det A: over the roadmap, to
/// which poses are added where it does not reach far enough.
class PathSearch {
 public:
  PathSearch(const PoseRoadmap& roadmap, const WorkingMode& mode, int sign);

  /// Poses from `from` to `to`, each segment between two proved free; empty where no path was found.
  std::vector<Pose> find(const Pose& from, const Pose& to, SearchEffort effort);

 private:
  using Vertex = std::uint32_t;

  Vertex add(const Pose& pose);
  bool joined(Vertex a, Vertex b) { return sets_.find(a) == sets_.find(b); }
  std::vector<Vertex> nearest(const AnchorPoint& point, std::size_t count, Vertex of, bool in_its_set);
  bool link(Vertex a, Vertex b);
  void attach(Vertex vertex, std::size_t tries);
  void explore(Vertex from, Vertex to, std::size_t most_draws);
  std::vector<Vertex> path(Vertex from, Vertex to) const;
  std::vector<Pose> without_detours(const std::vector<Vertex>& path) const;

  const PoseRoadmap& roadmap_;
  WorkingMode mode_;
  std::vector<Pose> poses_;
  std::vector<AnchorPoint> points_;
  std::vector<std::vector<Vertex>> links_;
  DisjointSets sets_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ROADMAP_ROADMAP_GROWTH_H
