// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_WITNESS_SEARCH_H
#define PARALLEL_ASPECTS_DISTANCE_WITNESS_SEARCH_H

#include "distance/point_dual.h"

#include <cmath>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// Walks from `y` to a zero of a function that is nearest to the origin, at least locally; the result has
/// value and gradient there. `function(y)` gives a PointDual<N>, or nothing where it is not defined.
///
/// Each step goes to the point nearest to the origin where the linear function at y vanishes (Hasofer and
/// Lind 1974, Rackwitz and Fiessler 1978), shortened until  |y|^2 / 2 + penalty |f|  falls (Zhang and Der
/// Kiureghian 1995).
template <std::size_t N, class Function>
class WitnessSearch {
 public:
  explicit WitnessSearch(const Function& function) noexcept : function_(function) {}

  std::optional<PointDual<N>> run(Coordinates<N>& y) const noexcept {
    std::optional<PointDual<N>> at = function_(y);
    for (int i = 0; i < max_steps && at; ++i) {
      const double squared = dot<N>(at->gradient, at->gradient);
      if (!(squared > 0.0) || !std::isfinite(squared)) return std::nullopt;
      const double factor = (dot<N>(at->gradient, y) - at->value) / squared;
      Coordinates<N> step;
      for (std::size_t k = 0; k < N; ++k) step[k] = factor * at->gradient[k] - y[k];
      const double gap = std::abs(at->value) / std::sqrt(squared);
      if (dot<N>(step, step) <= square(step_tolerance) * dot<N>(y, y)) break;
      if (!advance(step, squared, y, at)) {
        if (!(gap < 0.1 * std::sqrt(dot<N>(y, y)))) return std::nullopt;
        break;
      }
    }
    return at ? polished(y) : std::nullopt;
  }

  /// Newton's method along the gradient, to a zero as exact as rounding lets it be; where the function
  /// touches zero and turns back, to half the digits.
  std::optional<PointDual<N>> polished(Coordinates<N>& y) const noexcept {
    Coordinates<N> from = y;
    if (const auto at = polished(y, 1.0, simple_tolerance)) return at;
    const auto at = polished(from, 2.0, double_tolerance);
    if (at) y = from;
    return at;
  }

 private:
  // Newton's method for zeros of this multiplicity: value / slope over |y| is at most `tolerance` in the end.
  std::optional<PointDual<N>> polished(Coordinates<N>& y, double multiplicity,
                                       double tolerance) const noexcept {
    std::optional<PointDual<N>> at = function_(y);
    PointDual<N> sloped;  // the last with a slope: at the tip of a cone there is none
    for (int i = 0; i < max_polishing && at; ++i) {
      const double squared = dot<N>(at->gradient, at->gradient);
      if (!std::isfinite(squared)) return std::nullopt;
      if (!(squared > 0.0)) break;
      sloped.gradient = at->gradient;
      const double factor = multiplicity * at->value / squared,
                   gap = std::abs(at->value) / std::sqrt(squared);
      for (std::size_t k = 0; k < N; ++k) y[k] -= factor * at->gradient[k];
      at = function_(y);
      if (gap <= 1e-4 * tolerance * std::sqrt(dot<N>(y, y))) break;
    }
    if (!at) return std::nullopt;
    sloped.value = at->value;
    const double scale = std::sqrt(dot<N>(sloped.gradient, sloped.gradient) * dot<N>(y, y));
    return std::abs(at->value) <= tolerance * scale && scale > 0.0 ? std::optional<PointDual<N>>(sloped)
                                                                   : std::nullopt;
  }

  static constexpr double simple_tolerance = 1e-9, double_tolerance = 1e-7;
  static constexpr int max_polishing = 6;
  static constexpr int max_steps = 25;
  static constexpr int max_halvings = 6;
  static constexpr double step_tolerance = 1e-5;

  static double square(double a) noexcept { return a * a; }

  bool advance(const Coordinates<N>& step, double squared, Coordinates<N>& y,
               std::optional<PointDual<N>>& at) const noexcept {
    Coordinates<N> target = y;
    for (std::size_t k = 0; k < N; ++k) target[k] += step[k];
    const double penalty = 2.0 * std::sqrt(std::max(dot<N>(y, y), dot<N>(target, target)) / squared);
    const double before = 0.5 * dot<N>(y, y) + penalty * std::abs(at->value);
    double length = 1.0;
    for (int i = 0; i <= max_halvings; ++i, length *= 0.5) {
      Coordinates<N> next = y;
      for (std::size_t k = 0; k < N; ++k) next[k] += length * step[k];
      const std::optional<PointDual<N>> there = function_(next);
      if (!there || !(0.5 * dot<N>(next, next) + penalty * std::abs(there->value) < before)) continue;
      y = next;
      at = there;
      return true;
    }
    return false;
  }

  const Function& function_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_WITNESS_SEARCH_H
