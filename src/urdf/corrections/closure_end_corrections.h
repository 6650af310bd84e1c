// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_CLOSURE_END_CORRECTIONS_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_CLOSURE_END_CORRECTIONS_H

#include "urdf/corrections/correction.h"
#include "urdf/corrections/legs_of_tree.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
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

/// Ends of closures on the platform in one another's place, where numbers, letters or words in the names of
/// the ends, or of the joints that carry them, pair all ends otherwise than the closures do. Nothing where
/// they agree, or leave any end open.
std::optional<Correction> ends_paired_by_names(const Tree& tree, const ResolvedConfig& resolved,
                                               const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_CLOSURE_END_CORRECTIONS_H
