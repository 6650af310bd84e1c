// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/tracking/hazard_memory.h"

#include <cmath>

namespace parallel_aspects {

void HazardMemory::see(const DistanceThresholds& thresholds, const Speeds& speeds, double time) noexcept {
  const ThresholdState& state = thresholds.state();
  if (state.level == ThresholdLevel::unknown) return lose();
  if (reported_ && thresholds.level(reported_->hazard) == ThresholdLevel::clear) reported_.reset();
  if (std::isfinite(state.distance))
    last_ = {state.hazard, state.distance, speeds[static_cast<std::size_t>(state.hazard)], time};
}

void HazardMemory::lose() noexcept {
  if (last_) reported_ = last_;
}

}  // namespace parallel_aspects
