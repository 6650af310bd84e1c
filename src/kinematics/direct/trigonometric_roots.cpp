// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/trigonometric_roots.h"

#include "model/angles.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

// Half an arc that is not split any further [rad]; a double root is known to no more than half the digits.
constexpr double shortest_arc = 1e-8;

class RootIsolation {
 public:
  explicit RootIsolation(const TrigonometricPolynomial& f)
      : f_(f), third_bound_(f.bound(3)), noise_(64.0 * std::numeric_limits<double>::epsilon() * f.bound(0)) {}

  std::vector<double> roots() {
    // An uneven start, so that the symmetric poses that people like do not fall on ends of arcs.
    constexpr int arcs = 8;
    constexpr double start = -pi + 0.1234567;
    for (int i = 0; i < arcs; ++i) search(start + full_turn * i / arcs, start + full_turn * (i + 1) / arcs);
    for (double& root : roots_) root = std::remainder(root, full_turn);
    return roots_;
  }

 private:
  void search(double lower, double upper) {
    const double middle = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
    const auto [value, slope, curvature] = f_.derivatives(middle);
    // Taylor about the middle, with a bound of its third derivative: on this arc f strays from its value
    // there by at most `largest_drop`, and f' from its own by at most `bend`. So it has no root, is monotone,
    // or is halved.
    const double bend = half * (std::abs(curvature) + 0.5 * half * third_bound_);
    const double largest_drop =
        half * (std::abs(slope) + half * (0.5 * std::abs(curvature) + half * third_bound_ / 6.0));
    if (std::abs(value) > largest_drop + noise_) return;
    if (std::abs(slope) > bend) return search_monotone(lower, upper);
    if (half < shortest_arc || largest_drop < noise_) return roots_.push_back(middle);
    search(lower, middle);
    search(middle, upper);
  }

  // Both neighbours evaluate a shared end alike, so a root there is found by exactly one of them, except for
  // roots within rounding of an end, which are taken by both.
  void search_monotone(double lower, double upper) {
    const double at_lower = f_.derivatives(lower)[0], at_upper = f_.derivatives(upper)[0];
    if (std::abs(at_lower) <= noise_) roots_.push_back(lower);
    if (std::abs(at_upper) <= noise_) roots_.push_back(upper);
    if ((at_lower < 0.0) != (at_upper < 0.0)) roots_.push_back(bracketed(lower, upper, at_lower < 0.0));
  }

  // Newton's method, kept inside the bracket by bisection.
  double bracketed(double lower, double upper, bool rising) const {
    double t = 0.5 * (lower + upper);
    for (int i = 0; i < 60 && upper - lower > 1e-15; ++i) {
      const auto [value, slope, curvature] = f_.derivatives(t);
      if (std::abs(value) <= noise_) break;
      ((value < 0.0) == rising ? lower : upper) = t;
      const double next = t - value / slope;
      t = next > lower && next < upper ? next : 0.5 * (lower + upper);
    }
    return t;
  }

  const TrigonometricPolynomial& f_;
  double third_bound_;
  double noise_;
  std::vector<double> roots_;
};

}  // namespace

TrigonometricPolynomial TrigonometricPolynomial::interpolated(const std::function<double(double)>& function) {
  // Cosines and sines up to this degree are orthogonal over more than twice as many even samples.
  constexpr std::size_t samples = 2 * degree + 2;
  TrigonometricPolynomial f;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = full_turn * static_cast<double>(i) / samples;
    const double value = function(t) / samples;
    for (std::size_t k = 0; k <= degree; ++k) {
      f.cosine[k] += (k == 0 ? 1.0 : 2.0) * value * std::cos(static_cast<double>(k) * t);
      f.sine[k] += 2.0 * value * std::sin(static_cast<double>(k) * t);
    }
  }
  return f;
}

std::array<double, 3> TrigonometricPolynomial::derivatives(double t) const {
  const double c1 = std::cos(t), s1 = std::sin(t);
  std::array<double, 3> result{cosine[0], 0.0, 0.0};
  double c = c1, s = s1;
  for (std::size_t k = 1; k <= degree; ++k) {
    const auto order = static_cast<double>(k);
    const double term = cosine[k] * c + sine[k] * s;
    result[0] += term;
    result[1] += order * (sine[k] * c - cosine[k] * s);
    result[2] -= order * order * term;
    const double next = c * c1 - s * s1;
    s = s * c1 + c * s1;
    c = next;
  }
  return result;
}

double TrigonometricPolynomial::bound(int k) const {
  double sum = k == 0 ? std::abs(cosine[0]) : 0.0;
  for (std::size_t i = 1; i <= degree; ++i)
    sum += std::pow(static_cast<double>(i), k) * std::hypot(cosine[i], sine[i]);
  return sum;
}

std::vector<double> real_roots(const TrigonometricPolynomial& polynomial) {
  if (!std::isfinite(polynomial.bound(3))) return {};
  return RootIsolation(polynomial).roots();
}

}  // namespace parallel_aspects
