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

/// The reason, a sentence, where a trajectory is safe.
std::string safe_text();

/// The same where legs passed serial singularities, which was allowed.
std::string passed_text();

/// The reason where it is not safe.
std::string unsafe_text(const Manipulator& manipulator, const TrajectoryViolation& violation);

/// The reason where it is proved free until a time, and undecided from then on: "it comes too near ...".
std::string undecided_text(double free_until, const std::string& why);

/// Why a trajectory is not followed to its end.
std::string not_followed_text(double followed_until, const std::string& why);

/// The `why` of these where it is not known what the trajectory comes near to.
std::string near_something_text();

/// A sentence without its dot: what is violated, by which leg or constraint.
std::string violation_text(const Manipulator& manipulator, const TrajectoryViolation& violation);

/// Whether crossing a singularity is what is violated.
bool is_crossing(Violation kind);

/// Both ends of a bracket of times, in so many digits that they differ if the numbers do.
std::array<std::string, 2> bracket_text(double after, double before);

/// Whether it is finite, and so small that arithmetic with it stays finite.
bool is_usable_number(double value) noexcept;

/// Every reason why poses are no trajectory of any robot.
Problems waypoint_problems(const std::vector<PoseWaypoint>& waypoints);

/// The message about a start that is below a margin; empty where it keeps all.
std::string missed_at_start(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// The answer where nothing can be checked: unknown, with the first problem as its reason. There must be one.
TrajectoryCheck refused(const Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHECK_CHECK_TEXT_H
