// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHECK_SEGMENT_TIMES_H
#define PARALLEL_ASPECTS_MOTION_CHECK_SEGMENT_TIMES_H

#include "motion/check/check_text.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/problems.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// Waypoints are no closer than this, so that speeds are finite [s].
constexpr double shortest_time = 1e-9;

/// A message for each waypoint that is not later than the one before.
template <class Waypoint>
void require_rising_times(const std::vector<Waypoint>& waypoints, Problems& problems) {
  for (std::size_t i = 1; i < waypoints.size(); ++i)
    if (!(waypoints[i].time - waypoints[i - 1].time >= 0.99 * shortest_time))
      problems.push_back(waypoint_text(i) +
                         " is not later than the one before; times must rise, by a nanosecond at least.");
}

/// The segments between waypoints, and times on them by the share of a segment that is gone. A trajectory of
/// one waypoint is one segment of no length. The waypoints must outlive it.
template <class Waypoint>
class SegmentTimes {
 public:
  explicit SegmentTimes(const std::vector<Waypoint>& waypoints) : waypoints_(waypoints) {}

  std::size_t count() const { return std::max<std::size_t>(waypoints_.size() - 1, 1); }
  const Waypoint& from(std::size_t i) const { return waypoints_[i]; }
  const Waypoint& to(std::size_t i) const { return waypoints_[std::min(i + 1, waypoints_.size() - 1)]; }

  /// Reports that segment i is done; some hundred times at most.
  void report(std::size_t i, const MapControl& control) const {
    const std::size_t stride = 1 + count() / 256;
    if (control.progress && i % stride == 0)
      control.progress(static_cast<double>(i) / static_cast<double>(count()));
  }

  double at(std::size_t i, double share) const { return from(i).time + share * (to(i).time - from(i).time); }

  /// A lower bound of the time at this share, in spite of rounding.
  double before(std::size_t i, double share) const {
    return share >= 1.0 ? to(i).time : std::max(from(i).time, at(i, share) - rounding(i));
  }

  /// An upper bound.
  double after(std::size_t i, double share) const { return std::min(to(i).time, at(i, share) + rounding(i)); }

 private:
  double rounding(std::size_t i) const {
    return 0x1p-50 * std::max(std::abs(from(i).time), std::abs(to(i).time));
  }

  const std::vector<Waypoint>& waypoints_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHECK_SEGMENT_TIMES_H
