// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_NAMED_ENDS_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_NAMED_ENDS_H

#include "urdf/corrections/correction.h"

#include <optional>

namespace parallel_aspects {

/// Ends of closures on the platform in one another's place, where numbers, letters or words in the names of
/// the ends, or of the joints that carry them, pair all ends otherwise than the closures do. Nothing where
/// they agree, or leave any end open.
std::optional<Correction> ends_paired_by_names(const Tree& tree, const ResolvedConfig& resolved,
                                               const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_NAMED_ENDS_H
