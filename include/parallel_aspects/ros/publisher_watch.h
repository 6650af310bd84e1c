// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PUBLISHER_WATCH_H
#define PARALLEL_ASPECTS_ROS_PUBLISHER_WATCH_H

#include <ros/duration.h>
#include <ros/time.h>

#include <cstdint>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Who publishes joint_states, and how many messages were lost on the way, by gaps in the `seq` that each
/// publisher counts up.
class PublisherWatch {
 public:
  /// `alive`: for how long a publisher that was heard counts as one that publishes.
  explicit PublisherWatch(const ros::Duration& alive) : alive_(alive) {}

  /// A message of any robot came.
  void count(const std::string& publisher, std::uint32_t sequence);

  /// It names the drives of this robot. Name of another publisher that did so a short while ago, or empty.
  std::string claim(const std::string& publisher, const ros::Time& now);

  /// Messages that did not arrive since the start.
  std::uint64_t lost() const noexcept { return lost_; }

  /// Whether any publisher counts its messages, so that losses show.
  bool counted() const noexcept;

  /// Forgets who published the drives.
  void forget_claims() noexcept;

 private:
  struct Publisher {
    std::string name;
    std::uint32_t sequence = 0;
    bool counts = false;
    ros::Time claimed;  // zero for never
  };
  Publisher* find(const std::string& name);

  const ros::Duration alive_;
  std::vector<Publisher> publishers_;
  std::size_t next_to_replace_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PUBLISHER_WATCH_H
