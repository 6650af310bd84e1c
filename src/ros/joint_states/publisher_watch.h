// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_JOINT_STATES_PUBLISHER_WATCH_H
#define PARALLEL_ASPECTS_ROS_JOINT_STATES_PUBLISHER_WATCH_H

#include "parallel_aspects/model/pose.h"

#include <ros/duration.h>
#include <ros/time.h>

#include <array>
#include <bitset>
#include <cstdint>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Which of the actuated joints of a robot, in the order of its legs.
using JointSet = std::bitset<max_legs>;

/// What a message of one publisher is worth: only one that is `sole` is to be believed.
enum class Claim {
  sole,      ///< nobody else published these actuated joints within the time in which a publisher is alive
  waiting,   ///< another one did, who may have ended: it is not known yet whether both publish
  contested  ///< both publish, by turns
};

/// Who publishes joint_states, and how many messages were lost on the path, by gaps in the `seq` that each
/// publisher counts up.
class PublisherWatch {
 public:
  /// `alive`: for how long a publisher that was heard counts as one that publishes.
  explicit PublisherWatch(const ros::Duration& alive) : alive_(alive) {}

  /// A message of any robot came.
  void count(const std::string& publisher, std::uint32_t sequence);

  /// It holds these actuated joints of this robot. `other` becomes the name of another publisher that did so
  /// within that time, or empty.
  Claim claim(const std::string& publisher, const JointSet& named_joints, const ros::Time& now,
              std::string& other);

  /// Messages that did not arrive since the start.
  std::uint64_t lost() const noexcept { return lost_; }

  /// Whether any publisher counts its messages, so that losses show.
  bool counted() const noexcept;

  /// Forgets who published the actuated joints.
  void forget_claims() noexcept;

 private:
  struct Publisher {
    std::string name;
    std::uint32_t sequence = 0;
    bool counts = false;
  };
  /// Who published something last, and when; zero for never.
  struct Turn {
    std::string publisher;
    ros::Time at;
  };
  /// The last turn of one actuated joint, and the last of any other publisher: however many there are,
  /// whether another one is alive takes no more.
  struct Turns {
    Turn last, before;
  };
  Publisher* find(const std::string& name);
  Claim take_turn(Turns& turns, const std::string& publisher, const ros::Time& now) const;
  bool recent(const Turn& turn, const ros::Time& now) const;

  const ros::Duration alive_;
  std::vector<Publisher> publishers_;
  std::size_t next_to_replace_ = 0;
  std::uint64_t lost_ = 0;
  std::array<Turns, max_legs> turns_;  // by actuated joint
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_JOINT_STATES_PUBLISHER_WATCH_H
