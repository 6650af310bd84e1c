// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_ANGLES_H
#define PARALLEL_ASPECTS_MODEL_ANGLES_H

namespace parallel_aspects {

// In radians, rounded to the nearest double.
inline constexpr double pi = 3.141592653589793238462643383279502884;
inline constexpr double full_turn = 2.0 * pi;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_ANGLES_H
