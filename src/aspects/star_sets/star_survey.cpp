// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/star_sets/star_survey.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

using Direction = std::array<double, max_map_dimension + 1>;
constexpr std::size_t value_at_center = max_map_dimension;
constexpr std::size_t sides = 2 * max_map_dimension;
constexpr int max_steps = 200;
constexpr double good_enough = 0.8;  // of the margin that is proved to be the most

double dot(const Direction& a, const Direction& b) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// A point x is taken for its direction (x, 1), a function for (slope, value at 0) scaled to length 1. The
/// direction with the largest margin to all functions leads to the point of their convex hull that is nearest
/// to the origin, which Gilbert's algorithm finds (SIAM J. Control 4, 1966).
class NearestPoint {
 public:
  explicit NearestPoint(const LinearFunctions& functions) noexcept : functions_(functions.count) {
    for (std::size_t i = 0; i < functions.count; ++i) add(functions.items[i]);
    // 1 - x and 1 + x of each coordinate.
    for (std::size_t i = 0; i < max_map_dimension; ++i)
      for (const double side : {-1.0, 1.0}) {
        LinearFunction within{1.0, {}};
        within.slope[i] = side;
        add(within);
      }
    weights_.fill(1.0 / static_cast<double>(count_));
    for (std::size_t i = 0; i < count_; ++i) move(nearest_, rows_[i], 1.0 / static_cast<double>(i + 1));
  }

  CommonPoint run() noexcept {
    CommonPoint result;
    for (int step = 0; step < max_steps; ++step) {
      const std::size_t worst = lowest();
      const double reached = dot(rows_[worst], nearest_);
      result.found = reached > 0.0;
      if (reached >= good_enough * dot(nearest_, nearest_)) break;
      approach(worst);
    }
    for (std::size_t i = 0; result.found && i < max_map_dimension; ++i)
      result.point[i] = nearest_[i] / nearest_[value_at_center];
    for (std::size_t i = 0; i < functions_; ++i) result.weights[i] = weights_[i] / lengths_[i];
    return result;
  }

 private:
  void add(const LinearFunction& function) noexcept {
    Direction row{};
    std::copy(function.slope.begin(), function.slope.end(), row.begin());
    row[value_at_center] = function.at_center;
    const double length = std::sqrt(dot(row, row));
    lengths_[count_] = length > 0.0 ? length : 1.0;
    for (double& each : row) each /= lengths_[count_];
    rows_[count_++] = row;
  }

  static void move(Direction& from, const Direction& to, double share) noexcept {
    for (std::size_t i = 0; i < from.size(); ++i) from[i] += share * (to[i] - from[i]);
  }

  std::size_t lowest() const noexcept {
    std::size_t best = 0;
    for (std::size_t i = 1; i < count_; ++i)
      if (dot(rows_[i], nearest_) < dot(rows_[best], nearest_)) best = i;
    return best;
  }

  /// Moves toward a row as far as this leads nearer to the origin.
  void approach(std::size_t i) noexcept {
    Direction step = rows_[i];
    for (std::size_t k = 0; k < step.size(); ++k) step[k] -= nearest_[k];
    const double squared = dot(step, step);
    const double share = squared > 0.0 ? std::clamp(-dot(nearest_, step) / squared, 0.0, 1.0) : 0.0;
    move(nearest_, rows_[i], share);
    for (std::size_t k = 0; k < count_; ++k) weights_[k] *= 1.0 - share;
    weights_[i] += share;
  }

  std::array<Direction, LinearFunctions::most + sides> rows_;
  std::array<double, LinearFunctions::most + sides> lengths_, weights_;
  std::size_t functions_, count_ = 0;
  Direction nearest_{};
};

}  // namespace

CommonPoint find_common_point(const LinearFunctions& functions) noexcept {
  return NearestPoint(functions).run();
}

}  // namespace parallel_aspects
