// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/domain_watch.h"

#include <utility>

namespace parallel_aspects {

DomainWatch::DomainWatch(std::shared_ptr<const Uniqueness> uniqueness, double hold)
    : uniqueness_(std::move(uniqueness)), hold_(hold) {}

const DomainState& DomainWatch::update(const Pose& pose, const WorkingMode& mode, double time) {
  state_.changed = false;
  state_.region = uniqueness_->locate(pose, mode);
  if (!state_.region) return state_;
  if (!state_.reference) {
    state_.reference = state_.region;
    since_ = time;
  }
  compare(time);
  last_ = state_.region;
  return state_;
}

// Poses of which no region is known neither begin nor end what the others show.
void DomainWatch::compare(double time) {
  state_.sharing = state_.region == state_.reference
                       ? DomainSharing::shared
                       : uniqueness_->sharing(*state_.region, *state_.reference);
  const bool would_warn = state_.sharing != DomainSharing::shared;
  if (would_warn != std::exchange(would_warn_, would_warn)) {
    since_ = time;
    before_ = last_;
  }
  if (would_warn == state_.warns || time - since_ < hold_) return;
  state_.warns = would_warn;
  state_.changed = true;
  state_.before = before_;
  state_.since = since_;
}

void DomainWatch::restart() {
  state_ = {};
  would_warn_ = false;
  last_ = before_ = std::nullopt;
  since_ = 0.0;
}

}  // namespace parallel_aspects
