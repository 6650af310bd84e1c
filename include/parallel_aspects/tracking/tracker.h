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
  int aspect = 0;  ///< id in the map; 0 without a map, or too close to a singularity since the last change
};

enum class TransitionKind {
  working_mode,  ///< B_jj of `leg` went through zero
  aspect,        ///< the aspect became known, or a start found the robot in another one than before
  lost,          ///< det A came too close to zero to tell the assembly mode from here on
};

/// "working mode", "aspect" or "lost".
const char* name(TransitionKind kind) noexcept;

/// One change of working mode or aspect.
struct Transition {
  TransitionKind kind = TransitionKind::working_mode;
  double time = 0.0;         ///< of the crossing, interpolated between two samples [s]
  std::size_t leg = 0;       ///< whose B_jj crossed zero, for a change of working mode
  bool determinant = false;  ///< whether det A lost its sign, or has another one than before
  WorkingMode mode_before, mode_after;
  int determinant_sign_before = 0, determinant_sign_after = 0;
  int aspect_before = 0, aspect_after = 0;  ///< 0 while unknown
};

/// Transitions of one update, in the order of time.
struct Transitions {
  static constexpr std::size_t most = 16;  ///< a step that crosses more often ends with `dropped`
  std::array<Transition, most> items;
  std::size_t count = 0;
  bool dropped = false;  ///< more happened than there was room for

  const Transition* begin() const noexcept { return items.data(); }
  const Transition* end() const noexcept { return items.data() + count; }
  bool empty() const noexcept { return count == 0; }
};

struct TrackerOptions {
  /// A change of working mode counts once the leg is this far from stretched or folded, as the sine of the
  /// angle at its elbow, |B_jj| / (|u_j| |c_j'|) [0 to 1]: noise about B_jj = 0, and touching it, are no
  /// change.
  double hysteresis = 1e-3;
};

/// Follows the pose of the platform from the actuated joints alone, by certified continuation of the direct
/// kinematics. Between two samples the drives are taken to move straight. Not thread-safe; one owner.
class Tracker {
 public:
  explicit Tracker(std::shared_ptr<const Manipulator> manipulator, const TrackerOptions& options = {});

  /// From now on aspects are looked up in `map`, which must be of the same manipulator; null for none.
  void set_map(std::shared_ptr<const AspectMap> map) noexcept;

  /// Starts from a pose known to belong to `q`: the direct solution that Newton's method finds from there.
  /// False, and unstarted, where that is farther than `tolerance` from the pose [m, RMS over the anchors],
  /// where q or pose are not finite, or where det A or a B_jj is zero there.
  bool start(double time, const JointVector& q, const Pose& pose, double tolerance);

  /// Starts in the assembly mode with this sign of det A (+1 or -1). False, and unstarted, unless there is
  /// exactly one and it is not near singular.
  bool start(double time, const JointVector& q, int determinant_sign);

  /// Forgets the pose.
  void stop() noexcept;

  /// The next sample: one entry a leg. What is not finite changes nothing. No allocation, no exception.
  const TrackedState& update(double time, const JointVector& q) noexcept;

  const TrackedState& state() const noexcept { return state_; }

  /// What the last `update` or `start` crossed.
  const Transitions& transitions() const noexcept { return transitions_; }

 private:
  bool begin_at(double time, const JointVector& q, const Pose& pose);
  void watch_legs(double time, const Pose& pose, const JointVector& q) noexcept;
  void cross(std::size_t leg, double time) noexcept;
  void lose(double time) noexcept;
  void identify_aspect() noexcept;
  void add(const Transition& transition) noexcept;
  Transition from_here(TransitionKind kind, double time) const noexcept;

  std::shared_ptr<const Manipulator> manipulator_;
  TrackerOptions options_;
  std::shared_ptr<const AspectMap> map_;
  TrackedState state_;
  Transitions transitions_;
  TaskVector entry_sines_;                     // at the last point of the path
  double path_time_ = 0.0;                     // of that point
  std::array<double, max_legs> zero_times_{};  // when each B_jj last went through zero
  int last_determinant_sign_ = 0;              // also over times when it was unknown
  int last_aspect_ = 0;                        // also over times when it was unknown
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_TRACKER_H
