// SPDX-License-Identifier: BSD-3-Clause
#include "interval/nonsingular.h"

#include "interval/near_identity.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int max_iterations = 6;

// Of an interval without zero.
Interval inverse_of(const Interval& a) { return a.positive() ? reciprocal(a) : -reciprocal(-a); }

bool is_finite(const Interval& a) { return std::isfinite(a.lower()) && std::isfinite(a.upper()); }

double mignitude(const Interval& a) { return std::max({0.0, a.lower(), -a.upper()}); }

/// Points with a radius: |a - middle| <= radius in every entry.
template <int N>
struct Balls {
  Eigen::Matrix<double, N, N> middle, radius;

  void set(Eigen::Index i, Eigen::Index k, const Interval& a) {
    middle(i, k) = 0.5 * (a.lower() + a.upper());
    radius(i, k) = std::max(a.upper() - middle(i, k), middle(i, k) - a.lower());
  }
};

template <int N>
bool proved(const SquareArray<PathForm>& matrix, double& ratio) {
  Balls<N> center, slope;
  for (Eigen::Index i = 0; i < N; ++i)
    for (Eigen::Index k = 0; k < N; ++k) {
      const PathForm& entry = matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
      center.set(i, k, entry.center);
      slope.set(i, k, entry.slope);
    }
  NearIdentity<N> product(center.middle);
  product.add_slope(slope.middle);
  product.add_error(center.radius + slope.radius);
  return product.is_nonsingular(max_iterations, ratio);
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
