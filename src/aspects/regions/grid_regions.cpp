// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/regions/grid_regions.h"

#include "aspects/components/disjoint_sets.h"
#include "interval/interval.h"

#include <algorithm>
#include <cstdint>
#include <map>

namespace parallel_aspects {
namespace {

// Rows of marked cells that are longer are not crossed, and of the others between two sets not more than
// these.
constexpr std::ptrdiff_t longest_gap = 40;
constexpr std::size_t gaps_between_sets = 24;

std::pair<std::size_t, std::size_t> sets_of(const GridGap& gap) {
  return std::minmax(gap.sets[0], gap.sets[1]);
}

std::vector<GridPlace> reversed(const std::vector<GridPlace>& corners) {
  return {corners.rbegin(), corners.rend()};
}

std::vector<GridPlace> moved(std::vector<GridPlace> corners, const GridPlace& from, const GridPlace& to) {
  for (GridPlace& corner : corners)
    for (std::size_t i = 0; i < 2; ++i) corner[i] += to[i] - from[i];
  return corners;
}

}  // namespace

GridRegions::GridRegions(const HeldSlice& slice, const ValueGrid& grid, const SolveMode& solve,
                         const MapControl& control)
    : grid_(grid), equations_(slice), tracker_(equations_), runs_(grid), region_of_(grid.sets().size()) {
  assert_rounding_upward();
  for (std::size_t set = 0; set < grid_.sets().size() && !is_cancelled(control); ++set) {
    solved_.push_back(solve(grid_.sets()[set].inside));
    if (solved_.back()) find_regions(set);
  }
  for (const std::size_t axis : {0U, 1U}) find_neighbours(axis, control);
  result_.neighbours.assign(neighbours_.begin(), neighbours_.end());
}

void GridRegions::find_regions(std::size_t set) {
  RegionsOfSet of{set, solved_[set]->aspects, {}, true, 0.0};
  const Interval cells(static_cast<double>(grid_.sets()[set].cells));
  of.measure = (cells * Interval(grid_.steps()[0]) * Interval(grid_.steps()[1])).lower();
  if (!have_own_aspects(of.aspects)) label(set, of);
  region_of_[set] = add_regions(of, result_);
}

/// Where closed paths lead the solutions of a set.
void GridRegions::label(std::size_t set, RegionsOfSet& of) const {
  const std::vector<Box>& boxes = solved_[set]->boxes;
  DisjointSets same(boxes.size());
  for (const Corners& loop : runs_.loops(set))
    for (std::uint32_t k = 0; k < boxes.size(); ++k) {
      const auto there = follow(boxes[k], loop);
      const auto end = there ? arrived(set, *there, loop.back()) : std::nullopt;
      if (end)
        same.unite(k, static_cast<std::uint32_t>(*end));
      else
        of.is_consistent = false;
    }
  for (std::uint32_t k = 0; k < boxes.size(); ++k) of.labels.push_back(same.find(k));
}

/// Cells of a gap, in the first turn.
std::vector<GridPlace> GridRegions::cells_in(const GridGap& gap) const {
  std::vector<GridPlace> result;
  const std::size_t axis = gap.ends[0][0] == gap.ends[1][0] ? 1 : 0;
  GridPlace at = gap.ends[0];
  while (++at[axis] < gap.ends[1][axis]) result.push_back(grid_.within(at));
  return result;
}

// Lines in rows have no values in common, nor have those in columns. A line in a column must not meet one in
// a row: over the values where they do the paths could be at two poses.
void GridRegions::find_neighbours(std::size_t axis, const MapControl& control) {
  std::map<IndexPair, std::vector<GridGap>> between;
  for (const GridGap& gap : runs_.gaps(axis, longest_gap)) between[sets_of(gap)].push_back(gap);
  for (const auto& [sets, gaps] : between) {
    const std::size_t step = 1 + gaps.size() / gaps_between_sets;
    for (std::size_t i = step / 2; i < gaps.size() && !is_cancelled(control); i += step) {
      if (!may_have_new_neighbours(result_.regions, neighbours_, region_of_[sets.first],
                                   region_of_[sets.second]))
        break;
      const std::vector<GridPlace> cells = cells_in(gaps[i]);
      const bool is_free = std::none_of(cells.begin(), cells.end(),
                                        [&](const GridPlace& cell) { return crossed_.count(cell) > 0; });
      if ((axis == 0 || is_free) && cross(gaps[i])) crossed_.insert(cells.begin(), cells.end());
    }
  }
}

/// From the values inside the one set to those inside the other. Whether any regions are new neighbours.
bool GridRegions::cross(const GridGap& gap) {
  Corners corners = runs_.path_to(gap.ends[0]);
  const Corners back = runs_.path_to(grid_.within(gap.ends[1]));
  const GridPlace there = moved({gap.ends[1]}, gap.ends[0], corners.back()).front();
  const Corners rest = moved(reversed(back), back.back(), there);
  corners.insert(corners.end(), rest.begin(), rest.end());
  const std::size_t known = neighbours_.size();
  for (std::size_t k = 0; k < region_of_[gap.sets[0]].size(); ++k) {
    const std::size_t region = region_of_[gap.sets[0]][k];
    if (!may_have_new_neighbours(result_.regions, neighbours_, {region}, region_of_[gap.sets[1]])) continue;
    const auto box = follow(solved_[gap.sets[0]]->boxes[k], corners);
    const auto end = box ? arrived(gap.sets[1], *box, corners.back()) : std::nullopt;
    if (!end) continue;
    const std::size_t other = region_of_[gap.sets[1]][*end];
    if (result_.regions[region].aspect == result_.regions[other].aspect)
      neighbours_.insert(std::minmax(region, other));
  }
  return neighbours_.size() > known;
}

ActuatedValues GridRegions::values_at(const GridPlace& place) const {
  const std::array<double, 2> values = grid_.values_at(place);
  return {values[0], values[1], 0.0};
}

std::optional<Box> GridRegions::follow(Box box, const Corners& corners) const {
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const auto next = tracker_.follow(box, values_at(corners[i]), values_at(corners[i + 1]));
    if (!next) return std::nullopt;
    box = *next;
  }
  return box;
}

/// Which solution of the set is in a box, the only one in it for values inside the set, in some turn. For all
/// values beside these there is one solution in a box about it: so for those in the first turn it is that
/// one.
std::optional<std::size_t> GridRegions::arrived(std::size_t set, const Box& box, const GridPlace& at) const {
  const auto about = tracker_.widened(box, values_at(at), turn_slack);
  return about ? SolutionTracker::find(*about, solved_[set]->boxes) : std::nullopt;
}

std::optional<std::size_t> GridRegions::locate(const Box& box, const std::array<double, 2>& values) const {
  assert_rounding_upward();
  const auto set = grid_.set_of(values);
  if (!set || !solved_[*set]) return std::nullopt;
  const GridPlace cell = grid_.cell_of(values);
  const Corners corners = reversed(runs_.path_to(cell));
  const Corners from = moved(corners, corners.front(), cell);
  const auto start = tracker_.follow(box, {values[0], values[1], 0.0}, values_at(cell));
  const auto there = start ? follow(*start, from) : std::nullopt;
  const auto k = there ? arrived(*set, *there, from.back()) : std::nullopt;
  return k ? std::optional<std::size_t>(region_of_[*set][*k]) : std::nullopt;
}

}  // namespace parallel_aspects
