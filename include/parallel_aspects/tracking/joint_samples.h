// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_JOINT_SAMPLES_H
#define PARALLEL_ASPECTS_TRACKING_JOINT_SAMPLES_H

#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace parallel_aspects {

/// What samples of the actuated joints are taken to mean.
struct SampleOptions {
  /// Angles of actuated joints without limits are taken to have turned less than half a turn since the sample
  /// before, whatever whole turns their encoder reports; those with limits to be inside them, where a whole
  /// number of turns can bring them there.
  bool unwrap = true;

  /// Whether a step longer than the velocity limits of the actuated joints allow in its time is a gap, and a
  /// time in which an actuated joint that is unwrapped may have turned by half a turn is a silence.
  bool check_velocity = true;

  /// By how much a step may be longer, for jitter of the stamps, as a share [0 or more].
  double velocity_tolerance = 0.25;

  /// Noise of the encoders: joint values are taken to be off by this at most, in each proof of a step too,
  /// and a step may be longer by it [rad, or as a share of the robot's size].
  double encoder_noise = 1e-4;

  /// How far the actuated joints may leave the straight path between two samples: this many times an eighth
  /// of the difference of the last two steps, the first step being taken from rest. For samples at even times
  /// an eighth is |a| dt^2 / 8, what the acceleration bends the path. 0: the path is exactly straight. A
  /// smooth motion through det A = 0 touches the image of the singularity, which its chords miss by just that
  /// much.
  double path_bend = 2.0;

  /// A longer interval between the stamps of two samples is a silence, whatever the actuated joints did [s]:
  /// a robot that is moved meanwhile can go through det A = 0 and come back to actuated joints near those
  /// before. Infinite where it is known that nothing moves the robot unseen: then no interval is too long.
  double longest_interval = 0.5;

  /// And where an actuated joint has no velocity limit, or `check_velocity` is false, so is an interval that
  /// is this many times the median of the last ones [1 or more].
  double interval_ratio = 5.0;
};

/// Every problem, a message each; empty when the options can be used.
std::vector<std::string> problems_of(const SampleOptions& options);

/// `q` with angles turned to where `last` says that they are; without a last sample (empty), to where the
/// limits say. One entry a leg [rad or m]. Never allocates.
JointVector unwrapped(const Manipulator& manipulator, const JointVector& last, const JointVector& q) noexcept;

/// `SampleOptions::encoder_noise` of each actuated joint [rad or m].
JointVector encoder_noise(const Manipulator& manipulator, const SampleOptions& options) noexcept;

/// Whether velocity limits tell how far any actuated joint can have moved in a time.
bool velocities_limited(const Manipulator& manipulator, const SampleOptions& options) noexcept;

/// The last intervals between samples, by which a silence is distinguished from the usual rate. Never
/// allocates.
class SampleIntervals {
 public:
  /// Whether `seconds` is more than `ratio` times the median of the last intervals. False while too few of
  /// them are known.
  bool exceeded_by(double seconds, double ratio) const noexcept;

  /// What is not positive is left out [s].
  void add(double seconds) noexcept;

  /// The rate is not known any more.
  void forget() noexcept { count_ = 0; }

 private:
  static constexpr std::size_t most = 15;   // so many are remembered
  static constexpr std::size_t fewest = 3;  // with fewer the rate is not known
  std::array<double, most> seconds_{};
  std::size_t count_ = 0, next_ = 0;
};

/// Why nothing is known of the path of the actuated joints between two samples.
enum class SampleGap {
  none,       ///< it is known
  step,       ///< it is longer than the velocity limits allow
  silence,    ///< more time went by than `longest_interval`
  pause,      ///< more than `interval_ratio` times the usual interval
  half_turn,  ///< so much that an actuated joint without limits may have turned by half a turn
};

/// For two samples that are `seconds` apart, after samples at these intervals. `uncertainty`: how far each
/// actuated joint may be from the two values, both taken together [rad or m]; empty for 0.
SampleGap gap_between(const Manipulator& manipulator, const SampleOptions& options,
                      const SampleIntervals& intervals, const JointVector& last, const JointVector& q,
                      double seconds, const JointVector& uncertainty = {}) noexcept;

/// How far the actuated joints may have left the straight path between samples, from one step to the next.
/// Never allocates.
class PathBend {
 public:
  /// For a step of the actuated joints, by `SampleOptions::path_bend` and with this noise of the encoders
  /// [rad or m]: of the three joint values that the difference of two steps is made of each may be off, the
  /// one in the middle counting twice, and so may both ends of the step. Stamps play no part: their jitter
  /// would look like accelerations.
  JointVector next(const SampleOptions& options, const JointVector& step, const JointVector& noise) noexcept;

  /// The most that `next` gives at rest, where noise alone makes the steps.
  static JointVector at_rest(const SampleOptions& options, const JointVector& noise) noexcept {
    return (options.path_bend + 1.0) * noise;
  }

  /// What `next` last gave; empty at rest.
  const JointVector& allowance() const noexcept { return allowance_; }

  /// The next step starts from rest.
  void forget() noexcept {
    last_step_.resize(0);
    allowance_.resize(0);
  }

 private:
  JointVector last_step_;  // empty at rest
  JointVector allowance_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_JOINT_SAMPLES_H
