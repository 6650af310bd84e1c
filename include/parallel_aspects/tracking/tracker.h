// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_TRACKER_H
#define PARALLEL_ASPECTS_TRACKING_TRACKER_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
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

/// Whether velocity limits bound how far any actuated joint can have moved in a time.
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

/// What a transition changes.
enum class TransitionKind {
  working_mode,  ///< B_jj of `leg` went through zero
  aspect,        ///< the aspect became known, or a start found the robot in another one than before
  lost,  ///< the assembly mode is not known from here on; `determinant` where det A came too near zero
  assembly_mode,  ///< the actuated joints are back where they were at the reference, the platform at another
                  ///< direct solution, and det A never vanished in between
  found,          ///< it was lost, and is proved to be the same: wherever the actuated joints can have been
                  ///< meanwhile, they tell the pose
};

/// "working mode", "aspect", "lost", "assembly mode" or "found".
const char* name(TransitionKind kind) noexcept;

/// Why the assembly mode is not known.
enum class Ambiguity {
  none,
  near_parallel_singularity,  ///< the last step came too near to det A = 0 to be certified
  gap,                        ///< the last step was longer than the velocity limits allow
  silence,                    ///< more than the longest interval went by between the last two samples
  pause,                      ///< many times the usual interval went by between them
  half_turn,                  ///< so long a time that an actuated joint may have turned by half a turn
  step_budget,                ///< the last step needed more subdivisions than allowed
  several_assembly_modes,     ///< the actuated joints can be assembled in several ways
  serial_singularity,         ///< a leg is stretched or folded where tracking would start
  no_direct_solution,         ///< the actuated joints cannot be assembled
  no_candidate_fits,          ///< what is measured or was stated contradicts every candidate
};

/// A clause for people, such as "the step came too near to det A = 0"; empty for none.
const char* reason(Ambiguity ambiguity) noexcept;

/// One change of working mode, aspect or assembly mode.
struct Transition {
  TransitionKind kind = TransitionKind::working_mode;  ///< what changed
  double time = 0.0;                      ///< of the crossing, interpolated between two samples [s]
  std::size_t leg = 0;                    ///< whose B_jj crossed zero, for a change of working mode
  bool determinant = false;               ///< whether det A lost its sign, or has another one than before
  Ambiguity ambiguity = Ambiguity::none;  ///< of a loss, and where it is made good: why it was lost
  bool inside_aspect = false;  ///< for a change of assembly mode: no working mode has changed either since
                               ///< the reference, so that both solutions are in one aspect
  bool first_again = false;  ///< for a change of assembly mode: the platform is at the direct solution again
                             ///< that was the reference at first
  WorkingMode mode_before;   ///< one sign a leg
  WorkingMode mode_after;    ///< one sign a leg
  int determinant_sign_before = 0;  ///< +1 or -1; 0 while unknown
  int determinant_sign_after = 0;   ///< +1 or -1; 0 while unknown
  int aspect_before = 0;            ///< id in the map; 0 while unknown
  int aspect_after = 0;             ///< id in the map; 0 while unknown
};

/// Transitions of one update, in the order in which they were certain; the zero of a leg that is slow to come
/// past the hysteresis can be earlier than that of the one before.
struct Transitions {
  static constexpr std::size_t most = 16;  ///< a step that crosses more often ends with `dropped`
  std::array<Transition, most> items;      ///< the first `count` are valid
  std::size_t count = 0;                   ///< 0 to `most`
  bool dropped = false;                    ///< more happened than there was room for

  const Transition* begin() const noexcept { return items.data(); }        ///< the earliest
  const Transition* end() const noexcept { return items.data() + count; }  ///< behind the latest
  bool empty() const noexcept { return count == 0; }                       ///< nothing has changed
};

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
/// `update` neither allocates nor locks, throws or logs. Not thread-safe; one owner. docs/theory/tracking.md
/// says what is certified.
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

  /// Drops every candidate of which `keep(pose, q)` is false: by passive joints, their limits, or what
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

class PoseCertifier;

/// How near det A = 0 noise of the encoders lets the assembly mode be determined. Where two assembly modes
/// meet, the actuated joints distinguish them by the square of the distance only, so that the stand-off grows
/// with the square root of the noise. Once it is made it never allocates, never throws.
class StandOff {
 public:
  /// For samples with the noise and the bend of these options. Allocates.
  StandOff(std::shared_ptr<const Manipulator> manipulator, const SampleOptions& options);

  /// Whether a robot that stands still at `pose` in `mode` is followed, whatever the encoders say within
  /// their noise: proved for the noise that is worst to first order. `bend`: what the actuated joints were
  /// last taken to leave the straight path between samples by [rad or m]; empty where that is not known.
  bool can_distinguish(const Pose& pose, const WorkingMode& mode,
                       const JointVector& bend = {}) const noexcept;

  /// An estimate of how far from `singular`, a pose with det A = 0, the robot must stay for that, on the
  /// straight path from `pose` [m, root mean square over the anchors]. The whole way where noise hides
  /// the mode at `pose` itself.
  double along_path(const Pose& pose, const Pose& singular, const WorkingMode& mode,
                    const JointVector& bend = {}) const noexcept;

 private:
  std::shared_ptr<const Manipulator> manipulator_;
  std::shared_ptr<const PoseCertifier> certifier_;
  JointVector noise_;         // [rad or m]
  JointVector resting_bend_;  // what noise alone makes of `path_bend` [rad or m]
};

/// The largest stand-off that was found.
struct StandOffEstimate {
  double largest = 0.0;  ///< [m]
  Pose at;               ///< the pose with det A = 0 that asks for it
  int poses = 0;         ///< with det A = 0 that were examined
};

/// The largest stand-off of as many poses with det A = 0, next to seeded random configurations: an estimate
/// from below, as others may ask for more. It ends early, with what it has, where `goes_on` says no.
/// Allocates.
StandOffEstimate estimate_stand_off(
    const std::shared_ptr<const Manipulator>& manipulator, const SampleOptions& options, int poses,
    const std::function<bool()>& goes_on = [] { return true; });

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_TRACKER_H
