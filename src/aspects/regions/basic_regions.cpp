// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/regions/basic_regions.h"

#include "interval/rounding.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

// Of the cells between two sets so many are looked at for neighbours.
constexpr std::size_t cells_between_sets = 100;

/// By piece, the index of its set.
std::vector<std::size_t> set_by_piece(const ActuatedSpace& space, const std::vector<SolutionSet>& sets) {
  std::vector<std::size_t> result(space.pieces().size());
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (const PieceIndex piece : sets[s].pieces) result[piece] = s;
  return result;
}

LinksByPiece links_by_piece(const ActuatedSpace& space) {
  LinksByPiece result(space.pieces().size());
  for (std::size_t i = 0; i < space.links().size(); ++i)
    for (const PieceIndex end : space.links()[i].pieces) result[end].push_back(i);
  return result;
}

std::size_t count_of(const SolutionSet& set) { return set.solutions ? set.solutions->size() : 0; }

}  // namespace

RegionAtlas::RegionAtlas(const SolutionEquations& equations, SolveAt solve, const ActuatedSpace& space,
                         const std::vector<SolutionSet>& sets, AspectOfSolution aspect_of,
                         const MapControl& control)
    : solve_(std::move(solve)),
      tracker_(equations),
      space_(space),
      sets_(sets),
      aspect_of_(std::move(aspect_of)),
      set_of_(set_by_piece(space, sets)),
      links_(links_by_piece(space)),
      lifts_(sets.size()),
      region_of_(sets.size()) {
  assert_rounding_upward();
  find_regions(control);
  for (const auto& [pair, cells] : cells_between())
    for (std::size_t i = 0; i < cells.size() && !is_cancelled(control); ++i)
      if (i % (1 + cells.size() / cells_between_sets) == 0 &&
          may_have_new_neighbours(result_.regions, neighbours_, region_of_[pair.first],
                                  region_of_[pair.second]))
        cross(pair, *cells[i]);
  result_.neighbours.assign(neighbours_.begin(), neighbours_.end());
}

void RegionAtlas::find_regions(const MapControl& control) {
  double done = 0.0;
  for (std::size_t s = 0; s < sets_.size() && !is_cancelled(control); ++s) {
    done += static_cast<double>(sets_[s].pieces.size());
    if (count_of(sets_[s]) == 0) continue;
    RegionsOfSet of{s, {}, {}, true, sets_[s].measure};
    for (const Box& box : *sets_[s].solutions) of.aspects.push_back(aspect_of_(box, sets_[s].inside));
    if (!have_own_aspects(of.aspects)) {
      const SolutionLift& lift = lifts_[s].emplace(tracker_, space_, links_, sets_[s], control);
      for (std::size_t k = 0; k < of.aspects.size(); ++k) of.labels.push_back(lift.label(k));
      of.is_consistent = lift.is_consistent();
      of.measure = lift.measure();
    }
    region_of_[s] = add_regions(of, result_);
    if (control.progress) control.progress(done / static_cast<double>(set_of_.size()));
  }
}

/// Cells with a slab between two sets, by the sets.
std::map<RegionAtlas::SetPair, std::vector<const SpaceCell*>> RegionAtlas::cells_between() const {
  std::map<SetPair, std::vector<const SpaceCell*>> result;
  for (const SpaceCell& cell : space_.cells()) {
    if (!cell.pieces[0] || !cell.pieces[2]) continue;
    const std::size_t below = set_of_[*cell.pieces[0]], above = set_of_[*cell.pieces[2]];
    if (below != above && count_of(sets_[below]) > 0 && count_of(sets_[above]) > 0)
      result[std::minmax(below, above)].push_back(&cell);
  }
  return result;
}

/// The solutions at the point of a piece, with their regions; some may be missing.
std::vector<std::pair<Box, std::size_t>> RegionAtlas::solutions_at(PieceIndex piece) const {
  std::vector<std::pair<Box, std::size_t>> result;
  const std::size_t s = set_of_[piece];
  if (lifts_[s]) {
    const Solutions* boxes = lifts_[s]->at(piece);
    for (std::size_t k = 0; boxes != nullptr && k < boxes->size(); ++k)
      result.emplace_back((*boxes)[k], region_of_[s][k]);
    return result;
  }
  const ActuatedValues values = space_.point_of(piece);
  const auto boxes = solve_(values);
  for (std::size_t k = 0; boxes && k < boxes->size(); ++k)
    if (const auto region = region_in(s, aspect_of_((*boxes)[k], values)))
      result.emplace_back((*boxes)[k], *region);
  return result;
}

/// The region of a set in an aspect, where there is one alone.
std::optional<std::size_t> RegionAtlas::region_in(std::size_t s, int aspect) const {
  for (const std::size_t region : region_of_[s])
    if (aspect != 0 && result_.regions[region].aspect == aspect) return region;
  return std::nullopt;
}

void RegionAtlas::cross(const SetPair& pair, const SpaceCell& cell) {
  PieceIndex from = *cell.pieces[0], to = *cell.pieces[2];
  const std::size_t fewer =
      count_of(sets_[pair.first]) < count_of(sets_[pair.second]) ? pair.first : pair.second;
  if (set_of_[from] != fewer) std::swap(from, to);
  for (const auto& [box, region] : solutions_at(from)) {
    if (!may_have_new_neighbours(result_.regions, neighbours_, {region}, region_of_[set_of_[to]])) continue;
    const auto there = tracker_.follow(box, space_.point_of(from), space_.point_of(to));
    const auto other = there ? region_at(to, *there) : std::nullopt;
    if (other && result_.regions[region].aspect == result_.regions[*other].aspect)
      neighbours_.insert(std::minmax(region, *other));
  }
}

/// The region of the solution in a box, the only one in it for the values at the point of a piece.
std::optional<std::size_t> RegionAtlas::region_at(PieceIndex piece, const Box& box) const {
  const std::size_t s = set_of_[piece];
  if (!lifts_[s]) return region_in(s, aspect_of_(box, space_.point_of(piece)));
  const Solutions* solutions = lifts_[s]->at(piece);
  const auto k = solutions != nullptr ? SolutionTracker::find(box, *solutions) : std::nullopt;
  return k ? std::optional<std::size_t>(region_of_[s][*k]) : std::nullopt;
}

// A piece is convex, so that the line to its point stays in it.
std::optional<std::size_t> RegionAtlas::locate(const Box& box, const ActuatedValues& values) const {
  assert_rounding_upward();
  const auto piece = space_.find(values);
  if (!piece) return std::nullopt;
  const std::size_t s = set_of_[*piece];
  if (count_of(sets_[s]) == 0) return std::nullopt;
  if (!lifts_[s]) return region_in(s, aspect_of_(box, values));
  const auto there = tracker_.follow(box, values, space_.point_of(*piece));
  return there ? region_at(*piece, *there) : std::nullopt;
}

}  // namespace parallel_aspects
