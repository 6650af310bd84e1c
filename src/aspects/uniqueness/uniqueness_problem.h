// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_UNIQUENESS_PROBLEM_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_UNIQUENESS_PROBLEM_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

namespace parallel_aspects {

/// Whether the direct problem has at most two solutions, with opposite signs of det A, in this task space.
///
/// With the actuated joints locked the platform's point is where spheres meet, of the rods' lengths and about
/// the proximal points, each moved by its anchor: two points of a line (T1), two circles of the plane (T2),
/// three spheres (T3). In these the two points of intersection are reflections of each other in the line or
/// plane of the centers (in T1 in the center), and that reflection takes each u_j of one to that of the
/// other, so that det A changes its sign. Where there are more than two points, or one alone, the centers and
/// the point are in one line or plane, and det A = 0.
bool has_one_solution_a_sign(TaskSpace space) noexcept;

/// Whether every leg is a strut.
bool has_struts_alone(const Manipulator& manipulator) noexcept;

/// Whether a strut or a slide has no limits on both sides.
bool has_lengths_without_limit(const Manipulator& manipulator);

/// Whether a leg has an actuated elbow.
bool has_elbows(const Manipulator& manipulator) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_UNIQUENESS_PROBLEM_H
