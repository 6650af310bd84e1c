// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_FRAME_CORRECTIONS_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_FRAME_CORRECTIONS_H

#include "urdf/corrections/correction.h"

#include <vector>

namespace parallel_aspects {

/// Of the frames that closures hold: another link in a closure, a closure that is missing, another parent of
/// a frame. Those of one kind are together, the kinds in the order in which they are to be tried. None gives
/// two legs one anchor, unless legs share one already or the platform is a point.
std::vector<Corrections> frame_corrections(const Tree& tree, const ResolvedConfig& resolved,
                                           const ClosureSystem& system, const SourceNames& files);

/// Of a closure that holds the start of the body that the operational point is on: that point in its place.
Corrections point_corrections(const Tree& tree, const ResolvedConfig& resolved, const ClosureSystem& system,
                              const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_FRAME_CORRECTIONS_H
