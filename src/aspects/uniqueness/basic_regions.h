// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_BASIC_REGIONS_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_BASIC_REGIONS_H

#include "aspects/uniqueness/actuated_space.h"
#include "aspects/uniqueness/solution_lift.h"
#include "aspects/uniqueness/solution_regions.h"
#include "aspects/uniqueness/solution_tracker.h"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// The poses that one solution of a set of actuated values moves through as these move all over the set.
struct FoundRegion {
  std::size_t set = 0;       ///< index of the set
  std::size_t solution = 0;  ///< index of the solution, in the set
  int aspect = 0;            ///< id
  /// Proved: no two of its poses over what was followed have the same actuated values; or over any piece of
  /// the set, where the aspect has one solution there.
  bool is_unique = false;
  double measure = 0.0;  ///< of the actuated values of these, a lower bound [m^2 or m^3]
};

/// The basic regions of all aspects, and which of them are neighbours: a path of regular poses, which is
/// proved, leads from one to the other.
struct FoundRegions {
  std::vector<FoundRegion> regions;
  std::vector<std::pair<std::size_t, std::size_t>>
      neighbours;  ///< indices, the smaller first; each pair once
};

/// The aspect of the solution in a box, for these lengths; 0 where nobody can tell.
using AspectOfSolution = std::function<int(const Box&, const Lengths&)>;

/// Lifts sets of actuated values into the poses, and tells which region holds one.
class RegionAtlas {
 public:
  /// What it is given must outlive it. Needs a live `RoundingUpward`.
  RegionAtlas(const StrutSlice& slice, const ActuatedSpace& space, const std::vector<SolutionSet>& sets,
              AspectOfSolution aspect_of, const MapControl& control);

  const FoundRegions& found() const noexcept { return result_; }

  /// The region of the solution in `box`, the only one in it for these lengths; nothing where nobody can
  /// tell. Needs a live `RoundingUpward`.
  std::optional<std::size_t> locate(const Box& box, const Lengths& lengths) const;

 private:
  using SetPair = std::pair<std::size_t, std::size_t>;
  using Solutions = SolutionLift::Solutions;

  void find_regions(const MapControl& control);
  void add_regions(std::size_t s, const std::vector<int>& aspects);
  std::optional<std::size_t> region_in(std::size_t s, int aspect) const;
  std::map<SetPair, std::vector<const SpaceCell*>> cells_between() const;
  std::vector<std::pair<Box, std::size_t>> solutions_at(PieceIndex piece) const;
  void cross(const SetPair& pair, const SpaceCell& cell);

  const StrutSlice& slice_;
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

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_BASIC_REGIONS_H
