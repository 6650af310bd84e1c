// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_TRACKER_H
#define PARALLEL_ASPECTS_TRACKING_TRACKER_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/tracking/joint_samples.h"
#include "parallel_aspects/tracking/transitions.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Whether the tracker follows the robot.
enum class TrackStatus {
  uninitialised,  ///< no pose is known yet
  tracking,       ///< the pose belongs to the last sample
  ambiguous,      ///< it is not known which assembly mode the robot is in; `ambiguity` says why
  inconsistent,   ///< followed as while tracking, but measured passive joints contradict the pose
};

/// "uninitialised", "tracking", "ambiguous" or "inconsistent".
const char* name(TrackStatus status) noexcept;

/// What is known of the robot at the time of one joint sample.
struct TrackedState {
  TrackStatus status = TrackStatus::uninitialised;  ///< which of the others are valid
  double time = 0.0;                                ///< of the sample [s]
  JointVector q;                                    ///< of the sample; whole turns may have been added
  Pose pose;                                        ///< valid while tracking or inconsistent
  WorkingMode mode;          ///< valid while tracking or inconsistent; at B_jj = 0 the last mode
  int determinant_sign = 0;  ///< +1 or -1 while tracking or inconsistent
  int aspect = 0;  ///< id in the map; 0 without a map, or too close to a singularity since the last change
  Ambiguity ambiguity = Ambiguity::none;  ///< set while ambiguous
  double residual = 0.0;                  ///< last `report_residual`
  /// How far the platform may be from `pose` where the actuated joints are uncertain: proved [m, RMS over the
  /// anchors].
  double spread = 0.0;

  /// Whether pose, mode and sign are those of the robot.
  bool followed() const noexcept {
    return status == TrackStatus::tracking || status == TrackStatus::inconsistent;
  }
};

/// How a robot is followed.
struct TrackerOptions {
  /// A change of working mode counts once the leg is this far from stretched or folded, as the sine of the
  /// angle at its elbow, |B_jj| / (|u_j| |c_j'|) [0 to 1]: noise about B_jj = 0, and touching it, are no
  /// change.
  double hysteresis = 1e-3;

  SampleOptions samples;  ///< what samples of the actuated joints are taken to mean

  /// Certified subdivisions of one step between samples, for each assembly mode that is followed.
  int max_steps = 256;
};

/// Every problem, a message each; empty when the options can be used.
std::vector<std::string> problems_of(const TrackerOptions& options);

/// Whether a robot is in the assembly mode of a reference configuration: whether actuated joints that go
/// straight back to the reference bring the platform back to its pose.
enum class AssemblyComparison {
  same,    ///< they do
  other,   ///< they bring it to another direct solution, with det A away from zero all along
  unknown  ///< that motion cannot be certified
};

/// "same", "other" or "unknown".
const char* name(AssemblyComparison comparison) noexcept;

class Candidates;
class TrackerCore;

/// An assembly mode that the robot may be in, for as long as the tracker is not changed.
struct PossibleAssemblyMode {
  const Pose& pose;      ///< in the task frame
  const JointVector& q;  ///< of the last sample [rad or m]
  int determinant_sign;  ///< +1 or -1; 0 where that is not proved
  bool followed;         ///< whether its solution is proved; it is dropped with the next sample otherwise
};

/// The assembly modes that the robot may be in, for as long as the tracker is not changed.
class PossibleAssemblyModes {
 public:
  /// A view of the list, which it does not own.
  explicit PossibleAssemblyModes(const Candidates& list) noexcept : list_(list) {}

  std::size_t size() const noexcept;  ///< how many there are

  /// The one at `index`, below `size()`.
  PossibleAssemblyMode operator[](std::size_t index) const noexcept;

  /// Whether the robot must be in one of them, as far as the list of direct solutions was complete and none
  /// was dropped since without a reason.
  bool complete() const noexcept;

 private:
  const Candidates& list_;
};

