// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/cusp_tube.h"

#include "interval/half_turns.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

// From the middle of a box along a coordinate, times pi.
Interval offset_of(const Box& box, std::size_t axis) noexcept {
  const double middle = box.center(axis);
  const double half = std::max(box.upper[axis] - middle, middle - box.lower[axis]);
  return pi_enclosure() * Interval(-half, half);
}

}  // namespace

Interval held_values(const Box& box) noexcept {
  return pi_enclosure() * Interval(box.lower[2], box.upper[2]);
}

bool SliceFamily::may_hold_cusp(const Box& box) noexcept {
  ++evaluations_;
  slice_.hold(held_values(box));
  const SlicePlace place = slice_.place(box);
  if (slice_.within_limits(posture_, place) == Verdict::fails) return false;
  const auto legs = legs_over(slice_, posture_, place);
  if (!legs) return true;
  if (is_out_of_reach(*legs)) return false;
  const CuspFunctions<1> over(*legs, place.over());
  if (!over.may_have_cusp()) return false;
  if (!are_regular(*legs)) return true;
  const TotalGradients<3> slopes(*legs, over, place.over());
  const auto center = at(box.middle());
  if (!center) return true;
  const std::array<const CuspGradient<3>*, 3> gradients{&slopes.d, &slopes.along_kernel[0],
                                                        &slopes.along_kernel[1]};
  for (std::size_t n = 0; n < 3; ++n) {
    Interval value = center->values[n];
    for (std::size_t k = 0; k < 3; ++k) value += (*gradients[n])[k] * offset_of(box, k);
    if (!may_vanish(value)) return false;
  }
  return true;
}

Verdict SliceFamily::within_limits(const Box& box) noexcept {
  slice_.hold(held_values(box));
  return slice_.within_limits(posture_, slice_.place(box));
}

int SliceFamily::held_sign(const Box& box) noexcept {
  slice_.hold(held_values(box));
  return slice_.held_sign(slice_.place(box));
}

std::optional<FamilyFunctions> SliceFamily::over(const Box& box) noexcept {
  slice_.hold(held_values(box));
  return functions(slice_.place(box));
}

std::optional<FamilyFunctions> SliceFamily::at(const MapPoint& point) noexcept {
  slice_.hold(pi_enclosure() * Interval(point[2]));
  return functions(SlicePlace(std::array<double, 2>{point[0], point[1]}));
}

std::optional<FamilyFunctions> SliceFamily::functions(const SlicePlace& at) noexcept {
  ++evaluations_;
  const auto legs = legs_over(slice_, posture_, at);
  if (!legs || !are_regular(*legs)) return std::nullopt;
  const CuspFunctions<1> over(*legs, at.over());
  const TotalGradients<3> slopes(*legs, over, at.over());
  FamilyFunctions result;
  result.values = {over.d.value(), over.along_kernel[0].value(), over.along_kernel[1].value()};
  result.gradients = {slopes.d, slopes.along_kernel[0], slopes.along_kernel[1]};
  for (std::size_t i = 0; i < 2; ++i)
    result.has_gradient[i] = may_vanish(over.g[i].at(1, 0)) ? !may_vanish(over.g[i].at(0, 1)) : true;
  result.better_equation = over.better_equation();
  return result;
}

