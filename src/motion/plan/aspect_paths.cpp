// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/aspect_paths.h"

#include "aspects/map/map_contents.h"
#include "aspects/map/map_location.h"
#include "aspects/roadmap/path_search.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int max_leaf_paths = 30;  // that are tried, of which a segment is not proved

}  // namespace

AspectPaths::AspectPaths(std::shared_ptr<const AspectMap> map) : map_(std::move(map)), segments_(map_) {}

SegmentsInMode AspectPaths::segments_of(const Aspect& aspect) const {
  return {[this, &aspect](const Pose& from, const Pose& to) {
            return segments_.is_free(from, to, aspect.mode, aspect.determinant_sign);
          },
          [this](const Pose& from, const Pose& to, double t) { return segments_.between(from, to, t); },
          *map_->manipulator(), aspect.mode};
}

/// No path keeps an index that is larger than those of its ends.
std::vector<Pose> AspectPaths::find(int aspect, const Pose& from, const Pose& to, const PathShape& shape) {
  const Aspect& in = map_->aspects()[static_cast<std::size_t>(aspect - 1)];
  const SegmentsInMode segments = segments_of(in);
  const Manipulator& robot = *map_->manipulator();
  const double wanted =
      shape.is_wide ? std::min(index_at(robot, from, in.mode), index_at(robot, to, in.mode)) : 0.0;
  if (segments.is_free(from, to) &&
      (!shape.is_wide || least_index_along({from, to}, segments) >= shape.kept_share * wanted))
    return {from, to};
  for (const bool undecided : {false, true}) {
    const std::vector<Pose> path = find_through_leaves(in, from, to, {undecided, wanted});
    if (path.empty()) continue;
    const double kept = shape.is_wide ? shape.kept_share * least_index_along(path, segments) : 0.0;
    return shortened(path, segments, kept);
  }
  return find_in_roadmap(in, from, to);
}

/// Where a segment is not proved, the next path goes elsewhere.
std::vector<Pose> AspectPaths::find_through_leaves(const Aspect& aspect, const Pose& from, const Pose& to,
                                                   LeafChoice choice) {
  const std::size_t mode = *mode_index(map_->contents(), aspect.mode);
  FaceComponents& components = components_.try_emplace(mode, map_->contents(), mode).first->second;
  for (int i = 0; i < max_leaf_paths; ++i) {
    const std::vector<LeafStep> steps =
        find_leaf_path(map_->contents(), components, aspect.id, from, to, choice);
    bool is_proved = true;
    NodeIndex before = no_node;  // the leaf that the path comes from
    for (std::size_t k = 0; k + 1 < steps.size(); ++k) {
      if (steps[k].leaf != steps[k + 1].leaf) before = steps[k].leaf;
      if (segments_.is_free(steps[k].pose, steps[k + 1].pose, aspect.mode, aspect.determinant_sign)) continue;
      is_proved = false;
      choice.barred.insert({before, steps[k + 1].leaf});
    }
    if (!is_proved) continue;
    std::vector<Pose> path;
    for (const LeafStep& step : steps) path.push_back(step.pose);
    return path;
  }
  return {};
}

/// Aspects are joined by more than faces of inside leaves; there poses are sampled.
std::vector<Pose> AspectPaths::find_in_roadmap(const Aspect& aspect, const Pose& from, const Pose& to) {
  if (map_->slice()) return {};
  std::shared_ptr<const PoseRoadmap>& roadmap = roadmaps_[aspect.mode.index()];
  if (!roadmap) {
    RoadmapOptions options;
    options.modes = {aspect.mode};
    roadmap = compute_pose_roadmap(map_->manipulator(), options).roadmap;
  }
  return roadmap ? PathSearch(*roadmap, aspect.mode, aspect.determinant_sign).find(from, to)
                 : std::vector<Pose>();
}

}  // namespace parallel_aspects
