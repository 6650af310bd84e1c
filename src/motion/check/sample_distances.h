// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHECK_SAMPLE_DISTANCES_H
#define PARALLEL_ASPECTS_MOTION_CHECK_SAMPLE_DISTANCES_H

#include "parallel_aspects/motion/check_trajectory.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace parallel_aspects {

/// How far a sample of a trajectory is at least from parallel singularities, serial ones and limits of the
/// actuated joints, as `BoundaryDistanceMeter` measures it, proved [m].
struct SampleDistances {
  bool measured = false;  ///< here; else by how far the robot moves to where it was
  std::array<double, 3> lower{};
};

/// Of every sample of a check, measured at `points` of them, evenly by time; none for no points.
std::vector<SampleDistances> distances_on(const std::shared_ptr<const Manipulator>& manipulator,
                                          const TrajectoryCheck& check, std::size_t points);

/// The least that is proved over all of the continuous time up to `free_until`.
std::array<double, 3> least_distances(const TrajectoryCheck& check,
                                      const std::vector<SampleDistances>& distances);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHECK_SAMPLE_DISTANCES_H
