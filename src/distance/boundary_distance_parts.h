// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_BOUNDARY_DISTANCE_PARTS_H
#define PARALLEL_ASPECTS_DISTANCE_BOUNDARY_DISTANCE_PARTS_H

#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>

namespace parallel_aspects {

/// The inverse solution of the pose; joint values and status are filled by it. There is nothing to search for
/// where a leg does not reach.
InverseSolution begin_distances(const Manipulator& robot, const Pose& pose, const WorkingMode& mode,
                                BoundaryDistances& result) noexcept;

/// Where the pose is of the boundary itself, by this leg.
BoundaryDistance touching(std::size_t leg) noexcept;

/// The joint values at the witness of a distance, and how far they are from q.
void add_joints_of_witness(const Manipulator& robot, const WorkingMode& mode, const JointVector& q,
                           BoundaryDistance& found) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_BOUNDARY_DISTANCE_PARTS_H
