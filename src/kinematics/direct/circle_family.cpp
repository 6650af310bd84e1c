// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/circle_family.h"

#include "kinematics/direct/trigonometric_roots.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
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
