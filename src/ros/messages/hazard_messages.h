// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MESSAGES_HAZARD_MESSAGES_H
#define PARALLEL_ASPECTS_ROS_MESSAGES_HAZARD_MESSAGES_H

#include "model/spherical_links.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/tracking/hazards.h"
#include "parallel_aspects/tracking/tracker.h"

#include <parallel_aspects/DistanceBounds.h>
#include <parallel_aspects/LastHazard.h>
#include <parallel_aspects/UniquenessState.h>

#include <ros/time.h>

#include <cstdint>
#include <optional>
#include <string>

namespace parallel_aspects {

/// The level of a state: that of its thresholds, and WARN where they are clear but `uniqueness` warns.
ThresholdLevel level_of(const ThresholdState& state, const UniquenessState& uniqueness) noexcept;

/// One of the constants of AspectState.
std::uint8_t level_message(ThresholdLevel level) noexcept;

/// Which distance a level is due to, and which threshold; empty while clear.
std::string reason_of(const ThresholdState& state, DistanceUnit unit);

/// Why nothing is known of the distances, and what was last.
std::string reason_of(const std::optional<ProvedHazard>& last, DistanceUnit unit);

/// What noise of the encoders means for this robot; empty where no parallel singularity was found.
std::string message_of(const StandOffEstimate& estimate, DistanceUnit unit);

/// What is wrong with a threshold to stop at before parallel singularities; empty when all is well, or there
/// is none (0) [m, also for angles].
std::string warning_of(const StandOffEstimate& estimate, double parallel_stop, DistanceUnit unit);

/// Distances that are not known: not numbers.
DistanceBounds unknown_distance();

/// A distance as it was measured; its speed is not known.
DistanceBounds bounds_of(const BoundaryDistance& distance);

/// The same after the robot has moved by so much [m]: the distance is that to a set of poses, so it changes
/// by no more than that, and a little for rounding. `size`: of the robot [m].
DistanceBounds after_motion(DistanceBounds bounds, double by, double size);

/// `epoch`: what the times of hazards count from.
LastHazard hazard_message(const std::optional<ProvedHazard>& last, const ros::Time& epoch);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MESSAGES_HAZARD_MESSAGES_H
