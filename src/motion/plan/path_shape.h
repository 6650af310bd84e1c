// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_PATH_SHAPE_H
#define PARALLEL_ASPECTS_MOTION_PLAN_PATH_SHAPE_H

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <functional>
#include <vector>

namespace parallel_aspects {

/// Which path within one aspect is chosen: a short one, or one that keeps away from parallel singularities.
struct PathShape {
  bool is_wide = false;     ///< it is searched along the largest indices; else along the shortest way
  double kept_share = 0.0;  ///< of the least index there, which it keeps when it is shortened

  friend bool operator==(const PathShape& a, const PathShape& b) {
    return a.is_wide == b.is_wide && a.kept_share == b.kept_share;
  }
};

inline constexpr PathShape short_shape{false, 0.0}, clear_shape{true, 1.0};

/// The number of steps of the wanted index: poses in one step count as equally far from singularities, and of
/// those the near ones come first.
inline constexpr double index_steps = 40.0;

/// The share of a segment towards B_jj = 0 that may stay unproved, at its end.
inline constexpr double width_of_turning_points = 1e-9;

/// The segments of one working mode.
struct SegmentsInMode {
  std::function<bool(const Pose&, const Pose&)> is_free;          ///< proved
  std::function<Pose(const Pose&, const Pose&, double)> between;  ///< the pose at t, 0 to 1
  std::function<double(const Pose&, const Pose&)> turn;  ///< the largest angle that it turns by [rad]
  const Manipulator& robot;
  WorkingMode mode;
};

/// How far the platform moves along the path, by `distance_between` [m].
double length_of(const Manipulator& robot, const std::vector<Pose>& path);

/// The parallel index at a pose; 0 where a leg does not reach.
double index_at(const Manipulator& robot, const Pose& pose, const WorkingMode& mode);

/// The least of samples along the path, by which paths are compared: no bound.
double least_index_along(const std::vector<Pose>& path, const SegmentsInMode& segments);

/// Leaves out poses of a path where the segment past them is proved, and pulls what is left towards the
/// straight way as far as that is proved. No sample of the parallel index may fall below `least_index`.
std::vector<Pose> shortened(const std::vector<Pose>& path, const SegmentsInMode& segments,
                            double least_index);

/// The path with poses added such that no segment turns by more than a quarter turn: near half a turn
/// rounding would decide which way round a segment goes, and a reader of the path could take the other way,
/// which is not proved. The shorter segments are proved anew, and divided further where one of them is
/// not; empty where that does not help.
std::vector<Pose> with_short_turns(const std::vector<Pose>& path, const SegmentsInMode& segments);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_PATH_SHAPE_H
