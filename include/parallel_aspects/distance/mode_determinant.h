// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_MODE_DETERMINANT_H
#define PARALLEL_ASPECTS_DISTANCE_MODE_DETERMINANT_H

#include "parallel_aspects/distance/cell.h"
#include "parallel_aspects/distance/neighbourhood.h"
#include "parallel_aspects/kinematics/working_mode.h"

#include <array>
#include <cstddef>
#include <optional>
#include <variant>

namespace parallel_aspects {

template <class Scalar, std::size_t N>
using SquareRows = std::array<std::array<Scalar, N>, N>;

/// Determinant of the rows i, i+1, i+2 in the columns a, b, c.
template <class Scalar, std::size_t N>
Scalar minor3(const SquareRows<Scalar, N>& m, std::size_t i, std::size_t a, std::size_t b, std::size_t c) {
  const auto pair = [&](std::size_t k, std::size_t l) {
    return m[i + 1][k] * m[i + 2][l] - m[i + 1][l] * m[i + 2][k];
  };
  return m[i][a] * pair(b, c) - m[i][b] * pair(a, c) + m[i][c] * pair(a, b);
}

/// Laplace: by the first three rows and the last three.
template <class Scalar>
Scalar determinant6(const SquareRows<Scalar, 6>& m) {
  Scalar sum(0.0);
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = a + 1; b < 5; ++b)
      for (std::size_t c = b + 1; c < 6; ++c) {
        std::array<std::size_t, 3> rest{};
        for (std::size_t k = 0, i = 0; k < 6; ++k)
          if (k != a && k != b && k != c) rest[i++] = k;
        const Scalar product = minor3(m, 0, a, b, c) * minor3(m, 3, rest[0], rest[1], rest[2]);
        // (0+1+2) + (a+b+c) even: positive.
        sum = (a + b + c) % 2 == 1 ? sum + product : sum - product;
      }
  return sum;
}

template <class Scalar, std::size_t N>
Scalar determinant_of(const SquareRows<Scalar, N>& m) {
  if constexpr (N == 1) return m[0][0];
  if constexpr (N == 2) return m[0][0] * m[1][1] - m[0][1] * m[1][0];
  if constexpr (N == 3) return minor3(m, 0, 0, 1, 2);
  if constexpr (N == 6) return determinant6(m);
}

/// det A of one working mode about one pose, up to positive factors that vanish at serial singularities at
/// most. The neighbourhood must outlive it.
template <TaskSpace space>
class ModeDeterminant {
 public:
  using Hood = Neighbourhood<space>;
  static constexpr std::size_t size = Hood::size;

  ModeDeterminant(const Hood& hood, const Manipulator& manipulator) : hood_(hood) {
    for (std::size_t j = 0; j < size; ++j) {
      const Drive& drive = manipulator.leg(j).drive;
      branches_[j] =
          std::holds_alternative<RevoluteDrive>(drive) || std::holds_alternative<PrismaticDrive>(drive);
    }
  }

  void set_mode(const WorkingMode& mode) noexcept { mode_ = mode; }

  /// In floating point; nothing where a leg does not reach.
  std::optional<PointDual<size>> at(const Coordinates<size>& y) const noexcept {
    std::array<PointDual<size>, size> point;
    for (std::size_t i = 0; i < size; ++i) point[i] = PointDual<size>::coordinate(y[i], i);
    std::array<LegRows<PointDual<size>, size>, size> legs;
    hood_.find_rows(point, legs);
    SquareRows<PointDual<size>, size> rows;
    for (std::size_t j = 0; j < size; ++j) {
      if (!(legs[j].squared_entry.value >= 0.0)) return std::nullopt;
      rows[j] = row(j, legs[j], root(legs[j].squared_entry));
    }
    return determinant_of(rows);
  }

  /// The sign of det A at every pose of a box, where it and that every leg reaches with B_jj != 0 are proved;
  /// else 0.
  int proved_sign(const std::array<Interval, size>& box) const noexcept {
    std::array<LegRows<Interval, size>, size> legs;
    hood_.find_rows(box, legs);
    SquareRows<Interval, size> rows;
    for (std::size_t j = 0; j < size; ++j) {
      if (!legs[j].squared_entry.positive()) return 0;
      rows[j] = row(j, legs[j], root(legs[j].squared_entry));
    }
    const Interval value = determinant_of(rows);
    return value.positive() ? 1 : value.negative() ? -1 : 0;
  }

  /// Whether every leg is proved to reach with B_jj != 0 in a box.
  bool is_reached(const std::array<Interval, size>& box) const noexcept {
    std::array<LegRows<Interval, size>, size> legs;
    hood_.find_rows(box, legs);
    for (const auto& leg : legs)
      if (!leg.squared_entry.positive()) return false;
    return true;
  }

  /// Encloses det A over the part of a cell in the ball |y| <= radius; nothing where no leg reaches there.
  std::optional<Affine<size>> over(const Cell<size>& cell, double radius) const noexcept {
    std::array<LegRows<Affine<size>, size>, size> legs;
    hood_.find_rows(cell.forms(), legs);
    SquareRows<Affine<size>, size> rows;
    for (std::size_t j = 0; j < size; ++j) {
      const Affine<size>& squared = legs[j].squared_entry;
      const Interval range = range_in_ball(squared, cell, radius);
      if (range.negative()) return std::nullopt;
      if (!branches_[j])
        rows[j] = legs[j].fixed;
      else if (range.positive())
        rows[j] = row(j, legs[j], square_root(squared, range.lower()));
      else
        rows[j] = row(j, legs[j], Affine<size>(root(range)));
    }
    return determinant_of(rows);
  }

 private:
  template <class Scalar>
  std::array<Scalar, size> row(std::size_t j, const LegRows<Scalar, size>& leg,
                               const Scalar& entry) const noexcept {
    if (!branches_[j]) return leg.fixed;
    std::array<Scalar, size> result;
    for (std::size_t i = 0; i < size; ++i) {
      const Scalar turned = entry * leg.turned[i];
      result[i] = mode_.sign(j) > 0 ? leg.fixed[i] + turned : leg.fixed[i] - turned;
    }
    return result;
  }

  const Hood& hood_;
  std::array<bool, size> branches_{};  // whether the row depends on the sign of B_jj
  WorkingMode mode_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_MODE_DETERMINANT_H
