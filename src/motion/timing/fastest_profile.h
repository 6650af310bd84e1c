// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_TIMING_FASTEST_PROFILE_H
#define PARALLEL_ASPECTS_MOTION_TIMING_FASTEST_PROFILE_H

#include "motion/timing/joint_curve.h"

#include <vector>

namespace parallel_aspects {

/// The squared speeds of the parameter at the knots of a curve [1/s^2 over the parameter's] with which it is
/// passed in the least time from rest to rest; the acceleration of the parameter is constant between two
/// knots.
///
/// By reachability analysis: H. Pham and Q.-C. Pham, "A new approach to time-optimal path parameterization
/// based on reachability analysis", IEEE Transactions on Robotics 34(3), 2018. Limits are kept at both ends
/// of each interval, each of which is to be `slower` than they say by a factor of its own, 1 or more.
std::vector<double> fastest_profile(const JointCurve& curve, const MotionLimits& limits,
                                    const std::vector<double>& slower);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_TIMING_FASTEST_PROFILE_H
