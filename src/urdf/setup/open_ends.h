// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_OPEN_ENDS_H
#define PARALLEL_ASPECTS_URDF_SETUP_OPEN_ENDS_H

#include "urdf/description/closure.h"
#include "urdf/description/tree.h"
#include "urdf/setup/body_graph.h"

#include <array>
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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_OPEN_ENDS_H
