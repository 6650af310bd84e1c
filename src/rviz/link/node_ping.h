// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_LINK_NODE_PING_H
#define PARALLEL_ASPECTS_RVIZ_LINK_NODE_PING_H

#include "rviz/link/background_worker.h"
#include <atomic>
#include <string>

namespace parallel_aspects {

/// Whether an aspect_node can be reached, asked once a second in a thread of its own. A node that was killed
/// is still a publisher for the master and for roscpp, which goes on trying to reach it.
class NodePing {
 public:
  /// `node`: its full name.
  explicit NodePing(const std::string& node);

  bool answers() const noexcept { return answers_; }

 private:
  std::atomic<bool> answers_{false};
  BackgroundWorker worker_;  // ends first
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_LINK_NODE_PING_H
