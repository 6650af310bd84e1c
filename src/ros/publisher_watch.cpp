// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ros/publisher_watch.h"

#include <algorithm>

namespace parallel_aspects {
namespace {

constexpr std::size_t most_publishers = 16;  // remembered at a time

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
  const Publisher heard{publisher, sequence, false, {}};
  if (publishers_.size() < most_publishers) {
    publishers_.push_back(heard);
    return;
  }
  publishers_[next_to_replace_] = heard;
  next_to_replace_ = (next_to_replace_ + 1) % most_publishers;
}

std::string PublisherWatch::claim(const std::string& publisher, const ros::Time& now) {
  if (Publisher* known = find(publisher)) known->claimed = now;
  for (const Publisher& other : publishers_)
    if (other.name != publisher && !other.claimed.isZero() && now - other.claimed <= alive_)
      return other.name;
  return {};
}

bool PublisherWatch::counted() const noexcept {
  return std::any_of(publishers_.begin(), publishers_.end(),
                     [](const Publisher& publisher) { return publisher.counts; });
}

void PublisherWatch::forget_claims() noexcept {
  for (Publisher& publisher : publishers_) publisher.claimed = ros::Time();
}

}  // namespace parallel_aspects
