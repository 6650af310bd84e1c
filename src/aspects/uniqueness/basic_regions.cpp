// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/basic_regions.h"

#include "aspects/components/disjoint_sets.h"
#include "aspects/uniqueness/solution_search.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace parallel_aspects {
namespace {

using Solutions = std::vector<Box>;
using Lengths = std::array<double, 2>;
using SetPair = std::pair<std::size_t, std::size_t>;

// Of the cells between two sets so many are looked at for neighbours.
constexpr std::size_t cells_between_sets = 24;

/// By piece, the index of its set.
std::vector<std::size_t> set_by_piece(const ActuatedPlane& plane, const std::vector<SolutionSet>& sets) {
  std::vector<std::size_t> result(plane.pieces().size());
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (const PieceIndex piece : sets[s].pieces) result[piece] = s;
  return result;
}

std::size_t count_of(const SolutionSet& set) { return set.solutions ? set.solutions->size() : 0; }

/// Follows all solutions; nothing where one of them can not be.
std::optional<Solutions> followed(const SolutionTracker& tracker, const Solutions& solutions,
                                  const Lengths& from, const Lengths& to) {
  Solutions result;
  for (const Box& box : solutions) {
    const auto next = tracker.follow(box, from, to);
    if (!next) return std::nullopt;
    result.push_back(*next);
  }
  return result;
}

/// The solutions of one set over its pieces.
class Lift {
 public:
  using LinksByPiece = std::vector<std::vector<std::size_t>>;

  Lift(const StrutSlice& slice, const ActuatedPlane& plane, const LinksByPiece& links, const SolutionSet& set)
      : tracker_(slice), plane_(plane), links_(links), set_(set), labels_(set.solutions->size()) {}

  /// Over the whole cells of the set.
  void run(const MapControl& control) {
    over_[set_.largest] = *set_.solutions;
    std::vector<PieceIndex> open{set_.largest};
    for (std::size_t i = 0; i < open.size() && !is_cancelled(control); ++i)
      for (const std::size_t link : links_[open[i]]) cross(plane_.links()[link], open[i], open);
    for (const PieceIndex piece : open)
      area_ = (Interval(area_) + Interval(plane_.pieces()[piece].area)).lower();
  }

  /// At the point of a piece, in the order of the set; nothing where they can not be followed there at once.
  const Solutions* at(PieceIndex piece) {
    const auto known = over_.find(piece);
    if (known != over_.end()) return &known->second;
    for (const std::size_t i : links_[piece]) {
      const PieceLink& link = plane_.links()[i];
      const PieceIndex from = link.first == piece ? link.second : link.first;
      if (plane_.pieces()[from].side != 0 || over_.count(from) == 0) continue;
      const auto found = across(link, from, piece);
      if (found) return &(over_[piece] = *found);
    }
    return nullptr;
  }

  /// Of the whole cells that were reached, a lower bound [m^2].
  double area() const noexcept { return area_; }

  /// Whether every link leads each solution to itself, as far as known.
  bool is_consistent() const noexcept { return consistent_; }

  /// The least solution that links lead this one to.
  std::size_t label(std::size_t solution) { return labels_.find(static_cast<std::uint32_t>(solution)); }

 private:
  std::optional<Solutions> across(const PieceLink& link, PieceIndex from, PieceIndex to) const {
    const auto here = followed(tracker_, over_.at(from), plane_.point_of(from), link.common);
    return here ? followed(tracker_, *here, link.common, plane_.point_of(to)) : std::nullopt;
  }

  void cross(const PieceLink& link, PieceIndex from, std::vector<PieceIndex>& open) {
    const PieceIndex to = link.first == from ? link.second : link.first;
    if (plane_.pieces()[to].side != 0) return;
    if (over_.count(to) == 0) {
      const auto found = across(link, from, to);
      if (!found) return;
      over_[to] = *found;
      open.push_back(to);
    } else if (from < to) {  // once
      compare(followed(tracker_, over_.at(from), plane_.point_of(from), link.common),
              followed(tracker_, over_.at(to), plane_.point_of(to), link.common));
    }
  }

  void compare(const std::optional<Solutions>& here, const std::optional<Solutions>& there) {
    for (std::size_t k = 0; k < labels_.size(); ++k) {
      const auto same = here && there ? SolutionTracker::find((*here)[k], *there) : std::nullopt;
      if (same)
        labels_.unite(static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(*same));
      else
        consistent_ = false;
    }
  }

  SolutionTracker tracker_;
  const ActuatedPlane& plane_;
  const LinksByPiece& links_;
  const SolutionSet& set_;
  double area_ = 0.0;
  DisjointSets labels_;
  std::map<PieceIndex, Solutions> over_;
  bool consistent_ = true;
};

class RegionSearch {
 public:
  RegionSearch(const StrutSlice& slice, const ActuatedPlane& plane, const std::vector<SolutionSet>& sets,
               const std::function<int(const Box&)>& aspect_of, const MapControl& control)
      : slice_(slice),
        tracker_(slice),
        plane_(plane),
        sets_(sets),
        aspect_of_(aspect_of),
        control_(control),
        set_of_(set_by_piece(plane, sets)) {}

  FoundRegions run() {
    find_regions();
    for (const auto& [pair, cells] : cells_between())
      for (std::size_t i = 0; i < cells.size() && !is_cancelled(control_); ++i)
        if (i % (1 + cells.size() / cells_between_sets) == 0) cross(pair, cells[i]);
    result_.neighbours.assign(neighbours_.begin(), neighbours_.end());
    return std::move(result_);
  }

