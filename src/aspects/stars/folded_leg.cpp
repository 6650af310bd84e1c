// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/stars/folded_leg.h"

#include "aspects/boxes/box_intervals.h"
#include "interval/affine.h"
#include "interval/dual.h"
#include "interval/scalar_range.h"
#include "legs/determinant.h"
#include "legs/leg_rows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace parallel_aspects {
namespace {

// Coordinates: the vector d from base point to anchor of the folded leg, the angle t of the platform [half
// turns], and the height h = |B_kk| of the one other leg that is not clear, if there is one.
constexpr std::size_t size = 4, angle = 2, height = 3;
using Form = Affine<size>;
using Slope = Dual<size, Form>;
using Signs = std::array<int, 3>;

constexpr double largest_share = 0.25;  // of the crank, that d may be
constexpr double reserve = 1.5;         // for poses to turn about by more than was guessed
constexpr int directions_tried = 16;

/// Poses around the fold of a leg: d no longer than `radius`, and a range of angles.
struct Cylinder {
  std::size_t leg;
  double radius;
  Interval angles;
};

double length(const Interval& x, const Interval& y) { return square_root(square(x) + square(y)).upper(); }

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

  /// Whether G changes by less than its length as the rod turns, by so much per radian.
  bool is_connected(double turning) const {
    const auto part = [this](std::size_t i) {
      return length(factor_.x.gradient[i].range(), factor_.y.gradient[i].range());
    };
    const Interval by_vector = square_root(square(Interval(part(0))) + square(Interval(part(1))));
    const Interval change =
        Interval(cylinder_.radius) * (by_vector + Interval(part(angle)) * Interval(turning));
    const Interval least = square_root(square(factor_.x.value.range()) + square(factor_.y.value.range()));
    return change.upper() < least.lower();
  }

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
    other.square = rows.squared_entry;
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

SE2Chart::Placement<Interval> placed_at(const ChartBox<SE2Chart>& at, const std::array<Interval, 3>& x) {
  return at.chart.place(at.root, x);
}

bool has_constraints(const ChartBox<SE2Chart>& at, const Signs& signs) {
  const auto placement = placed_at(at, {at.range(0), at.range(1), at.range(2)});
  for (std::size_t j = 0; j < 3; ++j)
    if (at.chart.limits(j, at.chart.displacement(j, placement), Interval(0.0), signs[j]).count > 0)
      return true;
  return !at.tests.none() || at.tests.margins().any();
}

/// The cylinder that holds the box, about the leg that is the nearest to its fold; none where none is near.
std::optional<Cylinder> cylinder_about(const ChartBox<SE2Chart>& at) {
  const auto placement = placed_at(at, {at.range(0), at.range(1), at.range(2)});
  std::optional<Cylinder> best;
  for (std::size_t j = 0; j < 3; ++j) {
    const std::optional<double> crank = at.chart.crank_that_folds(j);
    if (!crank) continue;
    const auto d = at.chart.displacement(j, placement);
    const double radius = length(d.x, d.y);
    if (radius < largest_share * *crank && (!best || radius < best->radius))
      best = Cylinder{j, radius, at.range(angle)};
  }
  return best;
}

/// A pose of the set in the cylinder, the one of those tried with the largest det A.
std::optional<MapPoint> pose_in(const ChartBox<SE2Chart>& at, const Cylinder& cylinder, const Signs& signs,
                                int sign) {
  std::optional<MapPoint> best;
  double largest = 0.0;
  for (const double share : {0.5, 0.05, 0.95})
    for (int i = 0; i < directions_tried && !(best && share != 0.5); ++i) {
      const double turn =
                       cylinder.angles.lower() + share * (cylinder.angles.upper() - cylinder.angles.lower()),
                   direction = 2.0 * M_PI * i / directions_tried;
      const auto d =
          at.chart.displacement(cylinder.leg, placed_at(at, {Interval(0.0), Interval(0.0), Interval(turn)}));
      const MapPoint pose{0.5 * cylinder.radius * std::cos(direction) - middle_of(d.x),
                          0.5 * cylinder.radius * std::sin(direction) - middle_of(d.y), turn};
      const BoxIntervals<SE2Chart> intervals(at.with(Box{3, pose, pose}));
      if (!intervals.state(signs).is_inside(sign)) continue;
      const double determinant = absolute(intervals.determinant(signs)).lower();
      if (!(determinant > largest)) continue;
      largest = determinant;
      best = pose;
    }
  return best;
}

/// Whether all that the set has in the cylinder is connected.
bool is_connected(const ChartBox<SE2Chart>& at, const Box& region, const Signs& signs,
                  const Cylinder& cylinder) {
  const AboutFold here(at, signs, cylinder);
  const std::optional<double> guess = here.turning();
  if (!here.is_simple() || !guess) return false;
  if (*guess == 0.0) return here.lies_in(region) && here.is_connected(0.0);
  Cylinder wide = cylinder;
  const Interval more(4.0 * reserve * *guess * cylinder.radius);
  wide.angles = {(Interval(cylinder.angles.lower()) - more).lower(),
                 (Interval(cylinder.angles.upper()) + more).upper()};
  const AboutFold there(at, signs, wide);
  const std::optional<double> turning = there.turning();
  return there.is_simple() && turning && *turning <= reserve * *guess && there.lies_in(region) &&
         there.is_connected(*turning);
}

}  // namespace

Stars find_stars_about_fold(const ChartBox<SE2Chart>& at, const Box& region, const Signs& signs,
                            int sign) noexcept {
  const std::optional<Cylinder> cylinder = cylinder_about(at);
  if (!cylinder || has_constraints(at, signs) || !is_connected(at, region, signs, *cylinder)) return Stars();
  const std::optional<MapPoint> pose = pose_in(at, *cylinder, signs, sign);
  return pose ? Stars::one(*pose) : Stars();
}

}  // namespace parallel_aspects
