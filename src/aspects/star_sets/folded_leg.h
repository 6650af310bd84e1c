// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_STAR_SETS_FOLDED_LEG_H
#define PARALLEL_ASPECTS_ASPECTS_STAR_SETS_FOLDED_LEG_H

#include "aspects/boxes/box_stage.h"
#include "aspects/boxes/charts.h"
#include "aspects/star_sets/star_finder.h"
#include "interval/affine.h"
#include "interval/dual.h"
#include "interval/scalar_range.h"
#include "legs/determinant.h"
#include "legs/leg_rows.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <cstddef>
#include <optional>

// What the proof of docs/theory/maps.md, "Folded legs", asks of the poses about a fold.
namespace parallel_aspects::about_fold {

// Coordinates: the vector d from base point to anchor of the folded leg, the angle t of the platform [half
// turns], and the height h = |B_kk| of the one other leg that is not clear, if there is one.
inline constexpr std::size_t size = 4, angle = 2, height = 3;
using Form = Affine<size>;
using Slope = Dual<size, Form>;
using Signs = std::array<int, 3>;

/// An upper bound.
inline double length(const Interval& x, const Interval& y) {
  return square_root(square(x) + square(y)).upper();
}

/// Poses around the fold of a leg: d no longer than `radius`, and a range of angles.
struct Cylinder {
  std::size_t leg;
  double radius;
  Interval angles;
};

/// B_kk^2 of a leg, and its row of A.
struct OtherLeg {
  Slope square;
  Row<Slope, 3> row;
};

/// All that the proof asks of a cylinder.
class AboutFold {
 public:
  AboutFold(const ChartBox<SE2Chart>& at, const Signs& signs, const Cylinder& cylinder)
      : at_(at), cylinder_(cylinder) {
    const Interval reach(-cylinder.radius, cylinder.radius);
    const Slope turn = coordinate(cylinder.angles, angle);
    const auto centered = chart().displacement(leg(), placed({Slope(0.0), Slope(0.0), turn}));
    const auto arm = chart().anchor(leg(), centered);
    position_ = {coordinate(reach, 0) - centered.x, coordinate(reach, 1) - centered.y};
    const auto placement = placed({position_.x, position_.y, turn});
    for (std::size_t k : {(leg() + 1) % 3, (leg() + 2) % 3}) place(k, signs[k], placement);
    const Row<Slope, 3> minors = cross(others_[(leg() + 1) % 3].row, others_[(leg() + 2) % 3].row);
    // det A = G . u, u being the direction of the rod of the folded leg (see `write_row`).
    factor_ = {minors[1] - arm[1] * minors[0], minors[2] + arm[0] * minors[0]};
  }

  /// Whether no more than one other leg is not clear.
  bool is_simple() const { return unclear_count_ <= 1; }

  bool lies_in(const Box& region) const {
    const auto within = [&region](const Interval& range, std::size_t i) {
      return range.lower() >= region.lower[i] && range.upper() <= region.upper[i];
    };
    return within(position_.x.value.range(), 0) && within(position_.y.value.range(), 1) &&
           within(cylinder_.angles, angle);
  }

  /// How far the platform turns for a displacement of d at constant height, per length; 0 where all other
  /// legs are clear, and none where it is not bounded.
  std::optional<double> turning() const {
    if (unclear_count_ == 0) return 0.0;
    const Slope& square = others_[unclear_].square;
    const Interval by_angle = absolute(square.gradient[angle].range());
    if (!by_angle.positive()) return std::nullopt;
    return (Interval(length(square.gradient[0].range(), square.gradient[1].range())) * reciprocal(by_angle))
        .upper();
  }

  /// By how much G changes at most per radian that the rod turns, at constant |d| and height.
  double change(double turning) const {
    const auto part = [this](std::size_t i) {
      return length(factor_.x.gradient[i].range(), factor_.y.gradient[i].range());
    };
    const Interval by_vector = square_root(square(Interval(part(0))) + square(Interval(part(1))));
    return (Interval(cylinder_.radius) * (by_vector + Interval(part(angle)) * Interval(turning))).upper();
  }

  /// The least length of G.
  double least_length() const {
    return square_root(square(factor_.x.value.range()) + square(factor_.y.value.range())).lower();
  }

  bool is_connected(double turning) const { return change(turning) < least_length(); }

 private:
  const SE2Chart& chart() const { return at_.chart; }
  std::size_t leg() const { return cylinder_.leg; }

  SE2Chart::Placement<Slope> placed(const std::array<Slope, 3>& x) const {
    return chart().place(at_.root, x);
  }

  static Slope coordinate(const Interval& range, std::size_t i) {
    return Slope::coordinate(Form::coordinate(range, i), i);
  }

  void place(std::size_t k, int sign, const SE2Chart::Placement<Slope>& placement) {
    const auto displacement = chart().displacement(k, placement);
    const auto rows = chart().rows(k, chart().form(k, displacement), displacement, placement);
    OtherLeg& other = others_[k];
    other.square = rows.squared_b_entry;
    const Interval square = other.square.value.range();
    if (!square.positive()) {
      unclear_ = k;
      ++unclear_count_;
    }
    const Slope entry = square.positive() ? root(other.square, square.lower())
                                          : coordinate(square_root(not_negative_part(square)), height);
    other.row = branch_rows(rows, entry).of(sign);
  }

  static Slope root(const Slope& square, double least) {
    Slope result(square_root(square.value, least));
    const double smallest = square_root(Interval(least)).lower();
    const Form slope = reciprocal(Interval(2.0) * result.value, 2.0 * smallest);
    for (std::size_t i = 0; i < size; ++i) result.gradient[i] = slope * square.gradient[i];
    return result;
  }

  const ChartBox<SE2Chart>& at_;
  const Cylinder& cylinder_;
  Planar<Slope> position_, factor_;
  std::array<OtherLeg, 3> others_;
  std::size_t unclear_ = 0, unclear_count_ = 0;
};

}  // namespace parallel_aspects::about_fold

namespace parallel_aspects {

/// Of a box near poses in which a leg with crank and rod of one length is folded, its anchor at its base
/// point: proves that all that S(signs, sign) has there is connected, and gives a pose of it. B_jj^2 vanishes
/// there as a sum of two squares, so that no other star does; docs/theory/maps.md, "Folded legs", has the
/// proof. Nothing is known where no leg folds near the box, or where the robot has limits or other
/// constraints there.
Stars find_stars_about_fold(const ChartBox<SE2Chart>& at, const Box& region, const std::array<int, 3>& signs,
                            int sign) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_STAR_SETS_FOLDED_LEG_H
