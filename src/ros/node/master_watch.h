// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_MASTER_WATCH_H
#define PARALLEL_ASPECTS_ROS_NODE_MASTER_WATCH_H

#include <cstddef>
#include <set>
#include <string>

namespace parallel_aspects {

/// Asks the master whether it still knows the topics and services of this process, and registers those that
/// it has forgotten, as after it was started anew. What is connected stays connected: nothing is shut down.
///
/// Calls of the master may block, so `look` belongs on a thread that has nothing urgent to do.
class MasterWatch {
 public:
  enum class Master {
    present,     ///< knows everything
    forgetful,   ///< did not know everything; what was missing is registered
    unreachable  ///< no answer
  };

  /// Compares once, and logs a message where something has changed since the call before. The first call
  /// shall be made when everything is advertised: of the services, those are known that a master has listed.
  Master look();

 private:
  Master compare();
  void compare_services(const std::set<std::string>& known);
  void count(bool registered);

  std::set<std::string> services_;  ///< of this process, as the master knew them
  Master last_ = Master::present;
  std::size_t registered_ = 0, refused_ = 0;  ///< topics and services, by the last `look`
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_MASTER_WATCH_H
