// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_RECOGNITION_DESCRIPTION_ROUNDING_H
#define PARALLEL_ASPECTS_URDF_RECOGNITION_DESCRIPTION_ROUNDING_H

#include "parallel_aspects/model/manipulator.h"

namespace parallel_aspects {

/// How far directions of a description may differ and still be taken as one [rad]: wide enough for angles
/// rounded to four digits, as in rpy="1.57075 0 0".
inline constexpr double direction_tolerance = 5e-4;

/// `leg` without what computing with frames leaves of rounding: lengths become decimal numbers of at most 14
/// digits of `size` [m], directions and angles have 14 and 13 decimals. So dimensions are again what the URDF
/// says, and what is symmetric there is symmetric in the model.
Leg without_rounding_noise(Leg leg, double size);

/// The same of one length [m].
double without_rounding_noise(double length, double size);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_RECOGNITION_DESCRIPTION_ROUNDING_H
