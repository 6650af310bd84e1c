// SPDX-License-Identifier: BSD-3-Clause
#include "motion/check/check_text.h"
#include "motion/check/segment_times.h"
#include "motion/check/start_assembly.h"
#include "parallel_aspects/motion/check_trajectory.h"

namespace parallel_aspects {
namespace {

bool is_usable(const JointVector& values, Eigen::Index legs, bool required) {
  if (values.size() == 0) return !required;
  return values.size() == legs && values.allFinite() && is_usable_number(values.cwiseAbs().maxCoeff());
}

void check_numbers(const JointWaypoint& waypoint, const std::string& which, Eigen::Index legs,
                   Problems& problems) {
  if (!is_usable_number(waypoint.time) || !is_usable(waypoint.q, legs, true) ||
      !is_usable(waypoint.velocity, legs, false) || !is_usable(waypoint.acceleration, legs, false))
    problems.push_back(which + " needs " + std::to_string(legs) +
                       " finite joint values up to 1e12, and as many velocities and accelerations or none.");
  else if (waypoint.acceleration.size() > 0 && waypoint.velocity.size() == 0)
    problems.push_back(which + " has accelerations but no velocities; give both.");
}

}  // namespace

Problems problems_of(const Manipulator& manipulator, const std::vector<JointWaypoint>& waypoints,
                     const TrajectoryStart& start) {
  if (waypoints.empty()) return {"The trajectory has no waypoint; give one or more."};
  Problems problems;
  const auto legs = static_cast<Eigen::Index>(manipulator.leg_count());
  for (std::size_t i = 0; i < waypoints.size(); ++i)
    check_numbers(waypoints[i], waypoint_text(i), legs, problems);
  if (!problems.empty()) return problems;
  require_rising_times(waypoints, problems);
  if (manipulator.tolerance() > 0.0)
    problems.emplace_back(
        "Trajectories of actuated joints are not checked within a tolerance; leave it out.");
  const std::string misfit = start_misfit(manipulator, waypoints.front().q, start);
  if (!misfit.empty()) problems.push_back(misfit);
  return problems;
}

}  // namespace parallel_aspects
