// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_REGIONS_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_REGIONS_H

#include "aspects/solutions/actuated_space.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <optional>
#include <vector>

namespace parallel_aspects {

/// A connected set of pieces of the plane or space of actuated values: the number of solutions is the same
/// all over it.
struct SolutionSet {
  std::vector<PieceIndex> pieces;             ///< by index
  PieceIndex largest = 0;                     ///< of them
  ActuatedValues inside{};                    ///< in its largest piece [m or rad]
  std::optional<std::vector<Box>> solutions;  ///< all there are inside; nothing where that is not proved
  double measure = 0.0;                       ///< a lower bound [m^2 or m^3]
  double estimate = 0.0;                      ///< the same with its share of what is unknown [m^2 or m^3]
};

/// The largest first. Solutions are not searched in sets below a least share of all values.
/// Needs a live `RoundingUpward`.
std::vector<SolutionSet> find_solution_sets(const SolveAt& solve, ActuatedSpace& space,
                                            const MapControl& control, double least_share = 0.0);

/// Of what has no number of solutions, but for the rounding of a sum [m^2 or m^3]: in no piece, or in a set
/// without solutions that are known.
double measure_without_number(const ActuatedSpace& space, const std::vector<SolutionSet>& sets) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_REGIONS_H
