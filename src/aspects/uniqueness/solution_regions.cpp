// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/solution_regions.h"

#include "aspects/uniqueness/solution_search.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace parallel_aspects {
namespace {

/// What is unknown of a cell, divided among its pieces.
double share_of_unknown(const PlaneCell& cell) {
  const auto count = std::count_if(cell.pieces.begin(), cell.pieces.end(),
                                   [](const std::optional<PieceIndex>& piece) { return piece.has_value(); });
  return cell.unknown / static_cast<double>(count);
}

std::vector<SolutionSet> gather(ActuatedPlane& plane) {
  std::map<PieceIndex, SolutionSet> sets;
  for (PieceIndex index = 0; index < plane.pieces().size(); ++index) {
    const Piece& piece = plane.pieces()[index];
    SolutionSet& set = sets[plane.set_of(index)];
    set.pieces.push_back(index);
    set.area = (Interval(set.area) + Interval(piece.area)).lower();
    set.estimate += piece.area + share_of_unknown(plane.cells()[piece.cell]);
  }
  std::vector<SolutionSet> result;
  for (auto& [first, set] : sets) result.push_back(std::move(set));
  return result;
}

void look_inside(const StrutSlice& slice, const ActuatedPlane& plane, SolutionSet& set) {
  set.largest = *std::max_element(set.pieces.begin(), set.pieces.end(), [&](PieceIndex a, PieceIndex b) {
    return plane.pieces()[a].area < plane.pieces()[b].area;
  });
  set.inside = plane.point_of(set.largest);
  set.solutions = find_all_solutions(slice, values_at(set.inside));
}

}  // namespace

std::vector<SolutionSet> find_solution_sets(const StrutSlice& slice, ActuatedPlane& plane,
                                            const MapControl& control) {
  assert_rounding_upward();
  std::vector<SolutionSet> sets = gather(plane);
  std::stable_sort(sets.begin(), sets.end(),
                   [](const SolutionSet& a, const SolutionSet& b) { return a.area > b.area; });
  for (SolutionSet& set : sets)
    if (!is_cancelled(control)) look_inside(slice, plane, set);
  return sets;
}

}  // namespace parallel_aspects
