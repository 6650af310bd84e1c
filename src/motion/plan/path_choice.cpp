// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/path_choice.h"

namespace parallel_aspects {
namespace {

constexpr double rounding =
    1e-6;  // of lengths and turns that are summed along a path; angles of small turns are rough

bool look_the_same(const PlannedPath& a, const PlannedPath& b) {
  return a.points.size() == b.points.size() && a.length == b.length && a.turned == b.turned &&
         a.least_index == b.least_index && a.least_det_a == b.least_det_a;
}

}  // namespace

void BestPath::offer(PlannedPath path) {
  if (!path || (best_ && look_the_same(path, best_))) return;
  const Cost its_cost = cost(path);
  if (best_ && !(its_cost < best_cost_)) return;
  best_ = std::move(path);
  best_cost_ = its_cost;
}

BestPath::Cost BestPath::cost(const PlannedPath& path) const {
  const double length = path.length + robot_.characteristic_length() * path.turned;
  switch (wish_.prefer) {
    case PathPreference::shortest:
    case PathPreference::quick:
      return {length, 0.0};
    case PathPreference::clear:
      return {-path.least_index, length};
    case PathPreference::fast:
      break;
  }
  return {wish_.time ? wish_.time(path) : length, length};
}

bool is_straight(const PlannedPath& path) {
  if (!path || !path.crossings.empty()) return false;
  const Pose &from = path.points.front().pose, &to = path.points.back().pose;
  const double shortest = (to.position - from.position).norm(),
               least_turn = from.orientation.angularDistance(to.orientation);
  return path.length <= shortest + rounding * (shortest + from.position.norm()) &&
         path.turned <= least_turn + rounding;
}

std::vector<PathShape> shapes_for(PathPreference preference) {
  switch (preference) {
    case PathPreference::quick:
      return {short_shape};
    case PathPreference::clear:
      return {short_shape, clear_shape};
    case PathPreference::shortest:
    case PathPreference::fast:
      break;
  }
  return {short_shape, {true, 0.0}, {true, 0.5}, clear_shape};
}

}  // namespace parallel_aspects
