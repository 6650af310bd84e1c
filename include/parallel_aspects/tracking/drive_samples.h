// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_DRIVE_SAMPLES_H
#define PARALLEL_ASPECTS_TRACKING_DRIVE_SAMPLES_H

#include "parallel_aspects/model/manipulator.h"

#include <limits>
#include <string>
#include <vector>

namespace parallel_aspects {

/// What samples of the drives are taken to mean.
struct SampleOptions {
  /// Angles of drives without limits are taken to have turned less than half a turn since the sample before,
  /// whatever whole turns their encoder reports; those with limits to be inside them, where a whole number of
  /// turns can bring them there.
  bool unwrap = true;

  /// Whether a step longer than the velocity limits of the drives allow in its time is a gap, and so is a
  /// time in which a drive that is unwrapped may have turned by half a turn.
  bool check_velocity = true;

  /// By how much a step may be longer, for jitter of the stamps, as a share [0 or more].
  double velocity_tolerance = 0.25;

  /// And for noise of the encoders: this many rad, or of this share of the robot's size in m.
  double encoder_noise = 1e-4;

  /// How far the drives may leave the straight way between two samples: this many times an eighth of the
  /// difference of the last two steps, the first step being taken from rest. For samples at even times an
  /// eighth is |a| dt^2 / 8, what the acceleration bends the way. 0: the way is exactly straight. A smooth
  /// motion through det A = 0 touches the image of the singularity, which its chords miss by just that much.
  double path_bend = 2.0;

  /// Samples farther apart than this are a gap, whatever the drives do [s].
  double longest_interval = std::numeric_limits<double>::infinity();
};

/// Every problem, a sentence each; empty when the options can be used.
std::vector<std::string> problems_of(const SampleOptions& options);

/// `q` with angles turned to where `last` says that they are; without a last sample (empty), to where the
/// limits say. One entry a leg [rad or m]. Never allocates.
JointVector unwrapped(const Manipulator& manipulator, const JointVector& last, const JointVector& q) noexcept;

/// Whether nothing is known of the way of the drives between two samples that are `seconds` apart.
bool is_gap(const Manipulator& manipulator, const SampleOptions& options, const JointVector& last,
            const JointVector& q, double seconds) noexcept;

/// How far the drives may have left the straight way between samples, from one step to the next. Never
/// allocates.
class PathBend {
 public:
  /// For a step of the drives, by `SampleOptions::path_bend` [rad or m]. Stamps play no part: their jitter
  /// would look like accelerations.
  JointVector next(const SampleOptions& options, const JointVector& step) noexcept;

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

#endif  // PARALLEL_ASPECTS_TRACKING_DRIVE_SAMPLES_H
