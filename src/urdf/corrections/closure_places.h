// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_CLOSURE_PLACES_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_CLOSURE_PLACES_H

#include "urdf/corrections/correction.h"
#include "urdf/corrections/loop_joints.h"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Of closures whose ends are places beside links: these in metres, where they are far beyond the lengths of
/// the joints in the loops; one for all, as who writes millimetres does so throughout.
Corrections closure_unit_corrections(const Tree& tree, const ResolvedConfig& resolved,
                                     const LoopJoints& loops, const SourceNames& files);

/// Of these closures, by their indices: a coordinate of the other sign, and two exchanged.
Corrections closure_place_corrections(const Tree& tree, const ResolvedConfig& resolved,
                                      const std::vector<std::size_t>& closures, const SourceNames& files);

/// "write xyz=\"1 0 0\" in link 'a' of closure 'b'": the second end of a closure, in the words of its
/// description.
std::string place_remedy(const Tree& tree, const ResolvedConfig& resolved, std::size_t closure,
                         const Eigen::Vector3d& place);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_CLOSURE_PLACES_H
