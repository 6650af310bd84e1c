// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ASPECT_GRAPH_H
#define PARALLEL_ASPECTS_ASPECTS_ASPECT_GRAPH_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_control.h"
#include "parallel_aspects/aspects/neighbours.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace parallel_aspects {

/// Aspects that are proved to be joined through serial singularities: the robot gets from each to each other
/// one, changing its working mode on the way, and never loses control of the platform. All have one sign of
/// det A.
struct AspectSet {
  std::vector<int> aspects;  ///< ids, rising
  int determinant_sign = 0;  ///< +1 or -1
  double workspace_lower =
      0.0;  ///< volume of the poses proved to lie in one of them or more, see `measure_unit`
};

/// The aspects of a map as nodes, and the gates between them.
struct AspectGraph {
  std::vector<Neighbours> gates;  ///< as `find_neighbours` lists them
  std::vector<AspectSet> sets;    ///< by their lowest id; every aspect is in one

  /// Lower bound of the number of different sets that these are parts of, proved: within the region of the
  /// map there is no path between two of so many, whatever serial singularities it goes through.
  std::size_t proved_set_count = 0;

  /// By index of a set, the first set that it is not proved to be different from: its own index for each of
  /// the `proved_set_count`.
  std::vector<std::size_t> set_group;

  /// Index of the set that holds an aspect.
  std::size_t set_of(int aspect) const noexcept;
};

/// Finds the gates and joins the aspects. Sets with different signs of det A are different; of others that is
/// proved by the leaves in which B_jj = 0 is not excluded, of a map of all working modes without a serial
/// margin. The map keeps what was found for those who ask again, and `save_map` writes it. Null where
/// cancelled.
std::shared_ptr<const AspectGraph> compute_aspect_graph(const AspectMap& map, const MapControl& control = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ASPECT_GRAPH_H
