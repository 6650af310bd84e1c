// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_SURFACE_CELL_SET_H
#define PARALLEL_ASPECTS_DRAW_SURFACE_CELL_SET_H

#include "aspects/map/map_contents.h"
#include "aspects/tree/pose_space.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// A cell of the grid that halves every edge of the root boxes `level` times.
struct CellIndex {
  RootIndex root = 0;
  std::array<int, 3> at{};
};

/// One aspect of a three-dimensional map as cells of a grid: those of which its inside leaves fill half or
/// more. Points are pose coordinates: x, y, z [m] in T3; x, y [m] and phi [rad] in SE2; the rotation vector
/// [rad] in SO3, in the ball of radius pi.
class CellSet {
 public:
  /// The cells at `level` or, where the aspect has fewer than `fewest` of them, at a finer one.
  CellSet(const AspectMap& map, int aspect, std::uint32_t level, std::size_t fewest);

  std::uint32_t level() const noexcept { return level_; }
  std::size_t count() const noexcept { return count_; }
  double measure() const;  ///< of all cells, in the unit of `measure_unit`

  bool holds(const CellIndex& cell) const noexcept;
  void visit(const std::function<void(const CellIndex&)>& visit_cell) const;

  /// The cell beyond a face; nothing where the space of poses, or its picture, ends.
  std::optional<CellIndex> beyond(const CellIndex& cell, std::size_t axis, bool upper) const;

  /// The same number for every corner that is the same point of the picture. `corner`: bit i is set at the
  /// upper end of axis i.
  std::uint64_t corner_key(const CellIndex& cell, unsigned corner) const noexcept;
  Eigen::Vector3d corner_point(const CellIndex& cell, unsigned corner) const noexcept;
  Eigen::Vector3d center(const CellIndex& cell) const noexcept;

  Eigen::Vector3d edges() const noexcept;  ///< of a cell; in SO3 of the largest [m or rad]
  bool is_ball() const noexcept { return is_ball_; }

 private:
  struct Grid {
    std::array<int, 3> first{}, size{};
    std::vector<std::uint8_t> states;  // bit 0: a cell; bit 1: was a cell
  };

  void fill();
  std::size_t room() const;
  void fill(NodeIndex node);
  double share(NodeIndex node) const;
  void set(const NodePlace& place);
  std::size_t state_index(const Grid& grid, const std::array<int, 3>& at) const noexcept;
  std::uint8_t state(const CellIndex& cell) const noexcept;
  int side(const CellIndex& cell) const noexcept;
  Eigen::Vector3d point(RootIndex root, const Eigen::Vector3d& in_cells, int side) const noexcept;
  Box box(const CellIndex& cell) const noexcept;

  const AspectMap::Contents& map_;
  const int aspect_;
  const std::size_t mode_;
  const bool is_ball_, turns_;
  std::uint32_t level_;
  std::size_t count_ = 0;
  std::vector<Grid> grids_;  // by root
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_SURFACE_CELL_SET_H
