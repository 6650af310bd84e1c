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

// Not where it was lost again by a sample since.
bool AssemblySearch::found() const {
  const auto last =
      std::find_if(transitions_.rbegin(), transitions_.rend(), [](const Transition& transition) {
        return transition.kind == TransitionKind::found || transition.kind == TransitionKind::lost;
      });
  return last != transitions_.rend() && last->kind == TransitionKind::found;
}

void AssemblySearch::keep_transitions() {
  for (const Transition& transition : tracker_.take_transitions()) transitions_.push_back(transition);
}

}  // namespace parallel_aspects
