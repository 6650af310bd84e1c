// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/solution_regions.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace parallel_aspects {
namespace {

/// What is unknown of a cell, divided among its pieces.
double share_of_unknown(const SpaceCell& cell) {
  const auto count = std::count_if(cell.pieces.begin(), cell.pieces.end(),
                                   [](const std::optional<PieceIndex>& piece) { return piece.has_value(); });
  return cell.unknown / static_cast<double>(count);
}

std::vector<SolutionSet> gather(ActuatedSpace& space) {
  std::map<PieceIndex, SolutionSet> sets;
  for (PieceIndex index = 0; index < space.pieces().size(); ++index) {
    const Piece& piece = space.pieces()[index];
    SolutionSet& set = sets[space.set_of(index)];
    set.pieces.push_back(index);
    set.measure = (Interval(set.measure) + Interval(piece.measure)).lower();
    set.estimate += piece.measure + share_of_unknown(space.cells()[piece.cell]);
  }
  std::vector<SolutionSet> result;
  for (auto& [first, set] : sets) result.push_back(std::move(set));
  return result;
}

void look_inside(const SolveAt& solve, const ActuatedSpace& space, SolutionSet& set) {
  set.largest = *std::max_element(set.pieces.begin(), set.pieces.end(), [&](PieceIndex a, PieceIndex b) {
    return space.pieces()[a].measure < space.pieces()[b].measure;
  });
  set.inside = space.point_of(set.largest);
  set.solutions = solve(set.inside);
}

}  // namespace

std::vector<SolutionSet> find_solution_sets(const SolveAt& solve, ActuatedSpace& space,
                                            const MapControl& control, double least_share) {
  assert_rounding_upward();
  std::vector<SolutionSet> sets = gather(space);
  std::stable_sort(sets.begin(), sets.end(),
                   [](const SolutionSet& a, const SolutionSet& b) { return a.measure > b.measure; });
  const double least = least_share * space.cells()[0].box.measure();
  for (SolutionSet& set : sets)
    if (set.measure >= least && !is_cancelled(control)) look_inside(solve, space, set);
  return sets;
}

double measure_without_number(const ActuatedSpace& space, const std::vector<SolutionSet>& sets) noexcept {
  double result = space.unknown();
  for (const SolutionSet& set : sets)
    if (!set.solutions) result += set.measure;
  return result;
}

}  // namespace parallel_aspects
