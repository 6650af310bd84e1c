// SPDX-License-Identifier: BSD-3-Clause
//
// How the monitor follows in which uniqueness domains the robot is, from where tracking began.
#include "ros/messages/hazard_messages.h"
#include "ros/monitor/robot_monitor.h"

#include <optional>
#include <utility>

namespace parallel_aspects {

void RobotMonitor::set_domains(const KnownDomains& known) {
  if (!domains_.use(known)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  uniqueness_ = unknown_domains(known.known);
}

UniquenessState RobotMonitor::uniqueness() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return tracking_start_ ? uniqueness_ : unknown_domains(uniqueness_.known);
}

// Where tracking began, or the assembly mode was stated since. It begins anew after a loss, but where the
// assembly mode was found to be the same.
void RobotMonitor::note_start(Beginning how) {
  const TrackedState& tracked = tracker_.state();
  if (!tracked.followed()) {
    if (tracking_start_) lost_start_ = std::exchange(tracking_start_, std::nullopt);
    return;
  }
  if (tracking_start_ && how != Beginning::stated) return;
  const auto lost = std::exchange(lost_start_, std::nullopt);
  if (lost && how == Beginning::found) {
    tracking_start_ = lost;
    return;
  }
  tracking_start_ = TrackingStart{++tracking_starts_, tracked.pose, tracked.mode, tracked.time, epoch_};
  uniqueness_ = unknown_domains(uniqueness_.known);
}

void RobotMonitor::fill_domains(AspectState& state) const {
  state.uniqueness = uniqueness_;
  if (!uniqueness_.warns || (state.level != AspectState::CLEAR && state.level != AspectState::NO_THRESHOLD))
    return;
  state.level = level_message(level_of(hazards_.findings().threshold, uniqueness_));
  state.reason += (state.reason.empty() ? "" : "; ") + warning_of(uniqueness_);
}

// Without the lock while it looks. What was found of a start that is no longer the last is dropped.
void RobotMonitor::look_for_domain(const TrackedState& tracked, const TrackingStart& start) {
  if (!domains_.look(tracked, start)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!tracking_start_ || tracking_start_->number != start.number) return;
  uniqueness_ = domains_.state();
  if (const auto& transition = domains_.transition()) transitions_.push_back(*transition);
}

}  // namespace parallel_aspects
