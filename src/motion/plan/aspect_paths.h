// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_ASPECT_PATHS_H
#define PARALLEL_ASPECTS_MOTION_PLAN_ASPECT_PATHS_H

#include "motion/plan/leaf_path.h"
#include "motion/plan/map_segments.h"
#include "motion/plan/path_shape.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/model/pose.h"

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

namespace parallel_aspects {

/// Finds proved paths within the aspects of a map.
class AspectPaths {
 public:
  explicit AspectPaths(std::shared_ptr<const AspectMap> map);

  const MapSegments& segments() const noexcept { return segments_; }

  /// Poses from one to the other, each segment between two proved free in the aspect's working mode; empty
  /// where none was found, or it was cancelled. Both must lie in the aspect.
  std::vector<Pose> find(int aspect, const Pose& from, const Pose& to, const PathShape& shape = short_shape,
                         const MapControl& control = {});

  /// What was found of wide paths is kept for other shapes of them, until here.
  void forget_wide_paths() { wide_paths_.clear(); }

 private:
  /// What paths may pass besides inside leaves that share faces.
  enum class Beside {
    nothing,
    passages,   ///< climbs between parts, and one undecided leaf between two inside ones, all proved
    undecided,  ///< undecided leaves, from middle to middle
  };

  /// Two parts of one aspect that no faces of inside leaves connect: its id, and the leaves that stand for
  /// them.
  using Parts = std::tuple<int, NodeIndex, NodeIndex>;

  struct WidePath {
    int aspect;
    Pose from, to;
    std::vector<Pose> poses;  // before it is shortened
  };

  std::vector<Pose> find_any(const Aspect& aspect, const Pose& from, const Pose& to, double wanted_index);
  std::vector<Pose> find_wide(const Aspect& aspect, const Pose& from, const Pose& to, double wanted_index);
  bool is_free(const Pose& from, const Pose& to, const Aspect& aspect) const;
  SegmentsInMode segments_of(const Aspect& aspect) const;
  FaceComponents& components(const Aspect& aspect);
  const LeafPassages* climbs(const Aspect& aspect);
  std::optional<Parts> parts(const Aspect& aspect, const Pose& from, const Pose& to);
  std::vector<Pose> find_between_parts(const Aspect& aspect, const Pose& from, const Pose& to);
  std::vector<Pose> search_between_parts(const Aspect& aspect, const Pose& from, const Pose& to);
  std::vector<NodeIndex> proved_leaves(const Aspect& aspect, const Pose& pose) const;
  std::vector<Pose> find_through_leaves(const Aspect& aspect, const Pose& from, const Pose& to, Beside beside,
                                        double wanted_index = 0.0);
  std::vector<Pose> find_by_climbs(const Aspect& aspect, const Pose& from, const Pose& to);
  std::vector<Pose> climb_to(const Aspect& aspect, const Pose& from, const std::vector<NodeIndex>& leaves);
  std::vector<Pose> find_in_roadmap(const Aspect& aspect, const Pose& from, const Pose& to);

  std::shared_ptr<const AspectMap> map_;
  MapSegments segments_;
  MapControl control_;  // what is cancelled is not kept as searched for in vain
  std::deque<WidePath> wide_paths_;
  std::map<std::size_t, LeafIndices> indices_;        // by index of the mode in the map
  std::map<std::size_t, FaceComponents> components_;  // by index of the mode in the map
  std::map<int, LeafPassages> climbs_;                // by aspect, where they were needed
  std::map<Parts, std::vector<Pose>> links_;  // from one to the other, once searched for; empty where in vain
  std::map<std::size_t, std::shared_ptr<const PoseRoadmap>> roadmaps_;  // by index of the working mode
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_ASPECT_PATHS_H
