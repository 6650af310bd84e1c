// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_CELL_SLAB_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_CELL_SLAB_H

#include "interval/interval.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>

// What of a cell of two or three lengths is on one side of a slab: where  slope . (lengths - middle of the
// cell)  is below or above it. All of it needs a live `RoundingUpward`.

namespace parallel_aspects {

/// n . (rho_0^2, rho_1^2, rho_2^2) / 2 over a cell, as  slope . (rho - middle)  and what is left of it.
struct LinearOverCell {
  std::array<double, 3> slope{};
  Interval rest;

  LinearOverCell(const Box& cell, const std::array<double, 3>& normal) noexcept;
};

/// slope . (at - middle).
Interval linear_at(const Box& cell, const std::array<double, 3>& slope,
                   const std::array<double, 3>& at) noexcept;

/// Of the cell [m^2 or m^3].
Interval measure_of(const Box& cell) noexcept;

/// Of what is below (side -1) or above (side 1) the slab [m^2 or m^3].
Interval measure_beside(const Box& cell, const std::array<double, 3>& slope, const Interval& slab,
                        int side) noexcept;

/// Of what is in the slab, an upper bound [m^2 or m^3].
double unknown_measure(const Box& cell, const std::array<double, 3>& slope, const Interval& slab) noexcept;

/// A point of the cell on that side, which is not empty, as far from the slab as is found without a search
/// [m].
std::array<double, 3> point_beside(const Box& cell, const std::array<double, 3>& slope, const Interval& slab,
                                   int side) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_CELL_SLAB_H
