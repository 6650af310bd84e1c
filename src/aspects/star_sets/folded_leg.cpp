// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/star_sets/folded_leg.h"

#include "aspects/boxes/box_intervals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace parallel_aspects {
namespace {

using about_fold::AboutFold;
using about_fold::angle;
using about_fold::Cylinder;
using about_fold::Signs;

constexpr double largest_share = 0.25;  // of the crank, that d may be
constexpr double reserve = 1.5;         // for poses to turn about by more than was guessed
constexpr int directions_tried = 16;

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
    const double radius = about_fold::length(d.x, d.y);
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
