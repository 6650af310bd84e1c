// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_GUARDED_QUEUE_H
#define PARALLEL_ASPECTS_ROS_NODE_GUARDED_QUEUE_H

#include <ros/callback_queue.h>

namespace parallel_aspects {

/// A queue whose callbacks may throw: that ends the callback, with a line in the log, and not the node. What
/// libraries do on the node's behalf throws for some messages that anybody may send.
class GuardedQueue : public ros::CallbackQueue {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner = 0) override;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_GUARDED_QUEUE_H
