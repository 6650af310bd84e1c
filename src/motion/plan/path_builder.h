// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_PATH_BUILDER_H
#define PARALLEL_ASPECTS_MOTION_PLAN_PATH_BUILDER_H

#include "motion/plan/path_shape.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/motion/plan_path.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Why there is no path, or none that is known.
PlannedPath without_path(SameAspect answer, std::string message);

/// Whether position and orientation are numbers.
inline bool is_finite(const Pose& pose) {
  return pose.position.allFinite() && pose.orientation.coeffs().allFinite();
}

/// The path between poses in one working mode, and in another behind a crossing.
class PathBuilder {
 public:
  /// `between(from, to, t)` is the pose on a segment.
  using Between = std::function<Pose(const Pose&, const Pose&, double)>;

  /// The manipulator outlives it.
  PathBuilder(const Manipulator& manipulator, Between between)
      : robot_(manipulator), between_(std::move(between)) {}

  void go(const std::vector<Pose>& poses, const WorkingMode& mode);

  /// Between the last point and the next one, in the other working mode.
  void cross_serial(std::size_t leg, int from, int to);

  /// From the last point through these.
  void cross_parallel(const std::vector<Pose>& poses, const WorkingMode& mode, int from, int to);

  /// The path, which leaves this empty.
  PlannedPath take(std::string message);

 private:
  void add(const Pose& pose, const WorkingMode& mode);
  void look_at(const Pose& pose, const JointVector& q);

  const Manipulator& robot_;
  Between between_;
  PlannedPath path_;
};

/// The path with whole turns added to angles without limits, the same at all of its points, so that it begins
/// next to these values of the actuated joints; as it is where there are none.
PlannedPath begun_at(const std::optional<JointVector>& q, const Manipulator& manipulator, PlannedPath path);

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

/// Shapes of paths of which one may be what is preferred; the shortest first. All preferences but `quick`
/// choose among the same, so that of two answers each is the better one by its own measure.
std::vector<PathShape> shapes_for(PathPreference preference);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_PATH_BUILDER_H
