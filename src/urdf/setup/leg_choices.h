// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_LEG_CHOICES_H
#define PARALLEL_ASPECTS_URDF_SETUP_LEG_CHOICES_H

#include "urdf/setup/body_graph.h"

#include <vector>

namespace parallel_aspects {

/// Of the parts between base and platform, those that may be the legs: all; and all but one chain, which is
/// passive where the others move the platform: that which it hangs on in the tree, or one that is unlike the
/// others, which are alike.
std::vector<std::vector<GraphPart>> leg_choices(const Tree& tree, const std::vector<GraphPart>& parts);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_LEG_CHOICES_H
