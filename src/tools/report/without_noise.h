// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_WITHOUT_NOISE_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_WITHOUT_NOISE_H

#include <cmath>

namespace parallel_aspects::tools {

/// For people who read poses and frames [m or rad]: zero where only rounding tells a value from it, of
/// doubles or of a URDF, which gives ten digits at the most.
inline double without_noise(double value) noexcept {
  constexpr double noise = 1e-9;
  return std::abs(value) < noise ? 0.0 : value;
}

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_WITHOUT_NOISE_H
