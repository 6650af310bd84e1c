// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_PROOF_REVISION_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_PROOF_REVISION_H

#include <cstdint>

namespace parallel_aspects {

/// Raised with every change to what is proved, or how: a map that an earlier revision computed is computed
/// anew. A test compares the sources of the proofs with what they were at this revision.
inline constexpr std::uint32_t proof_revision = 10;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_PROOF_REVISION_H
