// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_REGIONS_BASIC_REGIONS_H
#define PARALLEL_ASPECTS_ASPECTS_REGIONS_BASIC_REGIONS_H

#include "aspects/components/disjoint_sets.h"
#include "aspects/regions/found_regions.h"
#include "aspects/solutions/actuated_space.h"
#include "aspects/solutions/solution_equations.h"
#include "aspects/solutions/solution_regions.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// By piece, the indices of its links.
using LinksByPiece = std::vector<std::vector<std::size_t>>;

/// The solutions of one set of actuated values over its pieces. In each piece every solution is a continuous
/// function of the values, since the piece is convex and no singular pose leads there. These are followed
/// from piece to piece. Needs a live `RoundingUpward`.
class SolutionLift {
 public:
  using Solutions = std::vector<Box>;

  /// What it is given must outlive it.
  SolutionLift(const SolutionTracker& tracker, const ActuatedSpace& space, const LinksByPiece& links,
               const SolutionSet& set, const MapControl& control);

  /// At the point of a piece, in the order of the set; null where they were not followed to.
  const Solutions* at(PieceIndex piece) const;

  /// Of the pieces that were followed to, a lower bound [m^2 or m^3].
  double measure() const noexcept { return measure_; }

  /// Whether it is known of every link between these pieces where it leads each solution.
  bool is_consistent() const noexcept { return consistent_; }

  /// The least solution that links lead this one to.
  std::size_t label(std::size_t solution) const { return labels_[solution]; }

 private:
  using Comparison = std::optional<std::vector<std::size_t>>;

  void spread(const MapControl& control);
  std::optional<PieceIndex> enter(std::size_t index, PieceIndex from);
  void compare_links(const MapControl& control);
  std::vector<std::size_t> links_inside() const;
  void take(const PieceLink& link, const Comparison& comparison);
  Comparison compared(const PieceLink& link) const;
  std::optional<Solutions> across(const PieceLink& link, std::size_t from) const;
  bool is_whole(PieceIndex piece) const { return space_.pieces()[piece].side == 0; }

  const SolutionTracker& tracker_;
  const ActuatedSpace& space_;
  const LinksByPiece& links_;
  const SolutionSet& set_;
  std::unordered_map<PieceIndex, Solutions> over_;
  std::unordered_set<PieceIndex> has_parts_beyond_;
  std::unordered_set<std::size_t> entered_by_;  // links that led to a piece first
  DisjointSets same_;
  std::vector<std::size_t> labels_;
  double measure_ = 0.0;
  bool consistent_ = true;
};

/// The aspect of the solution in a box, for these values; 0 where it is not known.
using AspectOfSolution = std::function<int(const Box&, const ActuatedValues&)>;

/// Lifts sets of actuated values into the poses, and finds which region holds one.
class RegionAtlas {
 public:
  /// What it is given must outlive it. Needs a live `RoundingUpward`.
  RegionAtlas(const SolutionEquations& equations, SolveAt solve, const ActuatedSpace& space,
              const std::vector<SolutionSet>& sets, AspectOfSolution aspect_of, const MapControl& control);

  const FoundRegions& found() const noexcept { return result_; }

  /// The region of the solution in `box`, the only one in it for these values; nothing where it is
  /// not known. Needs a live `RoundingUpward`.
  std::optional<std::size_t> locate(const Box& box, const ActuatedValues& values) const;

 private:
  using SetPair = std::pair<std::size_t, std::size_t>;
  using Solutions = SolutionLift::Solutions;

  void find_regions(const MapControl& control);
  std::optional<std::size_t> region_in(std::size_t s, int aspect) const;
  std::map<SetPair, std::vector<const SpaceCell*>> cells_between() const;
  std::vector<std::pair<Box, std::size_t>> solutions_at(PieceIndex piece) const;
  std::optional<std::size_t> region_at(PieceIndex piece, const Box& box) const;
  void cross(const SetPair& pair, const SpaceCell& cell);

  SolveAt solve_;
  SolutionTracker tracker_;
  const ActuatedSpace& space_;
  const std::vector<SolutionSet>& sets_;
  AspectOfSolution aspect_of_;
  std::vector<std::size_t> set_of_;  // by piece
  LinksByPiece links_;
  std::vector<std::optional<SolutionLift>> lifts_;   // by set
  std::vector<std::vector<std::size_t>> region_of_;  // by set and solution
  std::set<SetPair> neighbours_;
  FoundRegions result_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_REGIONS_BASIC_REGIONS_H
