// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_TRACKER_H
#define PARALLEL_ASPECTS_TRACKING_TRACKER_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

namespace parallel_aspects {

enum class TrackStatus {
  unstarted,  ///< no pose is known yet
  tracking,   ///< the pose belongs to the last sample
  ambiguous,  ///< the last steps came too close to det A = 0 to tell which assembly mode the robot is in
};

/// "unstarted", "tracking" or "ambiguous".
const char* name(TrackStatus status) noexcept;

/// What is known of the robot at the time of one joint sample.
struct TrackedState {
  TrackStatus status = TrackStatus::unstarted;
  double time = 0.0;         ///< of the sample [s]
  JointVector q;             ///< of the sample
  Pose pose;                 ///< valid while tracking
  WorkingMode mode;          ///< valid while tracking; at B_jj = 0 the last mode
  int determinant_sign = 0;  ///< +1 or -1 while tracking
  int aspect = 0;            ///< id in the map; 0 while unknown or without a map
};

enum class TransitionKind {
  working_mode,  ///< B_jj of `leg` went through zero
  aspect,  ///< the robot was found in another aspect of its mode, for instance after det A lost its sign
};

/// One change of working mode or aspect.
struct Transition {
  TransitionKind kind = TransitionKind::working_mode;
  double time = 0.0;         ///< of the crossing, interpolated between two samples [s]
  std::size_t leg = 0;       ///< whose B_jj crossed zero, for a change of working mode
  bool determinant = false;  ///< whether det A crossed zero
  WorkingMode mode_before, mode_after;
  int determinant_sign_before = 0, determinant_sign_after = 0;
  int aspect_before = 0, aspect_after = 0;  ///< 0 while unknown
};

/// Transitions of one update; a step crosses B_jj = 0 at most once for each leg, and det A = 0 at most once.
struct Transitions {
  std::array<Transition, max_legs + 1> items;
  std::size_t count = 0;

  const Transition* begin() const noexcept { return items.data(); }
  const Transition* end() const noexcept { return items.data() + count; }
  bool empty() const noexcept { return count == 0; }
};

/// Follows the pose of the platform from the actuated joints alone, by continuation of the direct kinematics.
/// Between two samples the drives are taken to move straight. Not thread-safe; one owner.
class Tracker {
 public:
  explicit Tracker(std::shared_ptr<const Manipulator> manipulator);

  /// From now on aspects are looked up in `map`, which must be of the same manipulator; null for none.
  void set_map(std::shared_ptr<const AspectMap> map) noexcept;

  /// Starts from a pose known to belong to `q`, refined by the direct solution closest to it. False, and
  /// unstarted, where no direct solution is within `tolerance` of the pose [m, RMS over the anchors].
  bool start(double time, const JointVector& q, const Pose& pose, double tolerance);

  /// Starts in the assembly mode with this sign of det A (+1 or -1). False, and unstarted, unless there is
  /// exactly one.
  bool start(double time, const JointVector& q, int determinant_sign);

  /// Forgets the pose.
  void stop() noexcept;

  /// The next sample: finite q with one entry a leg, time after the last one. No allocation, no exception.
  const TrackedState& update(double time, const JointVector& q) noexcept;

  const TrackedState& state() const noexcept { return state_; }

  /// What the last `update` or `start` crossed.
  const Transitions& transitions() const noexcept { return transitions_; }

 private:
  bool begin_at(double time, const JointVector& q, const Pose& pose);

  std::shared_ptr<const Manipulator> manipulator_;
  std::shared_ptr<const AspectMap> map_;
  TrackedState state_;
  Transitions transitions_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_TRACKER_H
