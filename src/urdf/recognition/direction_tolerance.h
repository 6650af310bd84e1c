// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_RECOGNITION_DIRECTION_TOLERANCE_H
#define PARALLEL_ASPECTS_URDF_RECOGNITION_DIRECTION_TOLERANCE_H

namespace parallel_aspects {

/// How far directions of a description may differ and still be taken as one [rad]: wide enough for angles
/// rounded to four digits, as in rpy="1.57075 0 0".
inline constexpr double direction_tolerance = 5e-4;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_RECOGNITION_DIRECTION_TOLERANCE_H
