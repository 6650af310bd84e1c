// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/assembly_search.h"

#include <algorithm>

namespace parallel_aspects {

void AssemblySearch::run(const PassiveJoints& passive) {
  if (tracker_.wants_candidates()) tracker_.find_candidates();
  residual_ = passive.apply(readings_, tracker_);
  keep_transitions();
}

void AssemblySearch::follow(const std::vector<TrackedSample>& samples) {
  for (const TrackedSample& sample : samples) {
    tracker_.update(sample.time, sample.q, sample.uncertainty);
    keep_transitions();
  }
}

bool AssemblySearch::found() const {
  return std::any_of(transitions_.begin(), transitions_.end(),
                     [](const Transition& transition) { return transition.kind == TransitionKind::found; });
}

void AssemblySearch::keep_transitions() {
  for (const Transition& transition : tracker_.take_transitions()) transitions_.push_back(transition);
}

}  // namespace parallel_aspects
