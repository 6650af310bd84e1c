// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_POSE_GRAPH_H
#define PARALLEL_ASPECTS_MOTION_PLAN_POSE_GRAPH_H

#include "aspects/roadmap/roadmap_growth.h"
#include "motion/plan/path_shape.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/model/pose.h"

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// The poses of one side of a roadmap and two ends, each beside its nearest. The links of the roadmap are a
/// forest and have one path between two poses; here there are many, of which those are proved that are taken.
class PoseGraph {
 public:
  /// `segments` outlives it.
  PoseGraph(const PoseRoadmap& roadmap, const RoadmapSide& side, const Pose& from, const Pose& to,
            const SegmentsInMode& segments);

  /// Poses from the one end to the other, each segment between two proved; empty where none was found. The
  /// path is short, or keeps this parallel index at its poses where one does, else as large a one as it can.
  std::vector<Pose> find(double wanted_index);

 private:
  using Vertex = std::uint32_t;
  static constexpr Vertex start = 0, goal = 1;

  const std::vector<Vertex>& beside(Vertex vertex);
  double distance(Vertex a, Vertex b) const { return (points_[a] - points_[b]).norm(); }
  std::vector<Vertex> search(double wanted_index);
  bool is_proved(const std::vector<Vertex>& path);

  const SegmentsInMode& segments_;
  std::vector<Pose> poses_;
  std::vector<AnchorPoint> points_;
  std::vector<double> indices_;
  std::vector<std::vector<Vertex>> beside_;              // empty while not asked for
  std::set<std::pair<Vertex, Vertex>> proved_, barred_;  // the lower one first
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_POSE_GRAPH_H
