// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_GUARD_HAZARD_JUDGE_H
#define PARALLEL_ASPECTS_MOTION_GUARD_HAZARD_JUDGE_H

#include "motion/guard/clear_region.h"
#include "motion/guard/issued_motion.h"
#include "parallel_aspects/motion/motion_guard.h"

#include <array>
#include <cstddef>
#include <memory>

namespace parallel_aspects {

/// How far one hazard lets a command go.
struct HazardVerdict {
  double scale = 0.0;   ///< of the command: it, and every smaller one, is proved
  bool inside = false;  ///< the robot is not proved to be outside of the threshold
  bool escape = false;  ///< and the command leads away
  bool nearer = false;  ///< the command goes towards a half space that the robot is too near to
};

/// How far commands may go before the robot comes too near to hazards; docs/theory/guard.md has the proof.
/// Neither allocates nor throws once it is made.
class HazardJudge {
 public:
  /// Allocates.
  HazardJudge(std::shared_ptr<const Manipulator> manipulator, const GuardOptions& options);

  /// Whether the metric sees every motion of the platform.
  bool usable() const noexcept { return region_->usable(); }

  /// How long the robot takes to stop from a twist [s].
  double braking_time(const TaskVector& twist) const noexcept;

  /// A command after those that were issued, at `time`. Needs a live `RoundingUpward`, as the next does.
  void look_ahead(const TrackedState& state, const IssuedMotion& issued, const TaskVector& twist,
                  double time) noexcept;

  /// What one hazard makes of that command, whose actuated joints move from `q` at `rates`. `distance`: of
  /// the hazard, proved; `stop`: the threshold [m].
  HazardVerdict judge(Hazard hazard, double stop, double distance, const JointVector& q,
                      const JointVector& rates) noexcept;

  /// Begins anew.
  void forget() noexcept { reaches_.fill(0.0); }

  /// A bound of a distance that was proved at `from`, at `to` [m].
  double after_motion(double distance, const Pose& from, const Pose& to) const noexcept;

 private:
  // A command as the metric sees it.
  struct Motion {
    MetricSpeed speed;
    double seconds = 0.0, brake = 0.0;
    bool may_begin_yet = false;
  };

  // Speeds in one direction, 0 or more; of commands that were merged there are several.
  struct SpeedRange {
    double least, most;
    double range() const noexcept { return most - least; }
  };

  // What is about to happen, the commands before the new one and that.
  struct Prospect {
    std::array<Motion, IssuedMotion::most> before;
    std::size_t count = 0;
    Motion command;
    double spread = 0.0;
  };

  // What one hazard is judged by.
  struct Vicinity {
    Hazard hazard;
    double stop, known;  // distances: the threshold, and what is proved
    const JointVector &q, &rates;
  };

  template <class Of>
  double pending_travel(const Of& of) const noexcept;
  template <class Of>
  StoppingMotion stopping(const Of& of) const noexcept;
  template <class Of>
  double travel_up_to(double scale, const Of& of) const noexcept;
  static SpeedRange path_of(const MetricSpeed& speed) noexcept;
  static SpeedRange turn_of(const MetricSpeed& speed) noexcept;

  double slack() const noexcept;

  void look_about(const Vicinity& vicinity, double reach, HazardVerdict& best) const noexcept;
  void look_for_escape(const Vicinity& vicinity, double reach, HazardVerdict& best) const noexcept;
  bool is_ahead_clear(const Vicinity& vicinity, double radius) const noexcept;
  HazardVerdict judge_within(const Vicinity& vicinity, double reach, double stop,
                             bool known_outside) const noexcept;
  void judge_half_space(const ClearHalfSpace& half_space, double spare, double stop, bool known_outside,
                        HazardVerdict& verdict) const noexcept;
  bool is_beyond(const ClearHalfSpace& half_space, const JointVector& q) const noexcept;
  void turn_back(const JointVector& q, const JointVector& rates, HazardVerdict& verdict) const noexcept;

  std::shared_ptr<const Manipulator> manipulator_;
  GuardOptions options_;
  std::unique_ptr<ClearRegion> region_;
  IssuedMotion::Pending pending_;
  Prospect prospect_;
  std::array<double, hazard_count> reaches_{};  // what was last proved, by `Hazard`; 0 for nothing yet
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_GUARD_HAZARD_JUDGE_H
