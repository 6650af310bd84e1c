// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_ANCHORS_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_ANCHORS_H

#include "urdf/closing/resolved_config.h"

namespace parallel_aspects {

/// The link above that a movable joint carries, or the root: the same for all links of a body.
std::size_t body_of(const Tree& tree, std::size_t link);

/// Whether two legs are on one point of the platform though others are elsewhere on it. `size`: what lengths
/// are small against [m].
bool legs_share_anchors(const Tree& tree, const ResolvedConfig& resolved, double size);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_ANCHORS_H
