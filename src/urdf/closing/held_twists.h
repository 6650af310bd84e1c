// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_HELD_TWISTS_H
#define PARALLEL_ASPECTS_URDF_CLOSING_HELD_TWISTS_H

#include "urdf/closing/chain.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// A movable joint or closure between two rigid bodies.
struct Edge {
  std::size_t from = 0, to = 0;  ///< bodies; for a joint from parent to child
  Chain pivots;                  ///< one, or two for a universal closure
};

using TwistMatrix = Eigen::Matrix<double, 6, 6>;

/// A matrix that is zero on the twists (w, v) which these joints and closures allow the body `platform`
/// against `base`, and nothing else; lengths in units of `size` [m].
TwistMatrix held_twists(const std::vector<Edge>& edges, std::size_t base, std::size_t platform, double size);

/// How many independent twists all of these allow together.
Eigen::Index freedom_left(const std::vector<TwistMatrix>& held);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_HELD_TWISTS_H
