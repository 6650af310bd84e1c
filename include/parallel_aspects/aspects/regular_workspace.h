// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_REGULAR_WORKSPACE_H
#define PARALLEL_ASPECTS_ASPECTS_REGULAR_WORKSPACE_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Regular shapes of positions; their axes are those of the task frame. A cylinder stands along z. In R1 and
/// R2 the angles of the passive chain take the place of positions, and [rad] that of [m].
enum class RegularShape { box, square, disc, cylinder, ball };

/// A range of an angle [rad].
struct AngleRange {
  double lower = 0.0;  ///< [rad], -pi or more
  double upper = 0.0;  ///< [rad], not below the lower, pi or less
};

/// Which shape is looked for.
struct WorkspaceQuestion {
  RegularShape shape = RegularShape::box;  ///< of positions

  /// Of a box: its edges along the free positions, to each other; by default all equal. Of a cylinder: its
  /// height over its diameter, one number; by default 1. Of others none.
  std::vector<double> ratio{};

  /// Where its center is held, by free position [m]; nothing where it is looked for.
  std::array<std::optional<double>, max_map_dimension> center{};

  /// Orientations that the platform must be able to take at every position of the shape, where the map has an
  /// angle; by default all that it has.
  std::optional<AngleRange> angle{};
};

/// The largest shape in one aspect. With the positions of the shape, every angle that is asked for is in the
/// aspect.
struct RegularWorkspace {
  int aspect = 0;     ///< id in the map
  MapPoint center{};  ///< of the shape that is proved, by free position [m]

  /// Proved: the shape of this size about `center` lies in the aspect. The size is the radius of a disc, ball
  /// or cylinder, the edge of a square, and the edge of a box along the first free position [m]. 0 where none
  /// was found.
  double lower = 0.0;

  double upper =
      0.0;  ///< proved: no such shape in the aspect is larger than this, wherever its center is [m]

  /// Whether the gap between the two bounds is no more than what was asked for, as a share of the upper one.
  bool proved = false;
};

/// How much work is done.
struct WorkspaceOptions {
  double gap = 0.01;  ///< that is aimed at between the bounds, of the upper one; above 0, below 1
  std::size_t leaves = 4'000'000;  ///< that are looked at for each aspect, at most, each as often as it is
  unsigned threads = 0;            ///< 0 for one a core; the result does not depend on it
  MapControl control{};            ///< hooks
};

/// Why there is no answer for maps of this manipulator, of all poses or of a slice: shapes that do not fit
/// the free positions, ratios, centers and angles out of their ranges.
Problems problems_of(const Manipulator& manipulator, const std::optional<MapSlice>& slice,
                     const WorkspaceQuestion& question);

/// The largest regular shape in each of these aspects of a map, by their ids, in their order. There must be
/// no `problems_of` the question. Leaves of the map that are undecided are divided where that matters, for
/// this question alone; those that stay undecided count as usable for the upper bounds. Sizes
/// below a hundredth of the largest are not distinguished. Shapes lie in the region of the map. In R1 and R2
/// they may go on beyond half a turn, with a center from -pi to pi and no edge longer than a turn.
/// Nothing when cancelled.
std::optional<std::vector<RegularWorkspace>> find_regular_workspaces(const AspectMap& map,
                                                                     const std::vector<int>& aspects,
                                                                     const WorkspaceQuestion& question,
                                                                     const WorkspaceOptions& options = {});

/// Lengths of the shape of that size, by name: "radius", "height", "edge", or "edge_x" and so on [m].
std::vector<std::pair<std::string, double>> lengths_of(const AspectMap& map,
                                                       const WorkspaceQuestion& question, double size);

/// "box", "square", "disc", "cylinder" or "ball".
const char* name(RegularShape shape) noexcept;

/// How many positions are free: of a slice, or of all poses.
std::size_t free_positions(const Manipulator& manipulator, const std::optional<MapSlice>& slice) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_REGULAR_WORKSPACE_H
