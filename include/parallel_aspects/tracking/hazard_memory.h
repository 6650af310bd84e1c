// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_HAZARD_MEMORY_H
#define PARALLEL_ASPECTS_TRACKING_HAZARD_MEMORY_H

#include "parallel_aspects/tracking/thresholds.h"

#include <optional>

namespace parallel_aspects {

/// The hazard that a level was due to, at a sample at which its distance was proved.
struct ProvedHazard {
  Hazard hazard = Hazard::parallel_singularity;  ///< which one
  double distance = 0.0;                         ///< at least [m]
  double speed = 0.0;  ///< of the distance, negative while approaching; not a number while unknown [m/s]
  double time = 0.0;   ///< of the sample [s]
};

/// Remembers, for as long as the level is unknown, the last hazard that was proved; and afterwards until the
/// robot is beyond the hysteresis of that hazard's thresholds. Never allocates, never throws.
class HazardMemory {
 public:
  using Speeds = std::array<double, hazard_count>;  ///< by `Hazard`; not a number while unknown [m/s]

  /// What `thresholds` last made of a sample at `time` [s], and how fast the distances change.
  void see(const DistanceThresholds& thresholds, const Speeds& speeds, double time) noexcept;

  /// Nothing is known of the robot.
  void lose() noexcept;

  /// As if nothing had been seen: what was said so far is of another time.
  void forget() noexcept { last_ = reported_ = std::nullopt; }

  /// Nothing where all is known, or nothing ever was.
  const std::optional<ProvedHazard>& reported() const noexcept { return reported_; }

 private:
  std::optional<ProvedHazard> last_, reported_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_HAZARD_MEMORY_H
