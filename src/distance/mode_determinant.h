// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_MODE_DETERMINANT_H
#define PARALLEL_ASPECTS_DISTANCE_MODE_DETERMINANT_H

#include "distance/cell.h"
#include "distance/local_chart.h"
#include "distance/quadratic_form.h"
#include "legs/determinant.h"
#include "parallel_aspects/kinematics/working_mode.h"

#include <array>
#include <cstddef>
#include <optional>
#include <variant>

namespace parallel_aspects {

template <class Scalar, std::size_t N>
using SquareRows = std::array<Row<Scalar, N>, N>;

/// det A of one working mode about one pose, up to positive factors that vanish at serial singularities at
/// most. The local_chart must outlive it.
template <TaskSpace space>
class ModeDeterminant {
 public:
  using Chart = LocalChart<space>;
  static constexpr std::size_t size = Chart::size;

  ModeDeterminant(const Chart& chart, const Manipulator& manipulator) : chart_(chart) {
    // Where c is fixed, u = p - c is the same on every branch.
    for (std::size_t j = 0; j < size; ++j) branches_[j] = manipulator.leg(j).kind().moves_proximal_point;
  }

  void set_mode(const WorkingMode& mode) noexcept { mode_ = mode; }

  /// In floating point; nothing where a leg does not reach.
  std::optional<PointDual<size>> at(const Coordinates<size>& y) const noexcept {
    std::array<PointDual<size>, size> point;
    for (std::size_t i = 0; i < size; ++i) point[i] = PointDual<size>::coordinate(y[i], i);
    std::array<LegRows<PointDual<size>, size>, size> legs;
    chart_.find_rows(point, legs);
    SquareRows<PointDual<size>, size> rows;
    for (std::size_t j = 0; j < size; ++j) {
      if (!(legs[j].squared_entry.value >= 0.0)) return std::nullopt;
      rows[j] = row(j, legs[j], root(legs[j].squared_entry));
    }
    return determinant_of(rows);
  }

  /// The same with |B_jj| of some legs held at `entries`; and B_jj^2 of every leg.
  PointDual<size> at(const Coordinates<size>& y, const std::array<bool, size>& held,
                     const Coordinates<size>& entries,
                     std::array<PointDual<size>, size>& squared) const noexcept {
    std::array<PointDual<size>, size> point;
    for (std::size_t i = 0; i < size; ++i) point[i] = PointDual<size>::coordinate(y[i], i);
    std::array<LegRows<PointDual<size>, size>, size> legs;
    chart_.find_rows(point, legs);
    SquareRows<PointDual<size>, size> rows;
    for (std::size_t j = 0; j < size; ++j) {
      squared[j] = legs[j].squared_entry;
      rows[j] = row(j, legs[j], held[j] ? PointDual<size>(entries[j]) : root(squared[j]));
    }
    return determinant_of(rows);
  }

  /// The sign of det A at every pose of a box, where it and that every leg reaches with B_jj != 0 are proved;
  /// else 0.
  int proved_sign(const std::array<Interval, size>& box) const noexcept {
    std::array<LegRows<Interval, size>, size> legs;
    chart_.find_rows(box, legs);
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
    chart_.find_rows(box, legs);
    for (const auto& leg : legs)
      if (!leg.squared_entry.positive()) return false;
    return true;
  }

  /// det A over the part of a cell in a ball, and B_jj^2 of the legs of which it is not proved there that
  /// they reach.
  struct OverCell {
    Affine<size> determinant;
    std::array<Affine<size>, size> squared_entries;
    std::array<bool, size> unclear{};
    bool any_unclear = false;
  };

  /// Encloses det A over the part of a cell with |y| <= radius where every leg reaches; false where there is
  /// no such part.
  bool over(const Cell<size>& cell, double radius, OverCell& result) const noexcept {
    using Form = std::conditional_t<(size > 2), QuadraticForm<size>, Affine<size>>;
    std::array<LegRows<Form, size>, size> legs;
    chart_.find_rows(reflected(cell.template forms<Form>()), legs);
    SquareRows<Form, size> rows;
    result.any_unclear = false;
    for (std::size_t j = 0; j < size; ++j) {
      const Form& squared = legs[j].squared_entry;
      result.squared_entries[j] = linear(squared);
      const Interval range = range_in_ball(result.squared_entries[j], cell, radius);
      if (range.upper() < 0.0) return false;
      const bool clear = range.lower() > 0.0;
      result.unclear[j] = !clear;
      result.any_unclear = result.any_unclear || !clear;
      rows[j] = row(j, legs[j],
                    clear ? square_root(squared, range.lower()) : root_from_zero(squared, range.upper()));
    }
    result.determinant = linear(determinant_of(rows));
    return true;
  }

