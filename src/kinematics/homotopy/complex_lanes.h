// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_HOMOTOPY_COMPLEX_LANES_H
#define PARALLEL_ASPECTS_KINEMATICS_HOMOTOPY_COMPLEX_LANES_H

/// Arithmetic on eight complex numbers at once, for algorithms that do the same work on many problems. The
/// compiler maps it to what vector instructions the processor has. Everything is inlined, so that it takes on
/// the instruction set of the function that it is used in.
namespace parallel_aspects::lanes {

inline constexpr int count = 8;

#define PARALLEL_ASPECTS_INLINE [[gnu::always_inline]] inline
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

#include "kinematics/homotopy/complex_lanes.inc"

#pragma GCC diagnostic pop

}  // namespace parallel_aspects::lanes

#endif  // PARALLEL_ASPECTS_KINEMATICS_HOMOTOPY_COMPLEX_LANES_H
