// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_GRID_RUNS_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_GRID_RUNS_H

#include "aspects/solutions/value_grid.h"

#include <array>
#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// Cells of one set side by side in a row.
struct GridRun {
  std::size_t set = 0;
  std::ptrdiff_t row = 0, first = 0, end = 0;  ///< columns from `first`, before `end`
};

/// Two cells that have a side in common, of different runs of a set.
struct GridLink {
  std::size_t from = 0, to = 0;  ///< runs
  GridPlace here{}, there{};     ///< a cell of either, `there` as seen from here
};

/// Some cells in a row or column that are in no set, between two sets.
struct GridGap {
  std::array<std::size_t, 2> sets{};
  std::array<GridPlace, 2> ends{};  ///< the cell of either set, the second as seen from the first
};

/// Paths through the sets of a grid. Each run is contractible, and what two of them have in common is
/// connected. So all closed paths in a set are, up to homotopy, made of paths along a tree of its runs and of
/// links between two runs that are not in the tree.
class GridRuns {
 public:
  /// The grid must be joined, and outlive it.
  explicit GridRuns(const ValueGrid& grid);

  /// Corners of a path through its set, from the cell inside the set to this one.
  std::vector<GridPlace> path_to(const GridPlace& cell) const;

  /// Corners of closed paths, from the cell inside a set and back to it (turns later), of which all closed
  /// paths in the set are made.
  std::vector<std::vector<GridPlace>> loops(std::size_t set) const;

  /// Those of no more than so many cells: in rows, with axis 0, or in columns.
  std::vector<GridGap> gaps(std::size_t axis, std::ptrdiff_t most_cells) const;

 private:
  void find_runs();
  void add_run(const GridRun& run);
  void link_rows(std::ptrdiff_t row, std::ptrdiff_t above);
  void link_within(std::ptrdiff_t row);
  void grow_tree(std::size_t set);
  std::size_t run_of(const GridPlace& cell) const;
  std::vector<std::size_t> links_to(std::size_t run) const;

  const ValueGrid& grid_;
  std::vector<GridRun> runs_;            // by row, then by column
  std::vector<std::size_t> row_begins_;  // index of the first run of each row, and of the end
  std::vector<GridLink> links_;
  std::vector<std::vector<std::size_t>> links_of_;  // by run
  std::vector<std::size_t> arrivals_;               // by run, the link that the tree comes to it by
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_GRID_RUNS_H
