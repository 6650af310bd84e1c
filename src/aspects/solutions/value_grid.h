// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_VALUE_GRID_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_VALUE_GRID_H

#include "aspects/solutions/joint_ranges.h"
#include "aspects/solutions/value_strips.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Column and row of a cell. Of an angle with all values they go on beyond both ends, in further turns.
using GridPlace = std::array<std::ptrdiff_t, 2>;

// Smaller sets are slivers between strips.
inline constexpr std::size_t least_cells_of_set = 16;

/// A connected set of cells that no strip touches.
struct GridSet {
  GridPlace cell{};                ///< in the middle of its longest row
  std::array<double, 2> inside{};  ///< values in the middle of this cell [m or rad]
  std::size_t cells = 0;
  double cells_beside = 0.0;  ///< its share of the cells that strips touch
};

/// The values of both joints that move, in a grid of equal cells, some of which strips touch.
class ValueGrid {
 public:
  ValueGrid(const JointRanges& ranges, std::size_t cells_an_axis);

  /// Lengths of a cell [m or rad].
  std::array<double, 2> steps() const noexcept { return steps_; }
  double cell_measure() const noexcept { return steps_[0] * steps_[1]; }

  /// Marks all cells that the strip may touch. False if these are all.
  bool mark(const ValueStrip& strip);

  /// Joins cells that are not marked through their sides; then there are sets. Those of fewer cells than that
  /// are left out.
  void join(std::size_t least_cells);

  /// The largest first.
  const std::vector<GridSet>& sets() const noexcept { return sets_; }

  /// Cells along either axis.
  std::ptrdiff_t cells_an_axis() const noexcept { return static_cast<std::ptrdiff_t>(cells_); }

  /// Whether rows, or columns, go on in further turns.
  bool is_periodic(std::size_t axis) const noexcept { return ranges_.are_periodic()[axis]; }

  /// The same cell in the first turn.
  GridPlace within(const GridPlace& place) const noexcept;

  /// Values in the middle of a cell, in its turn to rounding [m or rad].
  std::array<double, 2> values_at(const GridPlace& place) const noexcept;

  /// The cell of these values, which must be in the ranges.
  GridPlace cell_of(const std::array<double, 2>& values) const noexcept;

  /// Index of the set of a cell in the first turn; nothing where it is in none.
  std::optional<std::size_t> set_at(const GridPlace& place) const noexcept;

  /// Index of the set of these values [m or rad]; nothing where they are in none.
  std::optional<std::size_t> set_of(const std::array<double, 2>& values) const noexcept;

  /// How many cells are in no set.
  std::size_t cells_in_none() const noexcept { return in_none_; }

 private:
  using Index = std::uint32_t;
  static constexpr Index marked = ~Index{0}, in_no_set = marked - 1;

  /// First and last index along an axis of cells that meet an interval; none where the first is larger.
  std::array<std::ptrdiff_t, 2> cells_meeting(std::size_t axis, const Interval& values) const noexcept;
  void mark_moved(const std::array<Interval, 2>& values, const ValueStrip& strip,
                  const std::array<double, 2>& turns);
  void mark_column(std::ptrdiff_t x, std::array<std::ptrdiff_t, 2> rows, const ValueStrip& strip,
                   const std::array<double, 2>& turns);
  void fill(Index start, Index set);
  void sort_sets(std::size_t least_cells);
  void find_insides();
  void share_marked();

  /// Calls `enter` with all that have a side in common with the cell.
  template <class Enter>
  void for_neighbours(Index cell, const Enter& enter) const {
    const std::array<std::size_t, 2> at{cell % cells_, cell / cells_}, strides{1, cells_};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto round = static_cast<Index>((cells_ - 1) * strides[axis]);
      const auto stride = static_cast<Index>(strides[axis]);
      const bool wraps = ranges_.are_periodic()[axis];
      if (at[axis] > 0)
        enter(cell - stride);
      else if (wraps)
        enter(cell + round);
      if (at[axis] + 1 < cells_)
        enter(cell + stride);
      else if (wraps)
        enter(cell - round);
    }
  }

  const JointRanges& ranges_;
  std::size_t cells_;
  std::array<double, 2> lower_{}, steps_{};
  std::vector<Index> set_;  // of each cell
  std::vector<GridSet> sets_;
  std::size_t in_none_ = 0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_VALUE_GRID_H
