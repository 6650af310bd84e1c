// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_TRACKER_CORE_H
#define PARALLEL_ASPECTS_TRACKING_TRACKER_CORE_H

#include "parallel_aspects/tracking/tracker.h"
#include "tracking/assembly_modes.h"
#include "tracking/continuation.h"

#include <array>
#include <cstddef>
#include <memory>

namespace parallel_aspects {

/// What a `Tracker` holds and does; the public class only passes on to it, so that clients see no intervals.
class TrackerCore {
 public:
  explicit TrackerCore(std::shared_ptr<const Manipulator> manipulator, const TrackerOptions& options = {});
  void set_map(std::shared_ptr<const AspectMap> map) noexcept;
  bool start(double time, const JointVector& q, const Pose& pose, double tolerance,
             const JointVector& uncertainty = {});
  bool start(double time, const JointVector& q, int determinant_sign, const JointVector& uncertainty = {});
  void stop() noexcept;
  const TrackedState& update(double time, const JointVector& q) noexcept { return update(time, q, {}); }
  const TrackedState& update(double time, const JointVector& q, const JointVector& uncertainty) noexcept;
  const TrackedState& state() const noexcept { return state_; }
  const JointVector& bend() const noexcept { return bend_.allowance(); }
  const Transitions& transitions() const noexcept { return transitions_; }
  Transitions take_transitions() noexcept;
  bool wants_candidates() const noexcept;
  bool find_candidates();
  const Candidates& candidates() const noexcept { return candidates_; }
  void remove_candidate(std::size_t index) noexcept { candidates_.remove(index); }
  bool settle_kept() noexcept;
  void report_residual(double residual, bool contradicts) noexcept;
  void set_reference() noexcept;
  AssemblyComparison compare_with_reference(int max_steps = 4096) const noexcept;

 private:
  void clear() noexcept;
  bool begin_at(double time, const CertifiedPoint& point, int determinant_sign) noexcept;
  bool settle() noexcept;
  bool resume() noexcept;
  void follow(double time, const JointVector& q, const JointVector& bend) noexcept;
  void advance(Continuation& path, double start, double end, int max_steps) noexcept;
  void follow_candidates(const JointVector& q, const JointVector& bend, SampleGap gap) noexcept;
  void watch_legs(const CertifiedPoint& from, const CertifiedPoint& to, double start, double end) noexcept;
  double zero_time(const CertifiedPoint& from, const CertifiedPoint& to, std::size_t leg, double start,
                   double end) const noexcept;
  int next_crossing() const noexcept;
  void cross(std::size_t leg, double time) noexcept;
  void watch_assembly(double time) noexcept;
  double spread() const noexcept;
  void lose(double time, Ambiguity ambiguity) noexcept;
  void become_ambiguous(Ambiguity ambiguity) noexcept;
  int aspect_here() const noexcept;  // 0 where the map cannot decide
  void identify_aspect() noexcept;
  void add(const Transition& transition) noexcept;
  Transition from_here(TransitionKind kind, double time) const noexcept;

  std::shared_ptr<const Manipulator> manipulator_;
  TrackerOptions options_;
  JointVector noise_;  // of the encoders [rad or m]
  PoseCertifier certifier_;
  std::shared_ptr<const AspectMap> map_;
  TrackedState state_;
  Transitions transitions_;
  CertifiedPoint point_;    // of the last sample, while followed
  TaskVector entry_sines_;  // there
  Candidates candidates_;   // while ambiguous
  JointReach reach_;        // since `point_`, until that was tried once
  PathBend bend_;
  JointVector uncertainty_;  // of the last sample
  SampleIntervals intervals_;
  AssemblyWatch assembly_;
  bool mode_changed_ = false;                  // since the reference was set
  std::array<double, max_legs> zero_times_{};  // when each B_jj last went through zero
  int last_determinant_sign_ = 0;              // also over times when it was unknown
  int last_aspect_ = 0;                        // also over times when it was unknown
  int reported_aspect_ = 0;                    // after the last transition
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_TRACKER_CORE_H
