// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_PANEL_NODE_FINDER_H
#define PARALLEL_ASPECTS_RVIZ_PANEL_NODE_FINDER_H

#include "rviz/link/background_worker.h"
#include <mutex>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Which nodes of this package run: those that publish an AspectState named "state". Asks the master again
/// and again, on a thread of its own.
class NodeFinder {
 public:
  NodeFinder();

  bool master_answers() const;
  std::vector<std::string> nodes() const;  ///< their names, sorted

 private:
  void look();

  mutable std::mutex mutex_;
  bool master_answers_ = true;
  std::vector<std::string> nodes_;
  BackgroundWorker worker_;  // last, so that it ends first
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_PANEL_NODE_FINDER_H
