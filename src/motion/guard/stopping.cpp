// SPDX-License-Identifier: BSD-3-Clause
#include "motion/guard/stopping.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr double rounding = 1e-9;

// The larger root of a s^2 + b s = c for a >= 0; negative where there is none.
double larger_root(double a, double b, double c) noexcept {
  const double squared = b * b + 4.0 * a * c;
  if (!(squared >= 0.0)) return -1.0;
  // Without the difference of nearly equal numbers.
  const double root = std::sqrt(squared);
  if (b > 0.0) return 2.0 * c / (b + root);
  return a > 0.0 ? (root - b) / (2.0 * a) : -1.0;
}

}  // namespace

double StoppingMotion::travel(double scale) const noexcept {
  return scale * speed * (seconds + 0.5 * scale * brake) +
         0.5 * std::max(0.0, last - scale * speed) * last_brake;
}

double StoppingMotion::largest_scale(double room) const noexcept {
  if (!(travel(0.0) <= room)) return 0.0;  // travel is convex in the scale
  if (travel(1.0) <= room) return 1.0;
  const double same = last / speed;  // the scale that goes on as before
  const double bend = 0.5 * speed * brake;
  double scale = larger_root(bend, speed * seconds, room);
  if (!(scale >= same)) {
    const double slope = speed * (seconds - 0.5 * last_brake), rest = room - 0.5 * last * last_brake;
    scale = std::min(same, larger_root(bend, slope, rest));
  }
  scale = std::min(1.0, scale * (1.0 - rounding));
  return scale > 0.0 && travel(scale) <= room * (1.0 + rounding) ? scale : 0.0;
}

}  // namespace parallel_aspects
