// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/circle_family.h"

#include "model/angles.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>

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

namespace {

using Candidate = CircleFamilySolutions::Candidate;

// Determinants below this, relative to the largest entries at any angle, say too little about where two lines
// meet.
constexpr double small_determinant = 1e-3;

// Entries below this, relative to the largest at any angle, say too little about where a line is.
constexpr double small_entry = 1e-2;

// Coefficients below this, relative to what they were computed from, are rounding.
constexpr double zero_coefficient = 1e-13;

Eigen::Vector2d cramer_numerator(const LinearPair& pair) {
  const Eigen::Matrix2d& m = pair.matrix;
  return {m(1, 1) * pair.right[0] - m(0, 1) * pair.right[1],
          m(0, 0) * pair.right[1] - m(1, 0) * pair.right[0]};
}

// |v|^2 = r^2 with v by Cramer's rule, times the squared determinant: a polynomial in cosine and sine of the
// angle. Where the determinant vanishes it may have roots that no v belongs to; they do not survive
// refinement.
double eliminant(const CircleFamily& family, double angle) {
  const LinearPair pair = family.equations(angle);
  const double determinant = pair.matrix.determinant();
  return cramer_numerator(pair).squaredNorm() - family.squared_radius * determinant * determinant;
}

// Sizes of the equations over all angles: squared entries of the matrix, and the eliminant's terms before
// they cancel.
struct Scale {
  double matrix = 0.0;
  double eliminant = 0.0;
};

Scale scale_of(const CircleFamily& family) {
  Scale scale;
  for (int i = 0; i < 4; ++i) {
    const LinearPair pair = family.equations(0.5 * EIGEN_PI * i);
    const double m = pair.matrix.squaredNorm();
    scale.matrix = std::max(scale.matrix, m);
    scale.eliminant =
        std::max(scale.eliminant, m * (pair.right.squaredNorm() + std::abs(family.squared_radius) * m));
  }
  return scale;
}

void add_circle(const CircleFamily& family, double angle, std::vector<Candidate>& candidates) {
  const double radius = std::sqrt(std::max(0.0, family.squared_radius));
  for (int i = 0; i < 8; ++i) {
    const double direction = 0.25 * EIGEN_PI * i;
    candidates.push_back({angle, radius * Eigen::Vector2d(std::cos(direction), std::sin(direction))});
  }
}

// Where the better of the two lines meets the circle, or the closest points of the circle.
void add_line_meets_circle(const CircleFamily& family, double angle, const LinearPair& pair,
                           std::vector<Candidate>& candidates) {
  const Eigen::JacobiSVD<Eigen::Matrix2d> svd(pair.matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double radius = std::sqrt(std::max(0.0, family.squared_radius));
  const double norm = svd.singularValues()[0];
  const double along =
      norm > 0.0 ? std::clamp(svd.matrixU().col(0).dot(pair.right) / norm, -radius, radius) : 0.0;
  const double half_chord = std::sqrt(std::max(0.0, radius * radius - along * along));
  for (const double sign : {1.0, -1.0})
    candidates.push_back({angle, along * svd.matrixV().col(0) + sign * half_chord * svd.matrixV().col(1)});
}

void add_candidates(const CircleFamily& family, double angle, double matrix_scale,
                    std::vector<Candidate>& candidates) {
  const LinearPair pair = family.equations(angle);
  const double determinant = pair.matrix.determinant();
  if (determinant != 0.0) candidates.push_back({angle, cramer_numerator(pair) / determinant});
  if (std::abs(determinant) > small_determinant * matrix_scale) return;
  add_line_meets_circle(family, angle, pair, candidates);
  if (pair.matrix.squaredNorm() < small_entry * small_entry * matrix_scale)
    add_circle(family, angle, candidates);
}

std::vector<double> sample_angles() {
  std::vector<double> angles;
  for (int i = 0; i < 12; ++i) angles.push_back(0.1 + EIGEN_PI * i / 6.0);
  return angles;
}

}  // namespace

CircleFamilySolutions circle_family_solutions(const CircleFamily& family) {
  const auto f = TrigonometricPolynomial::interpolated([&](double t) { return eliminant(family, t); });
  const Scale scale = scale_of(family);
  CircleFamilySolutions solutions;
  solutions.every_angle = f.bound(0) <= zero_coefficient * scale.eliminant;
  for (const double angle : solutions.every_angle ? sample_angles() : real_roots(f))
    add_candidates(family, angle, scale.matrix, solutions.candidates);
  return solutions;
}

}  // namespace parallel_aspects
