// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_NODE_SEARCH_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_NODE_SEARCH_H

#include "aspects/cusps/strut_slice.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <vector>

namespace parallel_aspects {

/// Boxes of a slice, one about either of two poses [half turns].
using BoxPair = std::array<Box, 2>;

/// The nodes of a slice.
struct NodeBoxes {
  std::vector<BoxPair> nodes;      ///< each holds exactly one pair; no two the same
  std::vector<BoxPair> undecided;  ///< whatever other pairs there are, are in these
  bool cancelled = false;
};

/// Pairs of different singular poses x, y of one slice with the same lengths:
///
///     g(x) = g(y),  D(x) = D(y) = 0.
///
/// A regular zero is isolated by Krawczyk's test in four coordinates; there the images of both arcs of D = 0
/// cross. No other pairs are in two boxes with images that are apart, and none in one box where g takes the
/// arcs of D = 0 to their images one to one, see `InjectiveBoxes`.
///
/// `cusps` are boxes that hold those of the slice. Needs a live `RoundingUpward`.
NodeBoxes find_node_boxes(const StrutSlice& slice, const std::vector<Box>& cusps, const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_NODE_SEARCH_H
