// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOUNDARY_CURVES_H
#define PARALLEL_ASPECTS_ASPECTS_BOUNDARY_CURVES_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/pose_slice.h"
#include "parallel_aspects/kinematics/working_mode.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// What bounds an aspect.
enum class BoundaryKind {
  parallel,        ///< det A = 0
  serial,          ///< B_jj = 0
  limit,           ///< an actuated joint at one of its joint limits
  passive_limit,   ///< another joint at one of its limits
  cone,            ///< a rod as far from its axis as its ball joint lets it lean
  self_collision,  ///< links of two legs touch
  obstacle,        ///< a link or the platform touches an obstacle
  workspace,       ///< the operational point on the side of its box
  margin,          ///< an index of singularities as small as its margin lets it be
};

/// A short straight piece of the boundary of the aspects of one working mode, for drawing: approximated
/// in one cell of a grid, not certified.
struct BoundarySegment {
  BoundaryKind kind = BoundaryKind::parallel;  ///< what ends there
  std::size_t leg = 0;                         ///< whose B_jj or limit it is; unused for others
  Eigen::Vector2d from;                        ///< first end, in the slice [m or rad]
  Eigen::Vector2d to;                          ///< other end, in the slice [m or rad]
  std::array<int, 2> aspects{};  ///< ids on its left and right side; 0 for none, or too close to tell
};

/// A piece of one aspect, for drawing: its curved sides are straightened, while a point in it was located in
/// the aspect by proof.
struct BoundarySliver {
  int aspect = 0;                        ///< id
  std::vector<Eigen::Vector2d> corners;  ///< convex, counter-clockwise [m or rad]
};

/// An index of which lines of equal value are drawn; 0 at parallel singularities.
enum class DrawnIndex {
  parallel,      ///< `parallel_index`
  conditioning,  ///< `SingularityIndices::inverse_condition_number`: isoconditioning lines
};

/// Which lines of equal index are drawn.
struct IndexLevels {
  DrawnIndex index = DrawnIndex::parallel;  ///< of what
  std::vector<double> levels;               ///< its values, above 0
};

/// A short straight piece of a line of equal index, for drawing: approximated in one cell of a grid.
struct LevelSegment {
  double level = 0.0;    ///< of the index
  int aspect = 0;        ///< id of the aspect that it runs through
  Eigen::Vector2d from;  ///< first end, in the slice [m or rad]
  Eigen::Vector2d to;    ///< other end, in the slice [m or rad]
};

/// The aspects of one working mode in a slice, as they are drawn; each list in no order.
struct BoundaryPicture {
  std::vector<BoundarySegment> segments;  ///< the boundaries
  std::vector<BoundarySliver> slivers;    ///< what they bound
  std::vector<LevelSegment> levels;       ///< lines of equal index, where they were asked for
};

/// Whether neighbouring cells that lie wholly in one aspect become one sliver.
enum class Cells { merged, single };

/// The aspects of one working mode in a slice, and their boundaries, traced on a grid of `cells` x `cells`
/// over `bounds`, and lines of equal index; in no order.
BoundaryPicture trace_slice(const AspectMap& map, const WorkingMode& mode, const PoseSlice& slice,
                            const Eigen::AlignedBox2d& bounds, int cells, Cells merging = Cells::merged,
                            const IndexLevels& levels = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOUNDARY_CURVES_H
