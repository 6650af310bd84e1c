// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_LIKE_HINGES_H
#define PARALLEL_ASPECTS_URDF_SETUP_LIKE_HINGES_H

#include "urdf/description/tree.h"
#include "urdf/setup/body_graph.h"
#include "urdf/setup/open_ends.h"

#include <array>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Where a hinge carries the platform on one leg, and the other legs are like that one but for it: the pairs
/// of a pairing with the axis that this hinge has in its leg, as it is while all joints are zero, as
/// {"corner_2@0:0:0:1.57:0:0", "foot_2@0:0:0:0:1.57:0"}. Nothing where the axes are those of the frames.
std::vector<std::array<std::string, 2>> like_hinges(const Tree& tree, const Bodies& bodies,
                                                    const Pairing& pairing);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_LIKE_HINGES_H
