// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_MODE_DETERMINANT_H
#define PARALLEL_ASPECTS_DISTANCE_MODE_DETERMINANT_H

#include "distance/cell.h"
#include "distance/cubic_form.h"
#include "distance/local_chart.h"
#include "distance/quadratic_form.h"
#include "distance/regular_ball.h"
#include "legs/determinant.h"
#include "parallel_aspects/kinematics/kinematics.h"

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
      if (!(legs[j].squared_b_entry.value >= 0.0)) return std::nullopt;
      rows[j] = row(j, legs[j], root(legs[j].squared_b_entry));
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
      squared[j] = legs[j].squared_b_entry;
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
      if (!legs[j].squared_b_entry.positive()) return 0;
      rows[j] = row(j, legs[j], root(legs[j].squared_b_entry));
    }
    const Interval value = determinant_of(rows);
    return value.positive() ? 1 : value.negative() ? -1 : 0;
  }

  /// Whether every leg is proved to reach with B_jj != 0 in a box.
  bool is_reached(const std::array<Interval, size>& box) const noexcept { return !unproved_leg(box); }

  /// The first leg that is not proved to reach with B_jj != 0 in a box.
  std::optional<std::size_t> unproved_leg(const std::array<Interval, size>& box) const noexcept {
    std::array<LegRows<Interval, size>, size> legs;
    chart_.find_rows(box, legs);
    for (std::size_t j = 0; j < size; ++j)
      if (!legs[j].squared_b_entry.positive()) return j;
    return std::nullopt;
  }

  /// det A over the part of a cell in a ball, and B_jj^2 of the legs of which it is not proved there that
  /// they reach.
  struct OverCell {
    Affine<size> determinant;
    std::array<Affine<size>, size> squared_entries;
    std::array<bool, size> unclear{};
    bool any_unclear = false;
    std::array<bool, size> bends{};  ///< legs whose |B_jj| is far from linear: unclear, or small somewhere

    /// Where a single leg bends, det A = F + s |B_jj| G with the sign s of its branch. Then
    /// F^2 - G^2 B_jj^2 vanishes wherever det A does, and has no root that bends; nor does det A vanish where
    /// s F G > 0.
    bool has_norm = false;
    Affine<size> norm, same_sense;

    /// Whether it is proved in this way that det A vanishes nowhere in the cell as far as |y| <= radius.
    bool is_free_by_norm(const Cell<size>& cell, double radius) const noexcept {
      if (!has_norm) return false;
      const Interval range = range_in_ball(norm, cell, radius);
      return range.positive() || range.negative() || range_in_ball(same_sense, cell, radius).positive();
    }

    /// Whether value > 0 follows in the cell, as far as |y| <= radius, from every leg reaching: from
    /// value - factor B_jj^2 > 0 for some factors >= 0.
    bool is_positive_where_reached(const Affine<size>& value, const Cell<size>& cell,
                                   double radius) const noexcept {
      if (!any_unclear) return false;
      Affine<size> rest = value;
      for (std::size_t j = 0; j < size; ++j) {
        if (!unclear[j]) continue;
        const Affine<size>& squared = squared_entries[j];
        double along = 0.0, length = 0.0;
        for (std::size_t i = 0; i < size; ++i) {
          const double width = cell.half_width[i] * cell.half_width[i];
          along += rest.slope(i) * squared.slope(i) / width;
          length += squared.slope(i) * squared.slope(i) / width;
        }
        if (along > 0.0 && length > 0.0) rest = rest - Interval(along / length) * squared;
      }
      return range_in_ball(rest, cell, radius).lower() > 0.0;
    }
  };

  using CellForm = std::conditional_t<(size > 2), QuadraticForm<size>, Affine<size>>;

  /// The legs over a cell, for every working mode.
  struct LegsOverCell {
    std::array<LegRows<CellForm, size>, size> rows;
    std::array<CellForm, size> entries;  // |B_jj|
  };

  /// Encloses the legs over the part of a cell with |y| <= radius where every leg reaches, `y` being its
  /// points; false where there is no such part.
  bool find_legs(const std::array<CellForm, size>& y, const Cell<size>& cell, double radius,
                 LegsOverCell& legs, OverCell& result) const noexcept {
    chart_.find_rows(y, legs.rows);
    result.any_unclear = false;
    for (std::size_t j = 0; j < size; ++j) {
      const CellForm& squared = legs.rows[j].squared_b_entry;
      result.squared_entries[j] = linear(squared);
      const Interval range = range_in_ball(result.squared_entries[j], cell, radius);
      if (range.upper() < 0.0) return false;
      const bool clear = range.lower() > 0.0;
      result.unclear[j] = !clear;
      result.any_unclear = result.any_unclear || !clear;
      result.bends[j] = !clear || range.lower() < least_share * range.upper();
      legs.entries[j] = result.bends[j] ? root_between(squared, std::max(0.0, range.lower()), range.upper())
                                        : square_root(squared, range.lower());
    }
    return true;
  }

  /// Encloses det A there, and what `result` has beside.
  void find_determinant(const LegsOverCell& legs, OverCell& result) const noexcept {
    SquareRows<CellForm, size> rows;
    std::size_t bent_legs = 0, last = 0;
    for (std::size_t j = 0; j < size; ++j) {
      rows[j] = row(j, legs.rows[j], legs.entries[j]);
      if (!result.bends[j]) continue;
      ++bent_legs;
      last = j;
    }
    result.has_norm = bent_legs == 1 && branches_[last];
    if (!result.has_norm) {
      result.determinant = linear(determinant_of(rows));
      return;
    }
    rows[last] = legs.rows[last].fixed;
    const CellForm f = determinant_of(rows);
    rows[last] = legs.rows[last].turned;
    const CellForm g = mode_.sign(last) > 0 ? determinant_of(rows) : -determinant_of(rows);
    result.determinant = linear(f + legs.entries[last] * g);
    result.norm = linear(square(f) - square(g) * legs.rows[last].squared_b_entry);
    result.same_sense = linear(f * g);
  }

  /// Encloses det A over the part of a cell with |y| <= radius where every leg reaches; false where there is
  /// no such part.
  bool over(const Cell<size>& cell, double radius, OverCell& result) const noexcept {
    LegsOverCell legs;
    if (!find_legs(reflected(cell.template forms<CellForm>()), cell, radius, legs, result)) return false;
    find_determinant(legs, result);
    return true;
  }

  using BallForm = QuadraticForm<size, FormDomain::ball>;

  /// Encloses det A wherever |y| <= radius and every leg reaches.
  BallForm in_ball(double radius) const noexcept { return determinant_of(rows_in_ball(radius)); }

  struct RegularRadius {
    double proved;  ///< up to that of the ball: A is regular within it wherever every leg reaches; 0 for none
    double expected;  ///< of a ball that is expected to be proved as a whole
  };
  /// From an enclosure over the ball |y| <= radius.
  RegularRadius regular_radius(double radius) const noexcept {
    static_assert(size == 6);
    using Form = CubicForm<size>;
    std::array<LegRows<Form, size>, size> legs;
    chart_.find_rows(ball<Form>(radius), legs);
    RowsInBall rows;
    for (std::size_t j = 0; j < size; ++j) {
      rows.along[j] = legs[j].turned;
      rows.rows[j] = legs[j].fixed;
      if (!branches_[j]) continue;
      const RootInBall<Form> entry(legs[j].squared_b_entry);
      rows.rows[j] = row(j, legs[j], entry.middle);
      rows.gaps[j] = entry.gap;
    }
    const RegularBall regular(rows);
    return {-(-regular.proved_share() * radius), regular.expected_share() * radius};
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
  template <class Form>
  static std::array<Form, size> ball(double radius) noexcept {
    std::array<Form, size> coordinates;
    for (std::size_t i = 0; i < size; ++i) coordinates[i] = Form::coordinate(0.0, radius, i);
    return coordinates;
  }

  // Of A, wherever |y| <= radius and every leg reaches.
  SquareRows<BallForm, size> rows_in_ball(double radius) const noexcept {
    std::array<LegRows<BallForm, size>, size> legs;
    chart_.find_rows(ball<BallForm>(radius), legs);
    SquareRows<BallForm, size> rows;
    for (std::size_t j = 0; j < size; ++j) {
      const Interval range = legs[j].squared_b_entry.range();
      rows[j] = row(j, legs[j],
                    range.positive() ? square_root(legs[j].squared_b_entry, range.lower())
                                     : root_between(legs[j].squared_b_entry, 0.0, range.upper()));
    }
    return rows;
  }

  // Below this share of the largest B_jj^2 in a cell, |B_jj| is enclosed by a chord.
  static constexpr double least_share = 0.15;

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
