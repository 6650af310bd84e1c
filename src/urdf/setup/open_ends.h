// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_OPEN_ENDS_H
#define PARALLEL_ASPECTS_URDF_SETUP_OPEN_ENDS_H

#include "urdf/description/closure.h"
#include "urdf/description/tree.h"
#include "urdf/setup/body_graph.h"
#include "urdf/setup/setup.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Two links whose origins a closure may hold together, or frames in these.
struct EndPair {
  std::size_t one = 0, other = 0;  ///< links
  std::array<Eigen::Isometry3d, 2> in_link{Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity()};
};

/// One way to close all loops.
struct Pairing {
  std::vector<EndPair> pairs;
  std::string reason;  ///< for all of them
};

/// Pairings with equal evidence.
using EqualPairings = std::vector<Pairing>;

/// Where the chains of a tree end, and which of these ends may be joints that the URDF, a tree, leaves out.
struct OpenEnds {
  std::vector<std::size_t> links;              ///< every end that may be one of a loop
  std::vector<std::size_t> without_tip_frame;  ///< links that end a chain without a frame at their end
  std::optional<std::size_t> platform;  ///< link that most looks like one, where there are several ends
  std::vector<EqualPairings> pairings;  ///< those with most evidence first
  bool evident = false;                 ///< whether positions or names give any
  bool cut_short = false;               ///< whether some are left out, since there are too many
  bool may_have_finger = false;         ///< whether some leave out the one body that ends on a slide
};

/// Ends that coincide at zero come first, then those whose names say so, then all that is left; each pairing
/// once. Fingers and fittings are left open, by their names or as several on one joint each; only what they
/// leave without a pairing that loads is closed by them.
OpenEnds find_open_ends(const Tree& tree, const Bodies& bodies);

/// Where a hinge carries the platform on one leg, and the other legs are like that one but for it: the pairs
/// of a pairing with the axis that this hinge has in its leg, as it is while all joints are zero. Nothing
/// where the axes are those of the frames.
std::optional<Pairing> like_hinges(const Tree& tree, const Bodies& bodies, const Pairing& pairing);

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

#endif  // PARALLEL_ASPECTS_URDF_SETUP_OPEN_ENDS_H
