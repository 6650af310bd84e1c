// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_SHARED_ENDS_H
#define PARALLEL_ASPECTS_URDF_SETUP_SHARED_ENDS_H

#include "urdf/setup/open_ends.h"
#include "urdf/setup/setup.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Whether all of so many chains have an anchor, and each anchor two of them, as two legs meet in a corner of
/// a platform, but for one in which the chain ends that carries the platform.
bool meets_in_pairs(const Pairing& pairing, std::size_t chains);

/// Where legs have no common body, all meet in the one anchor there is.
EqualPairings in_one_point(const std::vector<std::size_t>& anchors,
                           const std::vector<std::vector<std::size_t>>& tips);

/// Where two chains meet in each anchor, and no more tells: neighbours in the file share one, in each order
/// of the anchors, beginning with the first chain or with the second. `tips`: of each chain, what may be its
/// end; `carried`: the anchor at which a further chain, the first, carries the platform. None for many
/// anchors.
EqualPairings shared_orders(std::vector<std::size_t> anchors,
                            const std::vector<std::vector<std::size_t>>& tips,
                            std::optional<std::size_t> carried);

/// How many times farther a second end is than the nearest, where positions say which is meant: neighbours in
/// a regular pattern are less than twice as far as each other.
inline constexpr double distinct = 3.0;

using DistanceOfEnds = std::function<double(std::size_t, std::size_t)>;

/// More chains than meet in one point, two each whose ends are by far the nearest to each other, as those of
/// several five-bars on one body.
EqualPairings two_by_two(const std::vector<std::size_t>& ends, const DistanceOfEnds& distance);

/// For the places of chains, where the first way to close the loops holds so many of them, five legs or more,
/// at one link that each needs a place of its own there; else nothing.
std::optional<SetupQuestion> question_of_places(const Tree& tree, const OpenEnds& ends,
                                                const std::string& urdf_name);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_SHARED_ENDS_H
