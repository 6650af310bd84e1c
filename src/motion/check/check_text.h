// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHECK_CHECK_TEXT_H
#define PARALLEL_ASPECTS_MOTION_CHECK_CHECK_TEXT_H

#include "parallel_aspects/motion/check_trajectory.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace parallel_aspects {

/// "Waypoint 1" for index 0.
std::string waypoint_text(std::size_t index);

/// The reason of a trajectory that is safe, a sentence.
std::string safe_text();

/// The same where legs passed serial singularities, as they were allowed to.
std::string passed_text();

/// The reason of one that is not.
std::string unsafe_text(const Manipulator& manipulator, const TrajectoryViolation& violation);

/// The reason of one that cannot be decided after it was proved free until a time: "it comes too near ...".
std::string undecided_text(double free_until, const std::string& why);

/// Why a trajectory is not followed to its end.
std::string not_followed_text(double followed_until, const std::string& why);

/// Why, where it is not known what it comes near to.
std::string near_something_text();

/// A sentence without its dot: what is violated, by which leg or constraint.
std::string violation_text(const Manipulator& manipulator, const TrajectoryViolation& violation);

/// Whether crossing a singularity is what is violated.
bool is_crossing(Violation kind);

/// Of what cannot be checked: unknown, with the first problem as its reason. There must be one.
/// Both ends of a bracket of times, in so many digits that they differ if the numbers do.
std::array<std::string, 2> bracket_text(double after, double before);

/// Neither infinite nor so large that arithmetic with it could be.
bool is_usable_number(double value) noexcept;

/// Every reason why poses are no trajectory, whatever the robot is.
Problems waypoint_problems(const std::vector<PoseWaypoint>& waypoints);

/// Of a start that is below a margin; empty where it keeps all.
std::string missed_at_start(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

TrajectoryCheck refused(const Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHECK_CHECK_TEXT_H
