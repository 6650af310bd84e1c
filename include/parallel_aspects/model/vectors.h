// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_VECTORS_H
#define PARALLEL_ASPECTS_MODEL_VECTORS_H

#include <Eigen/Core>

namespace parallel_aspects {

/// No task space has more degrees of freedom, so no fully parallel manipulator has more legs.
inline constexpr int max_legs = 6;

/// One number a leg, or one a degree of freedom of the platform. Never allocates.
using TaskVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, max_legs, 1>;

/// Actuated joint values q, in the order of the legs; rad for actuated revolute joints, m for prismatic ones.
using JointVector = TaskVector;

/// Square matrix over the legs and degrees of freedom. Never allocates.
using TaskMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, max_legs, max_legs>;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_VECTORS_H
