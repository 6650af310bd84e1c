// SPDX-License-Identifier: BSD-3-Clause
#include "ros/joint_states/publisher_watch.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_publishers = 16;  // remembered at a time

// A jump in `seq` beyond this is a new way of counting, not a loss.
constexpr std::uint32_t longest_loss = 1000000;

}  // namespace

PublisherWatch::Publisher* PublisherWatch::find(const std::string& name) {
  const auto found = std::find_if(publishers_.begin(), publishers_.end(),
                                  [&](const Publisher& publisher) { return publisher.name == name; });
  return found == publishers_.end() ? nullptr : &*found;
}

void PublisherWatch::count(const std::string& publisher, std::uint32_t sequence) {
  if (Publisher* known = find(publisher)) {
    const std::uint32_t step = sequence - known->sequence;  // of unsigned numbers, which wrap as `seq` does
    if (step > 0 && step <= longest_loss) {
      known->counts = true;
      lost_ += step - 1;
    } else {
      known->counts = known->counts && step != 0;
    }
    known->sequence = sequence;
    return;
  }
  const Publisher heard{publisher, sequence, false};
  if (publishers_.size() < max_publishers) {
    publishers_.push_back(heard);
    return;
  }
  publishers_[next_to_replace_] = heard;
  next_to_replace_ = (next_to_replace_ + 1) % max_publishers;
}

bool PublisherWatch::recent(const Turn& turn, const ros::Time& now) const {
  return !turn.at.isZero() && now - turn.at <= alive_;
}

// Two publish the same actuated joint where its publisher changes twice within that time. Once, as when a bag
// is played a second time, is no contest.
Claim PublisherWatch::take_turn(Turns& turns, const std::string& publisher, const ros::Time& now) const {
  const bool changes = turns.last.publisher != publisher;
  const bool contested = changes && recent(turns.last, now) && recent(turns.before, now);
  if (changes) turns.before = std::exchange(turns.last, {publisher, {}});
  turns.last.at = now;
  if (contested) return Claim::contested;
  return recent(turns.before, now) ? Claim::waiting : Claim::sole;
}

Claim PublisherWatch::claim(const std::string& publisher, const JointSet& named_joints, const ros::Time& now,
                            std::string& other) {
  Claim worst = Claim::sole;
  other.clear();
  for (std::size_t actuation = 0; actuation < named_joints.size(); ++actuation) {
    if (!named_joints[actuation]) continue;
    const Claim claim = take_turn(turns_[actuation], publisher, now);
    if (claim <= worst) continue;
    worst = claim;
    other = turns_[actuation].before.publisher;
  }
  return worst;
}

bool PublisherWatch::counted() const noexcept {
  return std::any_of(publishers_.begin(), publishers_.end(),
                     [](const Publisher& publisher) { return publisher.counts; });
}

void PublisherWatch::forget_claims() noexcept { turns_.fill({}); }

}  // namespace parallel_aspects
