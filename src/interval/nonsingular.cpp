// SPDX-License-Identifier: BSD-3-Clause
#include "interval/nonsingular.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int most_iterations = 6;

// Of an interval without zero.
Interval inverse_of(const Interval& a) { return a.positive() ? reciprocal(a) : -reciprocal(-a); }

bool is_finite(const Interval& a) { return std::isfinite(a.lower()) && std::isfinite(a.upper()); }

double mignitude(const Interval& a) { return std::max({0.0, a.lower(), -a.upper()}); }

template <int N>
using Matrix = Eigen::Matrix<double, N, N>;
template <int N>
using Vector = Eigen::Matrix<double, N, 1>;

/// Points with a radius: |a - middle| <= radius in every entry.
template <int N>
struct Balls {
  Matrix<N> middle, radius;

  void set(Eigen::Index i, Eigen::Index k, const Interval& a) {
    middle(i, k) = 0.5 * (a.lower() + a.upper());
    radius(i, k) = std::max(a.upper() - middle(i, k), middle(i, k) - a.lower());
  }
};

template <int N>
class Proof {
 public:
  explicit Proof(const SquareArray<PathForm>& matrix) {
    for (Eigen::Index i = 0; i < N; ++i)
      for (Eigen::Index k = 0; k < N; ++k) {
        const PathForm& entry = matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
        center_.set(i, k, entry.center);
        slope_.set(i, k, entry.slope);
      }
    inverse_ = center_.middle.inverse();
  }

  bool run(double& ratio) const {
    ratio = std::numeric_limits<double>::infinity();
    if (!inverse_.allFinite()) return false;
    return has_small_radius(deviation(), ratio);
  }

 private:
  // Every sum and product rounds upward, so products of matrices are upper bounds, and those of negated ones
  // bound from below.
  Matrix<N> deviation() const {
    const Matrix<N> negated = -inverse_;
    const Matrix<N> above = center_.middle * inverse_ - Matrix<N>::Identity();
    const Matrix<N> below = center_.middle * negated + Matrix<N>::Identity();
    const Matrix<N> rising = slope_.middle * inverse_, falling = slope_.middle * negated;
    const Matrix<N> radius = center_.radius + slope_.radius;
    return above.cwiseMax(below) + rising.cwiseMax(falling) + radius * inverse_.cwiseAbs();
  }

  // Collatz and Wielandt: the spectral radius of E >= 0 is at most the largest (E v)_i / v_i, for any v > 0.
  static bool has_small_radius(const Matrix<N>& e, double& ratio) {
    Vector<N> v = Vector<N>::Ones();
    for (int i = 0; i < most_iterations; ++i) {
      const Vector<N> image = e * v;
      if (!image.allFinite()) return false;
      ratio = std::min(ratio, image.cwiseQuotient(v).maxCoeff());
      if ((image.array() < v.array()).all()) return true;
      v = image.cwiseMax(1e-9 * image.maxCoeff());
    }
    return false;
  }

  Balls<N> center_, slope_;
  Matrix<N> inverse_;
};

template <int N>
bool proved(const SquareArray<PathForm>& matrix, double& ratio) {
  return Proof<N>(matrix).run(ratio);
}

}  // namespace

int proved_determinant_sign(std::size_t size, SquareArray<Interval> matrix) noexcept {
  assert_rounding_upward();
  int sign = 1;
  for (std::size_t k = 0; k < size; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < size; ++i)
      if (mignitude(matrix[i][k]) > mignitude(matrix[pivot][k])) pivot = i;
    if (!(mignitude(matrix[pivot][k]) > 0.0)) return 0;
    if (pivot != k) {
      std::swap(matrix[pivot], matrix[k]);
      sign = -sign;
    }
    if (matrix[k][k].negative()) sign = -sign;
    const Interval inverse = inverse_of(matrix[k][k]);
    if (!is_finite(inverse)) return 0;
    for (std::size_t i = k + 1; i < size; ++i) {
      const Interval factor = matrix[i][k] * inverse;
      if (!is_finite(factor)) return 0;
      for (std::size_t j = k + 1; j < size; ++j) {
        matrix[i][j] = matrix[i][j] - factor * matrix[k][j];
        if (!is_finite(matrix[i][j])) return 0;
      }
    }
  }
  return sign;
}

bool proved_nonsingular(std::size_t size, const SquareArray<PathForm>& matrix, double& ratio) noexcept {
  assert_rounding_upward();
  switch (size) {
    case 1:
      return proved<1>(matrix, ratio);
    case 2:
      return proved<2>(matrix, ratio);
    case 3:
      return proved<3>(matrix, ratio);
    default:
      return proved<max_legs>(matrix, ratio);
  }
}

}  // namespace parallel_aspects
