// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/symmetric_region.h"

#include "aspects/symmetry/robot_symmetry.h"
#include "aspects/tree/exact_corners.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace parallel_aspects {
namespace {

constexpr double most_units_wider = 8.0;

// Twice the middle of the base points: a motion that reverses a coordinate takes the first of them to the
// last.
double twice_the_middle(const Manipulator& manipulator, std::size_t coordinate) {
  const auto i = static_cast<Eigen::Index>(coordinate);
  double first = manipulator.leg(0).base_point()[i], last = first;
  for (const Leg& leg : manipulator.legs()) {
    first = std::min(first, leg.base_point()[i]);
    last = std::max(last, leg.base_point()[i]);
  }
  return first + last;
}

double farthest_of(const Box& box) {
  double farthest = 0.0;
  for (std::size_t i = 0; i < box.dimension; ++i)
    farthest = std::max({farthest, std::abs(box.lower[i]), std::abs(box.upper[i])});
  return farthest;
}

// `box` widened in one coordinate to be its own mirror image, `lower + upper` being `sum` with no rounding.
std::optional<Box> mirrored(Box box, std::size_t i, double sum, double unit) {
  const double half = std::max(box.upper[i] - 0.5 * sum, 0.5 * sum - box.lower[i]);
  const double width = std::ceil(2.0 * half / unit) * unit;
  if (!(width <= box.width(i) + most_units_wider * unit)) return std::nullopt;
  box.lower[i] = 0.5 * (sum - width);
  box.upper[i] = 0.5 * (sum + width);
  if (!is_exact_sum(box.lower[i], box.upper[i], sum) || !has_exact_corners(box.lower[i], box.upper[i]))
    return std::nullopt;
  return box;
}

}  // namespace

Box symmetric_region(const Manipulator& manipulator, const Box& positions, const Box& exact) {
  // Twice as coarse, so that what is added here does not ask for a coarser one.
  const double unit = 2.0 * unit_of_corners(farthest_of(exact));
  Box region = exact;
  for (std::size_t i = 0; i < exact.dimension; ++i) {
    Box widened = exact;
    widened.lower[i] = positions.lower[i];
    widened.upper[i] = positions.upper[i];
    const auto about = mirrored(widened, i, twice_the_middle(manipulator, i), unit);
    if (!about) continue;
    region.lower[i] = about->lower[i];
    region.upper[i] = about->upper[i];
  }
  const auto symmetries = [&manipulator](const Box& of) {
    return find_robot_symmetries(manipulator, of).size();
  };
  return symmetries(region) > symmetries(exact) ? region : exact;
}

}  // namespace parallel_aspects