/// Follows the pose of the platform from the actuated joints alone, by certified continuation of the direct
/// kinematics: between two samples the actuated joints are taken to move straight, and the solution on that
/// path is proved to exist, to be the only one near by and to stay off det A = 0. A step that this cannot be
/// proved of, or that is a gap, ends in `ambiguous`. `find_candidates` then lists the assembly modes that
/// remain possible; each is followed until what is known of the robot leaves one.
///
/// `update` neither allocates nor locks, throws or logs. Not thread-safe; one owner. docs/tracking.md says
/// what is certified.
class Tracker {
 public:
  /// Allocates. The options have no `problems_of`.
  explicit Tracker(std::shared_ptr<const Manipulator> manipulator, const TrackerOptions& options = {});
  Tracker(const Tracker& other);                 ///< an independent tracker in the same state; allocates
  Tracker(Tracker&& other) noexcept;             ///< leaves `other` to be assigned to or destroyed
  Tracker& operator=(const Tracker& other);      ///< as the constructor
  Tracker& operator=(Tracker&& other) noexcept;  ///< as the constructor
  ~Tracker();

  /// From now on aspects are looked up in `map`, which must be of the same manipulator; null for none.
  void set_map(std::shared_ptr<const AspectMap> map) noexcept;

  /// Starts from a pose known to belong to `q`: the direct solution that Newton's method finds from there.
  /// False, and nothing has changed, where that is farther than `tolerance` from the pose [m, RMS over the
  /// anchors], where q or pose are not finite, or where no solution is proved there. False also where a leg
  /// is stretched or folded: then nothing has changed if the robot was followed; if not, the state is
  /// ambiguous, and tracking starts once the leg is not. `uncertainty` as in `update`.
  bool start_near(double time, const JointVector& q, const Pose& pose, double tolerance,
                  const JointVector& uncertainty = {});

  /// Starts in the assembly mode with this sign of det A (+1 or -1), as above. False, and nothing has
  /// changed, unless there is exactly one and it is not near singular. Allocates.
  bool start_with_sign(double time, const JointVector& q, int determinant_sign,
                       const JointVector& uncertainty = {});

  /// Forgets everything but the map: what comes next may be another run.
  void stop() noexcept;

  /// The next sample: one entry a leg. What is not finite changes nothing. No allocation, no exception.
  const TrackedState& update(double time, const JointVector& q) noexcept { return update(time, q, {}); }

  /// Each actuated joint may be as far from its value as `uncertainty` says [rad or m]; empty for 0. All that
  /// is proved holds for every such value, but for the working mode, which is that of `q`.
  const TrackedState& update(double time, const JointVector& q, const JointVector& uncertainty) noexcept;

  const TrackedState& state() const noexcept;  ///< at the last sample

  /// By how much the actuated joints were last taken to leave the straight path between samples [rad or m];
  /// empty where no step was made.
  const JointVector& bend() const noexcept;

  /// What the last `update` or `start` crossed, and what was found out since.
  const Transitions& transitions() const noexcept;

  /// The same, for whoever tells them: none comes twice.
  Transitions take_transitions() noexcept;

  /// Whether `find_candidates` would add to what is known: a sample has come, the pose is not followed, and
  /// there is no complete list of assembly modes.
  bool wants_candidates() const noexcept;

  /// Lists the assembly modes that the last sample allows and starts in the only one if there is but one.
  /// From then on `update` follows each. Allocates; takes up to some 10 ms in SE3, so not for the hot path.
  /// True where tracking has started.
  bool find_candidates();

  /// While ambiguous: the assembly modes that remain possible. The robot is in one of them if
  /// `candidates().complete()`.
  PossibleAssemblyModes candidates() const noexcept;

  /// Drops every candidate of which `keep(pose, q)` is false: by passive joints, their limits, or whatever
  /// else is known of the robot. Tracking starts in the only one left of a complete list. True where it has.
  template <class Keep>
  bool keep_candidates(const Keep& keep) {
    for (std::size_t i = candidates().size(); i-- > 0;)
      if (!keep(candidates()[i].pose, candidates()[i].q)) remove_candidate(i);
    return settle_kept();
  }

  /// What measured passive joints say of the pose: a residual, and whether it contradicts the pose. The state
  /// is `inconsistent` for as long as it does.
  void report_residual(double residual, bool contradicts) noexcept;

  /// From now on `assembly_mode` transitions compare with the present configuration; a start sets it as well.
  void set_reference() noexcept;

  /// Whether the robot is in the assembly mode that it had at the reference; `unknown` unless followed. Takes
  /// up to `max_steps` certified steps; never allocates.
  AssemblyComparison compare_with_reference(int max_steps = 4096) const noexcept;

 private:
  void remove_candidate(std::size_t index) noexcept;
  bool settle_kept() noexcept;

  std::unique_ptr<TrackerCore> core_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_TRACKER_H
