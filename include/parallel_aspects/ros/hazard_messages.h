// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_HAZARD_MESSAGES_H
#define PARALLEL_ASPECTS_ROS_HAZARD_MESSAGES_H

#include "parallel_aspects/tracking/hazard_memory.h"
#include "parallel_aspects/tracking/thresholds.h"

#include <parallel_aspects/LastHazard.h>

#include <ros/time.h>

#include <cstdint>
#include <optional>
#include <string>

namespace parallel_aspects {

/// One of the constants of AspectState.
std::uint8_t level_message(ThresholdLevel level) noexcept;

/// Which distance a level is due to, and which threshold; empty while clear.
std::string reason_of(const ThresholdState& state);

/// Why nothing is known of the distances, and what was last.
std::string reason_of(const std::optional<ProvedHazard>& last);

/// `epoch`: what the times of hazards count from.
LastHazard hazard_message(const std::optional<ProvedHazard>& last, const ros::Time& epoch);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_HAZARD_MESSAGES_H
