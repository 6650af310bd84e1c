// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_OMPL_POSE_STATE_SPACE_H
#define PARALLEL_ASPECTS_OMPL_POSE_STATE_SPACE_H

#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/task_space.h"

#include <ompl/base/StateSpace.h>
#include <optional>

namespace parallel_aspects {

/// OMPL's state space for the poses of this manipulator: a RealVectorStateSpace in T1, T2 and T3, an
/// SE2StateSpace, an SO3StateSpace or an SE3StateSpace. Two things differ from OMPL's own:
///  - `interpolate` runs as `pose_between`, as certified segments do. In SE2 and SE3 the rotation is then not
///    uniform while the position is: a part of a motion is not quite the motion between its ends, and must be
///    checked anew, as OMPL's path simplifier does.
///  - distances are metres [m], with rotations times `Manipulator::characteristic_length`. In SO3 they are
///    OMPL's own, half the angle [rad].
///
/// Positions are bounded by the reach of the legs, the workspace of the constraints, and `region` where one
/// is given: as many of x, y, z as the task space moves [m]. Throws `InvalidDescription` where these leave
/// positions unbounded or leave none.
ompl::base::StateSpacePtr make_pose_state_space(const Manipulator& manipulator,
                                                const std::optional<Box>& region = {});

/// The pose that a state of `make_pose_state_space` says; never of another kind of state.
Pose pose_of(TaskSpace space, const ompl::base::State& state) noexcept;

/// Makes a state say this pose, which must lie in the task space.
void set_pose(TaskSpace space, const Pose& pose, ompl::base::State& state) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_OMPL_POSE_STATE_SPACE_H
