// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_PATH_BUILDER_H
#define PARALLEL_ASPECTS_MOTION_PLAN_PATH_BUILDER_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/vectors.h"
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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_PATH_BUILDER_H
