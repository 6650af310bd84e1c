// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_APPROACH_SPEED_H
#define PARALLEL_ASPECTS_TRACKING_APPROACH_SPEED_H

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// Whether a distance falls or grows.
enum class Approach { unknown, approaching, leaving, steady };

/// "unknown", "approaching", "leaving" or "steady".
const char* name(Approach approach) noexcept;

/// Rate of change of a distance or index over the last samples: slope of the straight line of least squares.
/// Never allocates, never throws.
class ApproachSpeed {
 public:
  static constexpr std::size_t most = 64;  ///< samples that are kept; of more, the oldest are forgotten

  /// Samples older than `window` [s] do not count; slower than `steady` [unit of the value per second] is
  /// steady.
  explicit ApproachSpeed(double window = 0.05, double steady = 0.0) noexcept
      : window_(window), steady_(steady) {}

  /// The next value, at a later time [s]. A value that is not finite, or time that does not go on, begins
  /// anew.
  void add(double time, double value) noexcept;

  /// Begins anew.
  void forget() noexcept { count_ = 0; }

  /// Fewer than two samples know no speed.
  bool known() const noexcept { return count_ >= 2; }

  /// Change per second: negative while approaching [unit of the value per second]; 0 while unknown.
  double speed() const noexcept;

  Approach approach() const noexcept;  ///< what `speed` says in a word

 private:
  struct Sample {
    double time, value;
  };

  const Sample& newest(std::size_t back) const noexcept { return samples_[(next_ + most - 1 - back) % most]; }

  double window_, steady_;
  std::array<Sample, most> samples_{};
  std::size_t next_ = 0, count_ = 0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_APPROACH_SPEED_H
