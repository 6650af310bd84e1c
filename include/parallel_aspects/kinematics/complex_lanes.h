// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_COMPLEX_LANES_H
#define PARALLEL_ASPECTS_KINEMATICS_COMPLEX_LANES_H

/// Arithmetic on eight complex numbers at once, for algorithms that do the same work on many problems. The
/// compiler maps it to what vector instructions the processor has. Everything is inlined, so that it takes on
/// the instruction set of the function that it is used in.
namespace parallel_aspects::lanes {

inline constexpr int count = 8;

#define PARALLEL_ASPECTS_INLINE [[gnu::always_inline]] inline
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

using Real [[gnu::vector_size(count * sizeof(double))]] = double;
using Mask [[gnu::vector_size(count * sizeof(double))]] = long long;

PARALLEL_ASPECTS_INLINE Real all(double value) { return Real{} + value; }

struct Complex {
  Real re, im;
};

PARALLEL_ASPECTS_INLINE Complex operator+(const Complex& a, const Complex& b) {
  return {a.re + b.re, a.im + b.im};
}
PARALLEL_ASPECTS_INLINE Complex operator-(const Complex& a, const Complex& b) {
  return {a.re - b.re, a.im - b.im};
}
PARALLEL_ASPECTS_INLINE Complex operator-(const Complex& a) { return {-a.re, -a.im}; }
PARALLEL_ASPECTS_INLINE Complex operator*(const Real& a, const Complex& b) { return {a * b.re, a * b.im}; }
PARALLEL_ASPECTS_INLINE Complex operator*(const Complex& a, const Complex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

PARALLEL_ASPECTS_INLINE Real squared_norm(const Complex& a) { return a.re * a.re + a.im * a.im; }

PARALLEL_ASPECTS_INLINE Complex reciprocal(const Complex& a) {
  const Real scale = 1.0 / squared_norm(a);
  return {a.re * scale, -a.im * scale};
}

PARALLEL_ASPECTS_INLINE void swap_where(const Mask& mask, Complex& a, Complex& b) {
  const Complex old = a;
  a = {mask ? b.re : a.re, mask ? b.im : a.im};
  b = {mask ? old.re : b.re, mask ? old.im : b.im};
}

/// Solves n linear equations by Gaussian elimination with partial pivoting in every lane. Row i of
/// `equations` holds the matrix and, in column n, the right side, which becomes the solution. A lane with a
/// singular matrix gets values that are not finite.
template <int n>
PARALLEL_ASPECTS_INLINE void solve(Complex (&equations)[n][n + 1]) {
  for (int k = 0; k < n; ++k) {
    for (int i = k + 1; i < n; ++i) {
      const Mask larger = squared_norm(equations[i][k]) > squared_norm(equations[k][k]);
      for (int j = k; j <= n; ++j) swap_where(larger, equations[k][j], equations[i][j]);
    }
    const Complex inverse = reciprocal(equations[k][k]);
    for (int j = k + 1; j <= n; ++j) equations[k][j] = inverse * equations[k][j];
    for (int i = k + 1; i < n; ++i)
      for (int j = k + 1; j <= n; ++j) equations[i][j] = equations[i][j] - equations[i][k] * equations[k][j];
  }
  for (int k = n - 1; k > 0; --k)
    for (int i = 0; i < k; ++i) equations[i][n] = equations[i][n] - equations[i][k] * equations[k][n];
}

#pragma GCC diagnostic pop

}  // namespace parallel_aspects::lanes

#endif  // PARALLEL_ASPECTS_KINEMATICS_COMPLEX_LANES_H
