// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/regions/basic_regions.h"

#include "interval/interval.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <deque>
#include <utility>

namespace parallel_aspects {

SolutionLift::SolutionLift(const SolutionTracker& tracker, const ActuatedSpace& space,
                           const LinksByPiece& links, const SolutionSet& set, const MapControl& control)
    : tracker_(tracker), space_(space), links_(links), set_(set), same_(set.solutions->size()) {
  assert_rounding_upward();
  spread(control);
  compare_links(control);
  for (std::uint32_t k = 0; k < same_.size(); ++k) labels_.push_back(same_.find(k));
  for (const PieceIndex piece : set_.pieces)
    if (at(piece) != nullptr)
      measure_ = (Interval(measure_) + Interval(space_.pieces()[piece].measure)).lower();
}

const SolutionLift::Solutions* SolutionLift::at(PieceIndex piece) const {
  const auto found = over_.find(piece);
  return found == over_.end() ? nullptr : &found->second;
}

// Whole cells first, from which it is easier.
void SolutionLift::spread(const MapControl& control) {
  over_[set_.largest] = *set_.solutions;
  std::deque<PieceIndex> whole{set_.largest}, others;
  while (!(whole.empty() && others.empty()) && !is_cancelled(control)) {
    std::deque<PieceIndex>& open = whole.empty() ? others : whole;
    const PieceIndex from = open.front();
    open.pop_front();
    for (const std::size_t link : links_[from]) {
      const auto entered = enter(link, from);
      if (entered) (is_whole(*entered) ? whole : others).push_back(*entered);
    }
  }
}

std::optional<PieceIndex> SolutionLift::enter(std::size_t index, PieceIndex from) {
  const PieceLink& link = space_.links()[index];
  const std::size_t end = link.pieces[0] == from ? 0 : 1;
  const PieceIndex to = link.pieces[1 - end];
  if (over_.count(to) > 0) return std::nullopt;
  auto there = across(link, end);
  if (!there) return std::nullopt;
  over_.emplace(to, std::move(*there));
  has_parts_beyond_.insert(from);
  entered_by_.insert(index);
  return to;
}

std::vector<std::size_t> SolutionLift::links_inside() const {
  std::vector<std::size_t> result;
  for (const PieceIndex piece : set_.pieces)
    for (const std::size_t link : links_[piece])
      if (space_.links()[link].pieces[0] == piece && entered_by_.count(link) == 0 && at(piece) != nullptr &&
          at(space_.links()[link].pieces[1]) != nullptr)
        result.push_back(link);
  return result;
}

void SolutionLift::compare_links(const MapControl& control) {
  const std::vector<std::size_t> inside = links_inside();
  std::vector<Comparison> comparisons(inside.size());
  tbb::parallel_for(std::size_t{0}, inside.size(), [&](std::size_t i) {
    const RoundingUpward rounding;
    if (!is_cancelled(control)) comparisons[i] = compared(space_.links()[inside[i]]);
  });
  for (std::size_t i = 0; i < inside.size(); ++i) take(space_.links()[inside[i]], comparisons[i]);
}

/// Which solution at the second piece each one at the first leads to.
SolutionLift::Comparison SolutionLift::compared(const PieceLink& link) const {
  const auto there = across(link, 0);
  if (!there) return std::nullopt;
  std::vector<std::size_t> result;
  for (const Box& box : *there) {
    const auto same = SolutionTracker::find(box, over_.at(link.pieces[1]));
    if (!same) return std::nullopt;
    result.push_back(*same);
  }
  return result;
}

/// Where it is not known where a link leads, a piece is left out again that nothing was reached from.
void SolutionLift::take(const PieceLink& link, const Comparison& comparison) {
  const auto& [first, second] = link.pieces;
  if (at(first) == nullptr || at(second) == nullptr) return;
  if (comparison) {
    for (std::uint32_t k = 0; k < comparison->size(); ++k)
      same_.unite(k, static_cast<std::uint32_t>((*comparison)[k]));
  } else if (has_parts_beyond_.count(second) == 0) {
    over_.erase(second);
  } else if (has_parts_beyond_.count(first) == 0) {
    over_.erase(first);
  } else {
    consistent_ = false;
  }
}

/// From one end of a link to the other; nothing where one of the solutions can not be followed.
std::optional<SolutionLift::Solutions> SolutionLift::across(const PieceLink& link, std::size_t from) const {
  const PieceIndex start = link.pieces[from], end = link.pieces[1 - from];
  const ActuatedValues &near = link.common[from], &far = link.common[1 - from];
  Solutions result;
  for (const Box& box : over_.at(start)) {
    auto next = tracker_.follow(box, space_.point_of(start), near);
    if (next && near != far) next = tracker_.widened(*next, far, turn_slack);  // a turn apart
    if (next) next = tracker_.follow(*next, far, space_.point_of(end));
    if (!next) return std::nullopt;
    result.push_back(*next);
  }
  return result;
}

namespace {

// Of the cells between two sets so many are examined for neighbours.
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
