// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_HAZARDS_H
#define PARALLEL_ASPECTS_TRACKING_HAZARDS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// What a distance is measured to.
enum class Hazard { parallel_singularity, serial_singularity, limit };

/// How many hazards there are.
inline constexpr std::size_t hazard_count = 3;

/// "parallel singularity", "serial singularity" or "limit".
const char* name(Hazard hazard) noexcept;

/// By danger: of two levels the greater is the worse, so that `level >= stop` holds wherever a robot must
/// stop. Where no threshold is set there is nothing to compare with: that is not clear. The numbers are those
/// of AspectState; 0 is no level.
enum class ThresholdLevel : std::uint8_t {
  clear = 1,    ///< above all thresholds
  warn = 2,     ///< below the first
  stop = 3,     ///< below the second: the robot must stop
  unknown = 4,  ///< a distance that has a threshold is not known
  unset = 5,    ///< no hazard has a threshold
};

/// "unknown", "clear", "warn", "stop" or "no threshold".
const char* name(ThresholdLevel level) noexcept;

/// Thresholds on distances to hazards, all in the unit of the distances that they are compared with [m].
/// 0 for no such threshold.
struct ThresholdOptions {
  double warn = 0.0;        ///< the robot is warned below it [m]
  double stop = 0.0;        ///< the robot must stop below it [m]
  double hysteresis = 0.1;  ///< a level is left above its threshold times 1 plus this [0 or more]
};

/// Every problem, a message each; empty when the options can be used. All must be finite and not negative,
/// and `stop` not above `warn` where both are set.
std::vector<std::string> problems_of(const ThresholdOptions& options);

/// What the thresholds make of the last distances.
struct ThresholdState {
  ThresholdLevel level = ThresholdLevel::unknown;  ///< the worst of all hazards
  Hazard hazard = Hazard::parallel_singularity;  ///< that the level is due to: the nearest of those that have
                                                 ///< it, of all where no threshold is set
  double distance =
      std::numeric_limits<double>::quiet_NaN();  ///< to that hazard; not a number while unknown [m]
  double threshold = 0.0;  ///< below which the level was taken; valid for warn and stop [m]
  bool held = false;       ///< the distance is above the threshold again, but not by the hysteresis
};

/// Compares lower bounds of the distances to the nearest hazards with thresholds, each hazard with its own.
/// The level of the whole is the worst, so that an unknown distance is never taken for a known one; `unset`
/// where no hazard has a threshold. Never allocates, never throws.
class DistanceThresholds {
 public:
  using Options = std::array<ThresholdOptions, hazard_count>;  ///< by `Hazard`
  using Distances = std::array<double, hazard_count>;  ///< by `Hazard`; not a number while unknown [m]

  /// The level is unknown at first. The options have no `problems_of`.
  explicit DistanceThresholds(const Options& options = {}) noexcept { set_options(options); }

  /// Levels are taken anew from the next distances.
  void set_options(const Options& options) noexcept;

  /// The next distances. Beside others that have one, a hazard with no threshold of its own is always clear.
  const ThresholdState& update(const Distances& distances) noexcept;

  /// Nothing is known of the robot. Once distances are known again, the hysteresis goes on where it was.
  const ThresholdState& lose() noexcept;

  /// After the last `update` or `lose`.
  const ThresholdState& state() const noexcept { return state_; }

  /// Of this hazard alone.
  ThresholdLevel level(Hazard hazard) const noexcept { return levels_[static_cast<std::size_t>(hazard)]; }

 private:
  Options options_;
  bool is_set_ = false;  // a threshold of any hazard
  std::array<ThresholdLevel, hazard_count> levels_;
  std::array<ThresholdLevel, hazard_count> known_;  // the last that were known, for the hysteresis
  ThresholdState state_;
};

/// Whether any hazard has a threshold.
bool is_set(const DistanceThresholds::Options& options) noexcept;

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

  /// As if nothing had been seen: what was reported so far belongs to another time.
  void forget() noexcept { last_ = reported_ = std::nullopt; }

  /// Nothing where all is known, or nothing ever was.
  const std::optional<ProvedHazard>& reported() const noexcept { return reported_; }

 private:
  std::optional<ProvedHazard> last_, reported_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_HAZARDS_H
