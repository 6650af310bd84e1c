// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PLAN_CUSP_QUESTION_H
#define PARALLEL_ASPECTS_ROS_PLAN_CUSP_QUESTION_H

#include "parallel_aspects/aspects/map_control.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/motion/plan_path.h"
#include "parallel_aspects/motion/time_path.h"

#include <parallel_aspects/PlanPathGoal.h>
#include <parallel_aspects/Status.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A change of the assembly mode on purpose.
struct CuspQuestion {
  MapSlice slice;        ///< that holds the joint at its value at the start
  std::size_t cusp = 0;  ///< index in the list of `find_cusps`
};

/// What came of it.
struct CuspPath {
  Status status;  ///< not OK where there is no such cusp, or no map of the slice
  PlannedPath path;
  PoseBetween between = pose_between;
  std::vector<int> turns_around_cusps;  ///< by cusp
};

/// A sentence that lists the cusps which a path goes around, from 1, where these are several; else nothing.
std::string several_cusps(const std::vector<int>& turns);

/// Reads what a goal says of a cusp, and moves the start, which is in the working mode of `from`, onto the
/// slice.
Status read_cusp(const Manipulator& manipulator, const PlanPathGoal& goal, PathEnd& from,
                 std::optional<CuspQuestion>& question);

/// In one aspect of the slice, back to the actuated values of the start.
CuspPath plan_around_cusp(const std::shared_ptr<const Manipulator>& manipulator, const PathEnd& from,
                          const CuspQuestion& question, const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PLAN_CUSP_QUESTION_H
