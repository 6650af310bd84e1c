// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_CANDIDATES_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_CANDIDATES_H

#include "parallel_aspects/kinematics/kinematics.h"

namespace parallel_aspects {

/// Circles, spheres and lines that miss each other by so little, in squares relative to the robot, touch but
/// for rounding.
inline constexpr double tangency_tolerance = 1e-14;

/// Half chords shorter than this, relative to the robot, are so close to det A = 0 that rounding of the order
/// 1e-16 in their square shows in the pose at 1e-10 or more.
inline constexpr double short_chord = 1e-6;

/// Direct solutions in T1: the operational point is where its line meets a sphere, so there are two, one or
/// none. Pose and `near_singular` are filled, the rest is left to `direct`, which callers should prefer.
DirectResult direct_t1(const Manipulator& manipulator, const JointVector& q);

/// Direct solutions in T2: the operational point is where two circles meet, so there are two, one or none.
/// Pose and `near_singular` are filled, the rest is left to `direct`, which callers should prefer.
DirectResult direct_t2(const Manipulator& manipulator, const JointVector& q);

/// Direct solutions in T3: the operational point is where three spheres meet, so there are two, one or none.
/// Only poses are filled; the rest is left to `direct`, which callers should prefer.
DirectResult direct_t3(const Manipulator& manipulator, const JointVector& q);

/// Candidates for the direct solutions in SE2, where three points of the platform lie on three circles: at
/// most six, by way of `circle_family_solutions` in the angle phi of the platform. Every real solution is
/// near one of the candidates, but not every candidate is one. Only poses are filled; `direct` does the rest
/// and is what callers should use.
DirectResult direct_se2(const Manipulator& manipulator, const JointVector& q);

/// Candidates for the direct solutions in SO3, where three axes of the platform are at given angles from
/// three fixed directions: at most eight, by way of `circle_family_solutions` in the turn of one leg about
/// its proximal point. Every real solution is near one of the candidates, but not every candidate is one.
/// Only poses are filled; `direct` does the rest and is what callers should use.
DirectResult direct_so3(const Manipulator& manipulator, const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_CANDIDATES_H
