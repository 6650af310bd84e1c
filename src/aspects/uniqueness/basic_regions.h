// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_BASIC_REGIONS_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_BASIC_REGIONS_H

#include "aspects/uniqueness/actuated_plane.h"
#include "aspects/uniqueness/solution_regions.h"
#include "aspects/uniqueness/solution_tracker.h"

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// The poses that one solution of a set of actuated values moves through as these move all over the set.
struct FoundRegion {
  std::size_t set = 0;       ///< index of the set
  std::size_t solution = 0;  ///< index of the solution, in the set
  int aspect = 0;            ///< id
  /// Proved: no two of its poses over whole cells have the same actuated values; or over any piece of the
  /// set, where the aspect has one solution there.
  bool is_unique = false;
  double area = 0.0;  ///< of the actuated values of these, a lower bound [m^2]
};

/// The basic regions of all aspects of a slice, and which of them are neighbours: a path of regular poses,
/// which is proved, leads from one to the other.
struct FoundRegions {
  std::vector<FoundRegion> regions;
  std::vector<std::pair<std::size_t, std::size_t>>
      neighbours;  ///< indices, the smaller first; each pair once
};

/// Lifts the sets into the slice. In each piece of a set every solution is a continuous function of the
/// lengths, since the piece is convex and no singular pose leads there. These are followed from whole cell to
/// whole cell; where each link of these leads every solution to itself, the region of a solution meets every
/// lengths once. `aspect_of` tells the aspect of the solution in a box, 0 where it can not. Needs a live
/// `RoundingUpward`.
FoundRegions find_basic_regions(const StrutSlice& slice, const ActuatedPlane& plane,
                                const std::vector<SolutionSet>& sets,
                                const std::function<int(const Box&)>& aspect_of, const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_BASIC_REGIONS_H