namespace {

// Half widths of boxes about a point: that are tried, and at least.
constexpr std::array<double, 3> point_half_widths{0x1p-40, 0x1p-34, 0x1p-28};

// Half widths of tubes over half their length. Wide ones are tried first: they leave less to be excluded.
constexpr std::array<double, 3> wide_tubes{0.3, 0.1, 0.02};

constexpr int newton_steps = 8, widenings = 6;

// Where a cross section was too narrow for Krawczyk's test, the next holds what the test enclosed, and half
// as much again, since it must lie inside (epsilon inflation: S. M. Rump, Verification methods, Acta Numerica
// 19, 2010). One of 45 degrees to either side holds too much of the torus for one zero: a shorter tube is
// tried.
constexpr double more_than_enclosed = 1.5, widest_half = 0.25;

std::array<std::size_t, 2> others_of(std::size_t axis) noexcept {
  return {axis == 0 ? std::size_t{1} : std::size_t{0}, axis == 2 ? std::size_t{1} : std::size_t{2}};
}

Box cross_about(const CuspTube& tube, const MapPoint& at, const std::array<double, 2>& half) noexcept {
  Box cross{2, {}, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    cross.lower[i] = at[tube.others[i]] - half[i];
    cross.upper[i] = at[tube.others[i]] + half[i];
  }
  return cross;
}

MapPoint middle_of(const CuspTube& tube) noexcept {
  MapPoint at{};
  at[tube.axis] = tube.middle;
  for (std::size_t i = 0; i < 2; ++i) at[tube.others[i]] = tube.cross.center(i);
  return at;
}

/// Row 0 is that of D, row 1 that of the better equation.
std::array<const CuspGradient<3>*, 2> rows_of(const FamilyFunctions& functions, std::size_t equation) {
  return {&functions.gradients[0], &functions.gradients[1 + equation]};
}

/// x - slope s over the box, of coordinate i of the others.
Interval straightened(const CuspTube& tube, const Box& box, std::size_t i) noexcept {
  const Interval s = Interval(box.lower[tube.axis], box.upper[tube.axis]) - Interval(tube.middle);
  return Interval(box.lower[tube.others[i]], box.upper[tube.others[i]]) - Interval(tube.slope[i]) * s;
}

double distance_along(const CuspTube& tube, const Box& box) noexcept {
  return std::max((Interval(box.upper[tube.axis]) - Interval(tube.middle)).upper(),
                  (Interval(tube.middle) - Interval(box.lower[tube.axis])).upper());
}

/// How all functions of the pair move along the tube, other than across it: a bound of this times half.
std::array<Interval, 2> drift_of(const CuspTube& tube, const FamilyFunctions& over) noexcept {
  std::array<Interval, 2> drift;
  const auto rows = rows_of(over, over.better_equation);
  const Interval half = pi_enclosure() * Interval(tube.half);
  for (std::size_t n = 0; n < 2; ++n) {
    Interval slope = (*rows[n])[tube.axis];
    for (std::size_t i = 0; i < 2; ++i) slope += (*rows[n])[tube.others[i]] * Interval(tube.slope[i]);
    drift[n] = Interval(absolute(slope).upper()) * half;
  }
  return drift;
}

std::array<double, 2> slope_of(const CuspTube& tube, const MapPoint& tangent) noexcept {
  return {tangent[tube.others[0]] / tangent[tube.axis], tangent[tube.others[1]] / tangent[tube.axis]};
}

bool are_finite(const std::array<double, 2>& pair) noexcept {
  return std::isfinite(pair[0]) && std::isfinite(pair[1]);
}

}  // namespace

Box hull_of(const CuspTube& tube, const Box& cross) noexcept {
  Box hull{3, {}, {}};
  hull.lower[tube.axis] = (Interval(tube.middle) - Interval(tube.half)).lower();
  hull.upper[tube.axis] = tube.middle + tube.half;
  for (std::size_t i = 0; i < 2; ++i) {
    const Interval along = Interval(tube.slope[i]) * Interval(-tube.half, tube.half);
    const Interval range = Interval(cross.lower[i], cross.upper[i]) + along;
    hull.lower[tube.others[i]] = range.lower();
    hull.upper[tube.others[i]] = range.upper();
  }
  return hull;
}

Interval along(const CuspTube& tube, const Box& box) noexcept {
  const Box moved = beside(middle_of(tube), box);
  return {moved.lower[tube.axis], moved.upper[tube.axis]};
}

