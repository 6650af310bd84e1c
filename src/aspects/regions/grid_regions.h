// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_REGIONS_GRID_REGIONS_H
#define PARALLEL_ASPECTS_ASPECTS_REGIONS_GRID_REGIONS_H

#include "aspects/cusps/held_slice.h"
#include "aspects/regions/found_regions.h"
#include "aspects/solutions/grid_runs.h"
#include "aspects/solutions/slice_equations.h"
#include "aspects/solutions/solution_equations.h"
#include "aspects/solutions/value_grid.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// All solutions that a working mode has for some joint values.
struct ModeSolutions {
  std::vector<Box> boxes;    ///< each with one, no two the same
  std::vector<int> aspects;  ///< of each; 0 where it is not known
};

/// Those of joint values; nothing where it is not proved that these are all.
using SolveMode = std::function<std::optional<ModeSolutions>(const std::array<double, 2>&)>;

/// The basic regions of the aspects of one working mode, over the sets of a grid in which all cells are
/// marked that images of singular poses of this mode touch. In such a set the mode has a constant number of
/// solutions, which no path in it leads to a singularity.
class GridRegions {
 public:
  /// The slice and the grid must outlive it. Needs a live `RoundingUpward`.
  GridRegions(const HeldSlice& slice, const ValueGrid& grid, const SolveMode& solve,
              const MapControl& control);

  const FoundRegions& found() const noexcept { return result_; }

  /// In the set of a region, its solution [half turns].
  const Box& solution_of(const FoundRegion& region) const {
    return solved_[region.set]->boxes[region.solution];
  }

  /// The region of a solution in a box, the only one in it for these values; nothing where it is not known.
  /// Needs a live `RoundingUpward`.
  std::optional<std::size_t> locate(const Box& box, const std::array<double, 2>& values) const;

 private:
  using Corners = std::vector<GridPlace>;
  using IndexPair = std::pair<std::size_t, std::size_t>;  // the smaller first

  void find_regions(std::size_t set);
  void label(std::size_t set, RegionsOfSet& of) const;
  void find_neighbours(std::size_t axis, const MapControl& control);
  std::vector<GridPlace> cells_in(const GridGap& gap) const;
  bool cross(const GridGap& gap);
  std::optional<Box> follow(Box box, const Corners& corners) const;
  std::optional<std::size_t> arrived(std::size_t set, const Box& box, const GridPlace& at) const;
  ActuatedValues values_at(const GridPlace& place) const;

  const ValueGrid& grid_;
  SliceEquations equations_;
  SolutionTracker tracker_;
  GridRuns runs_;
  std::vector<std::optional<ModeSolutions>> solved_;  // by set
  std::vector<std::vector<std::size_t>> region_of_;   // by set and solution
  std::set<IndexPair> neighbours_;                    // regions
  std::set<GridPlace> crossed_;                       // cells in no set that neighbours are joined through
  FoundRegions result_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_REGIONS_GRID_REGIONS_H
