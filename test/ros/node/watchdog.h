// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ROS_NODE_WATCHDOG_H
#define PARALLEL_ASPECTS_TEST_ROS_NODE_WATCHDOG_H

#include "ros/node/node_client.h"

#include <ros/time.h>

#include <atomic>
#include <functional>
#include <thread>
#include <utility>

namespace parallel_aspects::test {

/// Ends a node that an input keeps from answering, so that the call that waits for it returns.
class Watchdog {
 public:
  explicit Watchdog(std::function<void()> bite) : bite_(std::move(bite)), thread_([this] { watch(); }) {}
  ~Watchdog() {
    over_ = true;
    thread_.join();
  }
  void feed() { fed_ = ros::WallTime::now().toSec(); }
  bool has_bitten() const { return has_bitten_; }

 private:
  void watch() {
    while (!over_ && !has_bitten_) {
      ros::WallDuration(0.05).sleep();
      if (ros::WallTime::now().toSec() - fed_ < test::deadline) continue;
      has_bitten_ = true;
      bite_();
    }
  }

  const std::function<void()> bite_;
  std::atomic<double> fed_{ros::WallTime::now().toSec()};
  std::atomic<bool> over_{false}, has_bitten_{false};
  std::thread thread_;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_ROS_NODE_WATCHDOG_H
