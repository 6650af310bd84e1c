// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_LEGS_DETERMINANT_H
#define PARALLEL_ASPECTS_LEGS_DETERMINANT_H

#include <array>
#include <cstddef>

// Determinants of numbers, or of what encloses them.

namespace parallel_aspects {

/// One row of A up to a positive factor.
template <class Scalar, std::size_t N>
using Row = std::array<Scalar, N>;

/// a x b, which has the minors of the rows a and b.
template <class Scalar>
Row<Scalar, 3> cross(const Row<Scalar, 3>& a, const Row<Scalar, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Scalar>
Scalar determinant(const Row<Scalar, 2>& a, const Row<Scalar, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// Of a first row and the cross product of the other two.
template <class Scalar>
Scalar determinant(const Row<Scalar, 3>& first, const Row<Scalar, 3>& minors) {
  return first[0] * minors[0] + first[1] * minors[1] + first[2] * minors[2];
}

/// The minors of three rows of six, by column triples (Laplace's expansion along three rows).
template <class Scalar>
class TripleMinors {
 public:
  void find(const Row<Scalar, 6>& a, const Row<Scalar, 6>& b, const Row<Scalar, 6>& c) {
    std::array<std::array<Scalar, 6>, 6> pairs;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t k = i + 1; k < 6; ++k) pairs[i][k] = b[i] * c[k] - b[k] * c[i];
    for (std::size_t k = 0; k < count; ++k) {
      const auto [i, j, l] = triples[k];
      minors_[k] = a[i] * pairs[j][l] - a[j] * pairs[i][l] + a[l] * pairs[i][j];
    }
  }

  friend Scalar determinant(const TripleMinors& upper, const TripleMinors& lower) {
    Scalar sum = upper.minors_[0] * lower.minors_[count - 1];
    // In this order the complement of a triple stands as far from the end as the triple from the start.
    for (std::size_t k = 1; k < count; ++k) {
      const Scalar product = upper.minors_[k] * lower.minors_[count - 1 - k];
      sum = is_odd(triples[k]) ? sum - product : sum + product;
    }
    return sum;
  }

 private:
  using Triple = std::array<std::size_t, 3>;
  static constexpr std::size_t count = 20;
  static constexpr std::array<Triple, count> triples{{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}, {0, 2, 3},
                                                      {0, 2, 4}, {0, 2, 5}, {0, 3, 4}, {0, 3, 5}, {0, 4, 5},
                                                      {1, 2, 3}, {1, 2, 4}, {1, 2, 5}, {1, 3, 4}, {1, 3, 5},
                                                      {1, 4, 5}, {2, 3, 4}, {2, 3, 5}, {2, 4, 5}, {3, 4, 5}}};

  /// Whether moving these columns to the front takes an odd number of exchanges.
  static constexpr bool is_odd(const Triple& columns) {
    return (columns[0] + columns[1] + columns[2] + 1) % 2 != 0;
  }

  std::array<Scalar, count> minors_;
};

/// Of a matrix, given by rows.
template <class Scalar, std::size_t N>
Scalar determinant_of(const std::array<Row<Scalar, N>, N>& m) {
  static_assert(N == 1 || N == 2 || N == 3 || N == 6);
  if constexpr (N == 1) return m[0][0];
  if constexpr (N == 2) return determinant(m[0], m[1]);
  if constexpr (N == 3) return determinant(m[0], cross(m[1], m[2]));
  if constexpr (N == 6) {
    TripleMinors<Scalar> upper, lower;
    upper.find(m[0], m[1], m[2]);
    lower.find(m[3], m[4], m[5]);
    return determinant(upper, lower);
  }
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_LEGS_DETERMINANT_H
