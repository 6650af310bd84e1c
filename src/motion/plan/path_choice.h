// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_PATH_CHOICE_H
#define PARALLEL_ASPECTS_MOTION_PLAN_PATH_CHOICE_H

#include "motion/plan/path_shape.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/motion/plan_path.h"

#include <utility>
#include <vector>

namespace parallel_aspects {

/// Keeps the path that is preferred of those that are offered.
class BestPath {
 public:
  /// Both outlive it.
  BestPath(const Manipulator& robot, const PathWish& wish) : robot_(robot), wish_(wish) {}

  /// Of another path than one that is found nothing is kept.
  void offer(PlannedPath path);

  bool has_path() const noexcept { return static_cast<bool>(best_); }

  /// The best, which leaves this empty.
  PlannedPath take() { return std::exchange(best_, {}); }

 private:
  using Cost = std::pair<double, double>;  // the latter where the former is equal

  Cost cost(const PlannedPath& path) const;

  const Manipulator& robot_;
  const PathWish& wish_;
  PlannedPath best_;
  Cost best_cost_;
};

/// Whether no path is shorter.
bool is_straight(const PlannedPath& path);

/// Shapes of paths of which one may be what is preferred; the shortest first.
std::vector<PathShape> shapes_for(PathPreference preference);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_PATH_CHOICE_H
