// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/guarded_queue.h"

#include <boost/make_shared.hpp>
#include <ros/console.h>

#include <exception>
#include <utility>

namespace parallel_aspects {
namespace {

class GuardedCallback : public ros::CallbackInterface {
 public:
  explicit GuardedCallback(ros::CallbackInterfacePtr callback) : callback_(std::move(callback)) {}

  CallResult call() override {
    try {
      return callback_->call();
    } catch (const std::exception& failure) {
      ROS_ERROR_STREAM_THROTTLE(1.0, "A message could not be dealt with: " << failure.what());
      return Success;
    }
  }

  bool ready() override { return callback_->ready(); }

 private:
  const ros::CallbackInterfacePtr callback_;
};

}  // namespace

void GuardedQueue::addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) {
  ros::CallbackQueue::addCallback(boost::make_shared<GuardedCallback>(callback), owner);
}

}  // namespace parallel_aspects
