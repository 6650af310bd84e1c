// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_THRESHOLD_OFFER_H
#define PARALLEL_ASPECTS_ROS_MONITOR_THRESHOLD_OFFER_H

#include "parallel_aspects/tracking/tracker.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "ros/parameters/node_options.h"

#include <string>

namespace parallel_aspects {

/// Thresholds to begin with where none is set: a share of the robot's size that the campaigns of
/// docs/development/benchmarks.md were run with, and before parallel singularities no less than the
/// stand-off. An example, for what is too near depends on how fast the robot is and how soon it stops.
ThresholdParameters offered_thresholds(const Manipulator& robot, const StandOffEstimate& stand_off);

/// The same in a sentence, as parameters to paste, with a speed that they suit and the one that the velocity
/// limits allow.
std::string threshold_offer(const Mechanism& mechanism, const StandOffEstimate& stand_off);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_THRESHOLD_OFFER_H
