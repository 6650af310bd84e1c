// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_CHECK_TABLE_H
#define PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_CHECK_TABLE_H

#include "parallel_aspects/motion/check_trajectory.h"

#include <array>
#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// The names of the three, as columns.
inline constexpr std::array<const char*, 3> distance_names{"parallel_distance", "serial_distance",
                                                           "limit_distance"};

/// The samples as CSV: time, pose, actuated joints, indices, and the distances where there are any.
std::string check_csv(const Manipulator& manipulator, const TrajectoryCheck& check,
                      const std::vector<SampleDistances>& distances);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_CHECK_TABLE_H
