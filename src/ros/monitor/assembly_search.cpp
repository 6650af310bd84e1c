// SPDX-License-Identifier: BSD-3-Clause
//
// How the monitor finds the assembly mode of a robot that is not followed, without its lock while it looks.
#include "ros/monitor/assembly_search.h"

#include "ros/messages/configurations.h"
#include "ros/monitor/robot_monitor.h"

#include <algorithm>
#include <optional>
#include <utility>

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

namespace {

// Samples that are followed while others wait. There are fewer each time, since they are followed faster than
// they come; where they are not, they are taken as they are after so many rounds.
constexpr std::size_t samples_at_once = 4;
constexpr int most_rounds = 10;

}  // namespace

std::optional<AssemblySearch> RobotMonitor::begin_search() {
  const std::lock_guard<std::mutex> lock(mutex_);
  hazards_.forget_measured();
  if (age_.stamp().isZero() || tracker_.state().followed()) return std::nullopt;
  keep_transitions();
  meanwhile_.begin();
  return AssemblySearch(tracker_, readings_);
}

void RobotMonitor::take(AssemblySearch search) {
  for (int round = 0;; ++round) {
    std::unique_lock<std::mutex> lock(mutex_);
    if (!meanwhile_.valid()) return;
    const bool all = meanwhile_.size() <= samples_at_once || round == most_rounds;
    const std::vector<TrackedSample> samples = meanwhile_.take();
    if (!all) lock.unlock();
    search.follow(samples);
    if (all) return use(search);
  }
}

// With the lock, after all samples.
void RobotMonitor::use(AssemblySearch& search) {
  meanwhile_.end();
  tracker_ = std::move(search.tracker());
  residual_ = search.residual();
  note_start(search.found() ? Beginning::found : Beginning::followed);
  for (const Transition& transition : search.transitions()) keep(transition);
}

void RobotMonitor::look_for_assembly_mode() {
  std::optional<AssemblySearch> search = begin_search();
  if (!search) return;
  search->run(passive_);
  take(std::move(*search));
}

std::optional<AssemblyCandidates> RobotMonitor::new_candidates() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool followed = tracker_.state().followed();
  const auto& list = tracker_.candidates();
  const std::size_t count = followed ? 0 : list.size();
  if (count == reported_candidates_) return std::nullopt;
  reported_candidates_ = count;
  return candidates_message(*mechanism_->manipulator(), tracker_.state(), list, age_.stamp());
}

}  // namespace parallel_aspects
