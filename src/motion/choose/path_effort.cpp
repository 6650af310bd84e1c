// SPDX-License-Identifier: BSD-3-Clause
#include "motion/choose/path_effort.h"

#include "motion/choose/path_pieces.h"
#include "motion/roadmap.h"
#include "parallel_aspects/kinematics/inverse.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr std::size_t samples = 400;

}  // namespace

int rank(TrajectoryAnswer answer) noexcept {
  return answer == TrajectoryAnswer::safe ? 0 : answer == TrajectoryAnswer::unknown ? 1 : 2;
}

PathEffort effort_of(const Manipulator& manipulator, const std::vector<PoseWaypoint>& waypoints,
                     const WorkingMode& mode) {
  PathEffort effort{std::vector<double>(manipulator.leg_count(), 0.0), 0.0};
  JointVector last;
  for (const PoseWaypoint& waypoint : divided_path(waypoints, samples)) {
    const JointVector q = inverse(manipulator, waypoint.pose, mode).q;
    if (last.size() > 0) {
      const JointVector change = joint_change(manipulator, last, q).cwiseAbs();
      double time = 0.0;
      for (std::size_t j = 0; j < effort.travel.size(); ++j) {
        const double moved = change[static_cast<Eigen::Index>(j)];
        effort.travel[j] += moved;
        time = std::max(time, moved / manipulator.leg(j).limits.velocity);
      }
      effort.least_time += time;
    }
    last = q;
  }
  return effort;
}

}  // namespace parallel_aspects
