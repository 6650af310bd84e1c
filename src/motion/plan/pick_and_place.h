// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_PICK_AND_PLACE_H
#define PARALLEL_ASPECTS_MOTION_PLAN_PICK_AND_PLACE_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/motion/plan_path.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Appends corners of the actuated joints [rad or m] such that straight motions of these between corners take
/// the platform along the poses of a planned path, from one corner to the next with det A away from zero,
/// certified by continuation; serial singularities are passed in one motion. The first corner is left out
/// where there are corners already, of which the last is at the start of the path. False where something is
/// not certified; then `corners` is of no use.
bool append_joint_corners(const PathPlanner& planner, const Manipulator& manipulator, const PlannedPath& path,
                          std::vector<JointVector>& corners);

/// A task that one aspect cannot do: something is picked up in the aspect of the start, and placed where that
/// aspect does not hold the platform, which is proved. So the robot changes its working mode on its path.
struct PickAndPlace {
  Pose pick, place;
  PlannedPath carry;  ///< from the one to the other, in the working mode of the start there

  /// Corners of a round from the start over pick and place back to the start; actuated joints move straight
  /// between [rad or m], which is certified by continuation.
  std::vector<JointVector> joint_values;

  std::string reason;  ///< which aspect cannot do it and through which gates it goes; or why there is none

  explicit operator bool() const noexcept { return !joint_values.empty(); }
};

/// Whether a round along these corners is accepted, for instance since a tracker follows it.
using AcceptsRound = std::function<bool(const std::vector<JointVector>& corners)>;

/// Plans one with proved paths from a pose in a working mode: of those that are accepted, the one that stays
/// farthest from parallel singularities. There is none where no serial gate leaves the aspect of the start,
/// and where there are constraints besides limits of actuated joints, which straight motions of actuated
/// joints are not proved to keep. Takes up to some seconds, with the gates of the map.
PickAndPlace plan_pick_and_place(const std::shared_ptr<const AspectMap>& map, const Pose& start,
                                 const WorkingMode& mode, const AcceptsRound& accepts,
                                 const MapControl& control = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_PICK_AND_PLACE_H
