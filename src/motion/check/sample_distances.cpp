// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/motion/check_trajectory.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

SampleDistances measured(BoundaryDistanceMeter& meter, const Pose& pose, const WorkingMode& mode) {
  const BoundaryDistances found = meter.measure(pose, mode);
  return {true, {found.parallel.lower, found.serial.lower, found.actuated_limit.lower}};
}

// A distance changes by no more than the robot moves.
void carry(const TrajectorySample& from, const SampleDistances& known, const TrajectorySample& to,
           SampleDistances& there) {
  if (there.measured) return;
  const double moved = std::abs(to.travel - from.travel) * (1.0 + 0x1p-50);
  for (std::size_t k = 0; k < known.lower.size(); ++k)
    there.lower[k] = std::max(there.lower[k], known.lower[k] - moved);
}

}  // namespace

std::vector<SampleDistances> distances_on(const std::shared_ptr<const Manipulator>& manipulator,
                                          const TrajectoryCheck& check, std::size_t points) {
  const std::vector<TrajectorySample>& samples = check.samples;
  if (points == 0 || samples.empty() || !check.mode) return {};
  std::vector<SampleDistances> distances(samples.size());
  BoundaryDistanceMeter meter(manipulator);
  const std::size_t last = samples.size() - 1, count = std::min(std::max<std::size_t>(points, 2), last + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = count == 1 ? 0 : i * last / (count - 1);
    distances[at] = measured(meter, samples[at].pose, *check.mode);
  }
  for (std::size_t i = 1; i <= last; ++i) carry(samples[i - 1], distances[i - 1], samples[i], distances[i]);
  for (std::size_t i = last; i-- > 0;) carry(samples[i + 1], distances[i + 1], samples[i], distances[i]);
  return distances;
}

std::array<double, 3> least_distances(const TrajectoryCheck& check,
                                      const std::vector<SampleDistances>& distances) {
  std::array<double, 3> least{infinity, infinity, infinity};
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const SampleDistances& other = distances[i == 0 ? 0 : i - 1];
    const double moved =
        i == 0 ? 0.0 : (check.samples[i].travel - check.samples[i - 1].travel) * (1.0 + 0x1p-50);
    for (std::size_t k = 0; k < least.size(); ++k)
      least[k] = std::min(least[k], std::max(0.0, std::max(distances[i].lower[k], other.lower[k]) - moved));
  }
  return least;
}

}  // namespace parallel_aspects