bool contains(const CuspTube& tube, const Box& box) noexcept {
  const Box moved = beside(middle_of(tube), box);
  if (distance_along(tube, moved) > tube.half) return false;
  for (std::size_t i = 0; i < 2; ++i) {
    const Interval range = straightened(tube, moved, i);
    if (!(tube.cross.lower[i] <= range.lower() && range.upper() <= tube.cross.upper[i])) return false;
  }
  return true;
}

bool may_meet(const CuspTube& tube, const Box& box) noexcept {
  const Box moved = beside(middle_of(tube), box);
  const Interval s = Interval(moved.lower[tube.axis], moved.upper[tube.axis]) - Interval(tube.middle);
  if (s.lower() > tube.half || s.upper() < -tube.half) return false;
  for (std::size_t i = 0; i < 2; ++i) {
    const Interval range = straightened(tube, moved, i);
    if (tube.cross.lower[i] > range.upper() || range.lower() > tube.cross.upper[i]) return false;
  }
  return true;
}

Zeros test_tube(SliceFamily& family, CuspTube& tube) noexcept {
  const auto center = family.at(middle_of(tube));
  auto over = family.over(hull_of(tube, tube.cross));
  tube.enclosed = tube.cross;
  if (!center || !over) return Zeros::unknown;
  over->better_equation = center->better_equation;
  const auto rows = rows_of(*over, center->better_equation);
  PairOverBox pair{{center->values[0], center->values[1 + center->better_equation]}, {}, {}};
  for (std::size_t n = 0; n < 2; ++n)
    for (std::size_t i = 0; i < 2; ++i) pair.jacobian[n][i] = (*rows[n])[tube.others[i]];
  pair.drift = drift_of(tube, *over);
  const ZeroSearch found = krawczyk_test(tube.cross, pair);
  tube.enclosed = found.enclosure;
  if (found.zeros != Zeros::one) return found.zeros;
  return over->has_gradient[center->better_equation] ? Zeros::one : Zeros::unknown;
}

std::optional<CuspTube> tube_about(SliceFamily& family, std::size_t axis, const MapPoint& at,
                                   double half) noexcept {
  CuspTube tube;
  tube.axis = axis;
  tube.others = others_of(axis);
  tube.middle = at[axis];
  tube.half = half;
  const auto tangent = tangent_at(family, at);
  if (!tangent) return std::nullopt;
  tube.slope = slope_of(tube, *tangent);
  if (!are_finite(tube.slope)) return std::nullopt;
  for (const double share : wide_tubes) {
    tube.cross = cross_about(tube, at, {share * half, share * half});
    if (test_tube(family, tube) == Zeros::one) return tube;
  }
  const double narrow = wide_tubes.back() * half + point_half_widths[0];
  std::array<double, 2> width{narrow, narrow};
  for (int n = 0; n < widenings; ++n) {
    tube.cross = cross_about(tube, at, width);
    if (test_tube(family, tube) == Zeros::one) return tube;
    for (std::size_t i = 0; i < 2; ++i) {
      const double middle = tube.cross.center(i);
      const double needed = std::max(tube.enclosed.upper[i] - middle, middle - tube.enclosed.lower[i]);
      if (!(needed < widest_half)) return std::nullopt;
      width[i] = std::max(width[i], more_than_enclosed * needed);
    }
  }
  return std::nullopt;
}

std::optional<CuspTube> tube_over(SliceFamily& family, const Box& box, const MapPoint& weights) noexcept {
  const MapPoint at = box.middle();
  const auto tangent = tangent_at(family, at);
  if (!tangent) return std::nullopt;
  CuspTube tube;
  tube.axis = steepest_axis(*tangent, weights);
  tube.others = others_of(tube.axis);
  tube.middle = at[tube.axis];
  tube.half = std::max(box.upper[tube.axis] - tube.middle, tube.middle - box.lower[tube.axis]);
  tube.slope = slope_of(tube, *tangent);
  if (!are_finite(tube.slope)) return std::nullopt;
  tube.cross = Box{2, {}, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    const Interval range = straightened(tube, box, i);
    tube.cross.lower[i] = range.lower();
    tube.cross.upper[i] = range.upper();
  }
  return tube;
}

