// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_TANGENCY_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_TANGENCY_H

namespace parallel_aspects {

/// Circles, spheres and lines that miss each other by so little, in squares relative to the robot, touch but
/// for rounding.
inline constexpr double tangency_tolerance = 1e-14;

/// Half chords shorter than this, relative to the robot, are so close to det A = 0 that rounding of the order
/// 1e-16 in their square shows in the pose at 1e-10 or more.
inline constexpr double short_chord = 1e-6;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_TANGENCY_H
