// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_SURFACE_STORE_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_SURFACE_STORE_H

#include "aspects/surface/joint_surface.h"
#include "parallel_aspects/aspects/joint_projection.h"

#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace parallel_aspects {

/// What pictures of one map share, each made when it is first asked for: a section that is dragged makes no
/// surface anew.
class SurfaceStore {
 public:
  explicit SurfaceStore(std::shared_ptr<const AspectMap> map) : map_(std::move(map)) {}

  const AspectMap& map() const noexcept { return *map_; }
  const Manipulator& robot() const noexcept { return *map_->manipulator(); }

  /// Of an aspect, with at most so many triangles.
  const AspectSurface& surface(int aspect, std::size_t most_triangles) {
    auto& kept = surfaces_[{aspect, most_triangles}];
    if (!kept) {
      SurfaceOptions options;
      options.most_triangles = most_triangles;
      kept = surface_of(*map_, aspect, options);
    }
    return *kept;
  }

  /// Of a map with `has_joint_surfaces`.
  const JointBlock& block() {
    if (!block_) block_ = joint_block(*map_);
    return *block_;
  }

  /// Of a map of which `JointProjection::is_possible`.
  const JointProjection& projection() {
    if (!projection_) projection_.emplace(map_);
    return *projection_;
  }

 private:
  std::shared_ptr<const AspectMap> map_;
  std::map<std::pair<int, std::size_t>, std::optional<AspectSurface>> surfaces_;
  std::optional<JointBlock> block_;
  std::optional<JointProjection> projection_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_SURFACE_STORE_H
