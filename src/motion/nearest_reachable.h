// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_NEAREST_REACHABLE_H
#define PARALLEL_ASPECTS_MOTION_NEAREST_REACHABLE_H

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// A pose that every leg reaches in one working mode, within the limits of its actuated joint.
struct ReachedPose {
  Pose pose;      ///< in the task frame
  JointVector q;  ///< there [rad or m]
  /// From the pose that was wanted: root mean square displacement of the anchors [m]; 0 where that is
  /// reached.
  double distance = 0.0;
};

/// Looks for the reachable pose of a working mode that is nearest to one that may be out of reach.
/// Constraints besides reach and joint limits are not examined.
///
/// Floating point, not proved: several descents, each from a pose in reach to a local minimum of the
/// distance, each of whose poses is in reach. Asked again and again, as while a pose is dragged, it goes on
/// from the last answer. Allocates; one object for each thread.
class NearestReachable {
 public:
  explicit NearestReachable(std::shared_ptr<const Manipulator> manipulator);

  /// Nothing where no pose of the working mode was found. `last`: the last answer, or any pose to start from.
  std::optional<ReachedPose> find(const Pose& wanted, const WorkingMode& mode,
                                  const std::optional<Pose>& last = std::nullopt);

 private:
  std::vector<Pose> starts(const Pose& wanted, const WorkingMode& mode, const std::optional<Pose>& last);
  void sample(const WorkingMode& mode);

  std::shared_ptr<const Manipulator> manipulator_;
  std::optional<WorkingMode> sampled_;  // whose samples these are
  std::vector<Pose> samples_;           // in reach
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_NEAREST_REACHABLE_H
