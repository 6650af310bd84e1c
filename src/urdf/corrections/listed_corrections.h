// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_LISTED_CORRECTIONS_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_LISTED_CORRECTIONS_H

#include "urdf/corrections/correction.h"

#include <string>

namespace parallel_aspects {

/// Of the closures: another type of one, or one less where two are the same.
Corrections closure_corrections(const ResolvedConfig& resolved, const SourceNames& files);

/// "type: point", or "type=\"ball\"" where the URDF has joints of SDF: how the description says it.
std::string type_text(const ResolvedConfig& resolved, ClosureType type);

/// Second frames of closures that are in one another's place; such as are beside their links only where both
/// frames are given, or `with_places_at_zero`.
Corrections exchanged_ends(const Tree& tree, const ResolvedConfig& resolved, const SourceNames& files,
                           bool with_places_at_zero = false);

/// Of the list of actuated joints: one of a leg that has none, one less of a leg that has several, or both.
Corrections actuation_corrections(const Tree& tree, const ResolvedConfig& resolved,
                                  const ClosureSystem& system, const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_LISTED_CORRECTIONS_H
