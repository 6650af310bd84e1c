// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_JOINT_PAINTER_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_JOINT_PAINTER_H

#include "rviz/display/painted_parts.h"

#include <vector>

namespace parallel_aspects {

/// Whether there are pictures of this map in joint space: with two and with three actuated joints.
bool has_joint_space(const AspectMap& map) noexcept;

/// Draws aspects of a map in the space of the actuated joints, in tiles.
class JointPainter {
 public:
  JointPainter(SurfaceStore& store, AspectPaint& paint) : store_(store), paint_(paint) {}

  /// A tile with edges of at most `side` around `center` [m].
  JointTile tile(const WorkingMode& mode, const Eigen::Vector3d& center, double side) const;

  /// Those of the tile's working mode, with its frame and the names of the joints.
  PicturePart draw(const std::vector<int>& ids, const JointTile& tile, std::size_t most_triangles, int cells);

 private:
  std::vector<int> of_mode(const std::vector<int>& ids, const WorkingMode& mode) const;
  void draw_plane(const std::vector<int>& ids, const JointTile& tile, int cells);
  void draw_surface(int id, const JointTile& tile, std::size_t most_triangles);
  void add_frame(const JointTile& tile);

  SurfaceStore& store_;
  AspectPaint& paint_;
  PicturePart part_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_JOINT_PAINTER_H
