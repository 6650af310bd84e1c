// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ROADMAP_PATH_SEARCH_H
#define PARALLEL_ASPECTS_ASPECTS_ROADMAP_PATH_SEARCH_H

#include "aspects/components/disjoint_sets.h"
#include "aspects/roadmap/roadmap_growth.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/aspects/same_aspect.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace parallel_aspects {

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
  std::vector<Pose> shortened(const std::vector<Vertex>& path) const;

  const PoseRoadmap& roadmap_;
  WorkingMode mode_;
  std::vector<Pose> poses_;
  std::vector<AnchorPoint> points_;
  std::vector<std::vector<Vertex>> links_;
  DisjointSets sets_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ROADMAP_PATH_SEARCH_H
