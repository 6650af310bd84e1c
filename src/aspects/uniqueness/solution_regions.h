// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_REGIONS_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_REGIONS_H

#include "aspects/uniqueness/actuated_plane.h"
#include "aspects/uniqueness/strut_slice.h"
#include "parallel_aspects/aspects/map_control.h"

#include <array>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// A connected set of pieces of the plane of lengths: the number of solutions is the same all over it.
struct SolutionSet {
  std::vector<PieceIndex> pieces;             ///< by index
  PieceIndex largest = 0;                     ///< of them
  std::array<double, 2> inside{};             ///< lengths in its largest piece [m]
  std::optional<std::vector<Box>> solutions;  ///< all there are inside; nothing where that is not proved
  double area = 0.0;                          ///< a lower bound [m^2]
  double estimate = 0.0;                      ///< the same with its share of what is unknown [m^2]
};

/// The largest first. Needs a live `RoundingUpward`.
std::vector<SolutionSet> find_solution_sets(const StrutSlice& slice, ActuatedPlane& plane,
                                            const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_REGIONS_H
