// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_DOMAIN_WATCH_H
#define PARALLEL_ASPECTS_TRACKING_DOMAIN_WATCH_H

#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace parallel_aspects {

/// What a `DomainWatch` knows after a pose.
struct DomainState {
  std::optional<std::size_t> region;     ///< basic region of the pose; nothing where that is not proved
  std::optional<std::size_t> reference;  ///< of the first pose of which one was proved
  /// Of the last region that was proved and the reference; `unknown` while there is none.
  DomainSharing sharing = DomainSharing::unknown;
  /// No uniqueness domain of the list holds both, for some time: the actuated joints alone no longer
  /// determine which direct solution the robot is at for who knew it at the reference.
  bool warns = false;
  bool changed = false;  ///< `warns` changed with this pose
  /// Where that began which `warns` shows since it last changed: the last region before it, and the time of
  /// the first pose behind it [s].
  std::optional<std::size_t> before;
  double since = 0.0;
};

/// Compares where a robot is with where it was known for certain: whether one uniqueness domain holds both,
/// and with hysteresis when to warn. Where each aspect is a uniqueness domain as a whole it never warns.
class DomainWatch {
 public:
  /// `uniqueness` is of the robot that is watched; not null. `hold`: how long what is compared must have come
  /// out the same before the warning begins or ends [s], not negative.
  explicit DomainWatch(std::shared_ptr<const Uniqueness> uniqueness, double hold = 0.1);

  /// The next pose, in its working mode, at this time [s], which is not before that of the last one.
  const DomainState& update(const Pose& pose, const WorkingMode& mode, double time);

  const DomainState& state() const noexcept { return state_; }  ///< after the last pose

  /// The next pose of which a region is proved is the reference, as where tracking begins.
  void restart();

 private:
  void compare(double time);

  std::shared_ptr<const Uniqueness> uniqueness_;
  double hold_;
  DomainState state_;
  bool would_warn_ = false;                   // by the last comparison
  std::optional<std::size_t> last_, before_;  // regions that were proved: the last, and that before `since_`
  double since_ = 0.0;                        // when it first came out so
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_DOMAIN_WATCH_H