  /// The sign of det A wherever |y| <= radius and every leg reaches, where it is proved; else 0.
  int proved_sign_in_ball(double radius) const noexcept {
    const Interval value = in_ball(radius).range();
    return value.positive() ? 1 : value.negative() ? -1 : 0;
  }

  /// Encloses det A wherever |y| <= radius and every leg reaches.
  QuadraticForm<size, FormDomain::ball> in_ball(double radius) const noexcept {
    using Form = QuadraticForm<size, FormDomain::ball>;
    std::array<Form, size> coordinates;
    for (std::size_t i = 0; i < size; ++i) coordinates[i] = Form::coordinate(0.0, radius, i);
    std::array<LegRows<Form, size>, size> legs;
    chart_.find_rows(coordinates, legs);
    SquareRows<Form, size> rows;
    for (std::size_t j = 0; j < size; ++j) {
      const Interval range = legs[j].squared_entry.range();
      rows[j] = row(j, legs[j],
                    range.positive() ? square_root(legs[j].squared_entry, range.lower())
                                     : root_from_zero(legs[j].squared_entry, range.upper()));
    }
    return determinant_of(rows);
  }

  /// Cells are boxes of coordinates whose first axis points to `y`, by a reflection.
  void point_cells_to(const Coordinates<size>& y) noexcept {
    const double length = std::sqrt(dot<size>(y, y));
    reflects_ = length > 0.0;
    if (!reflects_) return;
    Coordinates<size> mirror = y;
    for (double& each : mirror) each /= length;
    mirror[0] += mirror[0] > 0.0 ? 1.0 : -1.0;
    const double squared = dot<size>(mirror, mirror);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < size; ++k)
        reflection_[i][k] = (i == k ? 1.0 : 0.0) - 2.0 * mirror[i] * mirror[k] / squared;
  }

  /// Proved: lengths of points and of their reflections differ by this share at most.
  double reflection_error() const noexcept {
    if (!reflects_) return 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < size; ++k) {
        Interval entry(i == k ? -1.0 : 0.0);
        for (std::size_t a = 0; a < size; ++a)
          entry += Interval(reflection_[a][i]) * Interval(reflection_[a][k]);
        const double most = std::max(-entry.lower(), entry.upper());
        squares += most * most;
      }
    return std::sqrt(squares);
  }

  /// The point with the reflected coordinates `z`, or what encloses it.
  template <class Scalar>
  std::array<Scalar, size> reflected(const std::array<Scalar, size>& z) const noexcept {
    if (!reflects_) return z;
    std::array<Scalar, size> y;
    for (std::size_t i = 0; i < size; ++i) {
      y[i] = Interval(reflection_[i][0]) * z[0];
      for (std::size_t k = 1; k < size; ++k) y[i] = y[i] + Interval(reflection_[i][k]) * z[k];
    }
    return y;
  }
  /// The same in floating point.
  Coordinates<size> reflected_point(const Coordinates<size>& z) const noexcept {
    if (!reflects_) return z;
    Coordinates<size> y{};
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < size; ++k) y[i] += reflection_[i][k] * z[k];
    return y;
  }

 private:
  // sqrt(a) where a is from 0 to `most`: with m = sqrt(most), within m / 8 of a / m + m / 8.
  template <class Form>
  static Form root_from_zero(const Form& a, double most) noexcept {
    const Interval m = square_root(Interval(most));
    if (!m.positive()) return Form(Interval(0.0, m.upper()));
    const Interval slope = reciprocal(m), above = Interval(1.0) - slope * m;
    // sqrt(a) - slope a is at least 0 or `above` m at the ends, and at most 1 / (4 slope) between.
    const double least = std::min(0.0, (above * m).lower());
    return slope * a + Form(Interval(least, (Interval(0.25) * reciprocal(slope)).upper()));
  }

  static const Affine<size>& linear(const Affine<size>& a) noexcept { return a; }
  static Affine<size> linear(const QuadraticForm<size>& a) noexcept { return a.linear(); }

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

  const Chart& chart_;
  bool reflects_ = false;
  SquareRows<double, size> reflection_{};
  std::array<bool, size> branches_{};  // whether the row depends on the sign of B_jj
  WorkingMode mode_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_MODE_DETERMINANT_H
