// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CULPRITS_LOOPS_THROUGH_BASE_H
#define PARALLEL_ASPECTS_URDF_CULPRITS_LOOPS_THROUGH_BASE_H

#include "urdf/description/closure.h"

#include <cstddef>

namespace parallel_aspects {

/// Whether the loop of a closure goes through the base, as those of parallelograms in a leg do not.
bool passes_base(const Tree& tree, std::size_t base, const Closure& closure);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CULPRITS_LOOPS_THROUGH_BASE_H
