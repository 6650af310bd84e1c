// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_GUARDED_INPUT_H
#define PARALLEL_ASPECTS_ROS_NODE_GUARDED_INPUT_H

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>

#include <chrono>
#include <string>

namespace parallel_aspects {

/// A queue whose callbacks may throw: that ends the callback, with a line in the log, and not the node. What
/// libraries do on the node's behalf throws for some messages that anybody may send.
class GuardedQueue : public ros::CallbackQueue {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner = 0) override;
};

/// Actionlib's client in Python loses an answer that comes before it has noted its goal.
constexpr std::chrono::milliseconds before_refusal{200};

/// Hears the goals and cancellations of an action and passes them on to its server; what is stamped ahead of
/// the clock is passed on as of now. Actionlib would take such a cancellation for one of every goal to come,
/// such a goal for newer than all that come after it, and throw, also on a thread of its own, when it looks
/// whether the end of time is over. `ActionGoal`: the message of its goals.
template <class ActionGoal>
class CheckedGoals {
 public:
  /// `nh`: where the action is, and whose queue it is served from.
  CheckedGoals(const ros::NodeHandle& nh, const std::string& action);

  /// The handle to give to the action's server, with the same name of the action.
  ros::NodeHandle server_handle() const;

 private:
  template <class Message, class StampOf>
  void pass_on(const std::string& topic, ros::Publisher& publisher, ros::Subscriber& subscriber,
               const StampOf& stamp_of);

  ros::NodeHandle nh_;
  const std::string action_;
  ros::Publisher goals_out_, cancels_out_;
  ros::Subscriber goals_, cancels_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_GUARDED_INPUT_H
