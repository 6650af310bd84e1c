// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_REGIONS_BASIC_REGIONS_H
#define PARALLEL_ASPECTS_ASPECTS_REGIONS_BASIC_REGIONS_H

#include "aspects/regions/found_regions.h"
#include "aspects/regions/solution_lift.h"
#include "aspects/solutions/actuated_space.h"
#include "aspects/solutions/solution_regions.h"
#include "aspects/solutions/solution_tracker.h"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// The aspect of the solution in a box, for these values; 0 where nobody can tell.
using AspectOfSolution = std::function<int(const Box&, const ActuatedValues&)>;

/// Lifts sets of actuated values into the poses, and tells which region holds one.
class RegionAtlas {
 public:
  /// What it is given must outlive it. Needs a live `RoundingUpward`.
  RegionAtlas(const SolutionEquations& equations, SolveAt solve, const ActuatedSpace& space,
              const std::vector<SolutionSet>& sets, AspectOfSolution aspect_of, const MapControl& control);

  const FoundRegions& found() const noexcept { return result_; }

  /// The region of the solution in `box`, the only one in it for these values; nothing where nobody can
  /// tell. Needs a live `RoundingUpward`.
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