 private:
  void find_regions() {
    links_.resize(plane_.pieces().size());
    for (std::size_t i = 0; i < plane_.links().size(); ++i)
      for (const PieceIndex end : {plane_.links()[i].first, plane_.links()[i].second})
        links_[end].push_back(i);
    lifts_.resize(sets_.size());
    region_of_.resize(sets_.size());
    for (std::size_t s = 0; s < sets_.size(); ++s) {
      if (count_of(sets_[s]) == 0) continue;
      std::vector<int> aspects;
      for (const Box& box : *sets_[s].solutions) aspects.push_back(aspect_of_(box));
      const std::set<int> different(aspects.begin(), aspects.end());
      if (different.size() < aspects.size()) {
        lifts_[s].emplace(slice_, plane_, links_, sets_[s]);
        lifts_[s]->run(control_);
      }
      add_regions(s, aspects);
    }
  }

  // With one solution in each aspect there is nothing that it could lead to but itself.
  void add_regions(std::size_t s, const std::vector<int>& aspects) {
    region_of_[s].resize(aspects.size());
    std::map<std::size_t, std::size_t> sizes;
    const auto label = [&](std::size_t k) { return lifts_[s] ? lifts_[s]->label(k) : k; };
    for (std::size_t k = 0; k < aspects.size(); ++k) ++sizes[label(k)];
    for (std::size_t k = 0; k < aspects.size(); ++k) {
      if (label(k) == k) {
        region_of_[s][k] = result_.regions.size();
        const bool is_unique = sizes[k] == 1 && (!lifts_[s] || lifts_[s]->is_consistent());
        result_.regions.push_back(
            {s, k, aspects[k], is_unique && aspects[k] != 0, lifts_[s] ? lifts_[s]->area() : sets_[s].area});
      } else {
        region_of_[s][k] = region_of_[s][label(k)];
      }
    }
  }

  /// Cells with a slab between two sets, by the sets.
  std::map<SetPair, std::vector<const PlaneCell*>> cells_between() const {
    std::map<SetPair, std::vector<const PlaneCell*>> result;
    for (const PlaneCell& cell : plane_.cells()) {
      if (!cell.pieces[0] || !cell.pieces[2]) continue;
      const std::size_t below = set_of_[*cell.pieces[0]], above = set_of_[*cell.pieces[2]];
      if (below != above && count_of(sets_[below]) > 0 && count_of(sets_[above]) > 0)
        result[std::minmax(below, above)].push_back(&cell);
    }
    return result;
  }

  /// The solutions at the point of a piece, with their regions; some may be missing.
  std::vector<std::pair<Box, std::size_t>> solutions_at(PieceIndex piece) {
    std::vector<std::pair<Box, std::size_t>> result;
    const std::size_t s = set_of_[piece];
    if (lifts_[s]) {
      const Solutions* boxes = lifts_[s]->at(piece);
      for (std::size_t k = 0; boxes != nullptr && k < boxes->size(); ++k)
        result.emplace_back((*boxes)[k], region_of_[s][k]);
      return result;
    }
    const auto boxes = find_all_solutions(slice_, values_at(plane_.point_of(piece)));
    for (std::size_t k = 0; boxes && k < boxes->size(); ++k)
      if (const auto region = region_in(s, aspect_of_((*boxes)[k])))
        result.emplace_back((*boxes)[k], *region);
    return result;
  }

  /// The region of a set in an aspect, where there is one alone.
  std::optional<std::size_t> region_in(std::size_t s, int aspect) const {
    for (const std::size_t region : region_of_[s])
      if (aspect != 0 && result_.regions[region].aspect == aspect) return region;
    return std::nullopt;
  }

  void cross(const SetPair& pair, const PlaneCell* cell) {
    PieceIndex from = *cell->pieces[0], to = *cell->pieces[2];
    const std::size_t fewer =
        count_of(sets_[pair.first]) < count_of(sets_[pair.second]) ? pair.first : pair.second;
    if (set_of_[from] != fewer) std::swap(from, to);
    const auto ends = solutions_at(to);
    Solutions boxes;
    for (const auto& end : ends) boxes.push_back(end.first);
    for (const auto& [box, region] : solutions_at(from)) {
      const auto found = tracker_.follow(box, plane_.point_of(from), plane_.point_of(to));
      if (!found || boxes.size() < count_of(sets_[set_of_[to]])) continue;
      if (const auto k = SolutionTracker::find(*found, boxes))
        neighbours_.insert(std::minmax(region, ends[*k].second));
    }
  }

  const StrutSlice& slice_;
  SolutionTracker tracker_;
  const ActuatedPlane& plane_;
  const std::vector<SolutionSet>& sets_;
  const std::function<int(const Box&)>& aspect_of_;
  const MapControl& control_;
  std::vector<std::size_t> set_of_;  // by piece
  Lift::LinksByPiece links_;
  std::vector<std::optional<Lift>> lifts_;           // by set
  std::vector<std::vector<std::size_t>> region_of_;  // by set and solution
  std::set<std::pair<std::size_t, std::size_t>> neighbours_;
  FoundRegions result_;
};

}  // namespace

FoundRegions find_basic_regions(const StrutSlice& slice, const ActuatedPlane& plane,
                                const std::vector<SolutionSet>& sets,
                                const std::function<int(const Box&)>& aspect_of, const MapControl& control) {
  assert_rounding_upward();
  return RegionSearch(slice, plane, sets, aspect_of, control).run();
}

}  // namespace parallel_aspects