std::optional<MapPoint> near_cusp(SliceFamily& family, std::size_t axis, MapPoint at) noexcept {
  const std::array<std::size_t, 2> others = others_of(axis);
  for (int step = 0; step < newton_steps; ++step) {
    const auto found = family.at(at);
    if (!found) return std::nullopt;
    const auto rows = rows_of(*found, found->better_equation);
    const auto entry = [&](std::size_t n, std::size_t i) { return middle_of((*rows[n])[others[i]]); };
    const double f = middle_of(found->values[0]), k = middle_of(found->values[1 + found->better_equation]);
    const double determinant = entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0);
    const double first = (entry(1, 1) * f - entry(0, 1) * k) / (pi_enclosure().upper() * determinant);
    const double second = (entry(0, 0) * k - entry(1, 0) * f) / (pi_enclosure().upper() * determinant);
    if (!(std::abs(first) < 0.1) || !(std::abs(second) < 0.5)) return std::nullopt;
    at[others[0]] -= first;
    at[others[1]] -= second;
    for (std::size_t i = 0; i < 2; ++i)
      if (!(std::abs(at[i]) < 1.4)) return std::nullopt;
    if (std::max(std::abs(first), std::abs(second)) < 1e-15) break;
  }
  return at;
}

std::optional<Box> cusp_near(SliceFamily& family, std::size_t axis, const MapPoint& at) noexcept {
  const auto point = near_cusp(family, axis, at);
  if (!point) return std::nullopt;
  CuspTube tube;
  tube.axis = axis;
  tube.others = others_of(axis);
  tube.middle = (*point)[axis];
  for (const double half : point_half_widths) {
    tube.cross = cross_about(tube, *point, {half, half});
    if (test_tube(family, tube) == Zeros::one) return hull_of(tube, intersection(tube.cross, tube.enclosed));
  }
  return std::nullopt;
}

std::optional<MapPoint> tangent_at(SliceFamily& family, const MapPoint& at) noexcept {
  const auto found = family.at(at);
  if (!found) return std::nullopt;
  const auto rows = rows_of(*found, found->better_equation);
  std::array<MapPoint, 2> row;
  for (std::size_t n = 0; n < 2; ++n)
    for (std::size_t i = 0; i < 3; ++i) row[n][i] = middle_of((*rows[n])[i]);
  MapPoint tangent;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    tangent[i] = row[0][j] * row[1][k] - row[0][k] * row[1][j];
  }
  return tangent;
}

std::size_t steepest_axis(const MapPoint& tangent, const MapPoint& weights) noexcept {
  std::size_t best = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (weights[i] * std::abs(tangent[i]) > weights[best] * std::abs(tangent[best])) best = i;
  return best;
}

// Of F_p + F_j x_j' + F_h h' = 0, by Cramer's rule.
int held_direction(SliceFamily& family, const CuspTube& tube) noexcept {
  if (tube.axis == 2) return 1;
  const auto over = family.over(hull_of(tube, intersection(tube.cross, tube.enclosed)));
  if (!over) return 0;
  const auto rows = rows_of(*over, over->better_equation);
  const auto minor = [&](std::size_t i, std::size_t k) {
    return (*rows[0])[i] * (*rows[1])[k] - (*rows[0])[k] * (*rows[1])[i];
  };
  const std::size_t angle = tube.others[0];
  const Interval numerator = -minor(angle, tube.axis), denominator = minor(angle, 2);
  if (may_vanish(numerator) || may_vanish(denominator)) return 0;
  return numerator.positive() == denominator.positive() ? 1 : -1;
}

}  // namespace parallel_aspects
