// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/guarded_input.h"

#include <parallel_aspects/ComputeMapActionGoal.h>
#include <parallel_aspects/PlanPathActionGoal.h>

#include <boost/make_shared.hpp>
#include <ros/console.h>

#include <actionlib_msgs/GoalID.h>
#include <algorithm>
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

namespace {

std::string passed_on(const std::string& topic) { return topic + "_checked"; }

}  // namespace

template <class ActionGoal>
CheckedGoals<ActionGoal>::CheckedGoals(const ros::NodeHandle& nh, const std::string& action)
    : nh_(nh), action_(nh.resolveName(action)) {
  pass_on<ActionGoal>(
      action_ + "/goal", goals_out_, goals_, [](ActionGoal & goal) -> auto& { return goal.goal_id.stamp; });
  pass_on<actionlib_msgs::GoalID>(
      action_ + "/cancel", cancels_out_, cancels_,
      [](actionlib_msgs::GoalID & goal) -> auto& { return goal.stamp; });
}

template <class ActionGoal>
ros::NodeHandle CheckedGoals<ActionGoal>::server_handle() const {
  ros::M_string names;
  for (const std::string& topic : {action_ + "/goal", action_ + "/cancel"}) names[topic] = passed_on(topic);
  return ros::NodeHandle(nh_, "", names);
}

template <class ActionGoal>
template <class Message, class StampOf>
void CheckedGoals<ActionGoal>::pass_on(const std::string& topic, ros::Publisher& publisher,
                                       ros::Subscriber& subscriber, const StampOf& stamp_of) {
  publisher = nh_.advertise<Message>(passed_on(topic), 50);
  const boost::function<void(const boost::shared_ptr<const Message>&)> callback =
      [&publisher, stamp_of](const boost::shared_ptr<const Message>& heard) {
        Message message = *heard;
        ros::Time& stamp = stamp_of(message);
        stamp = std::min(stamp, ros::Time::now());
        publisher.publish(message);
      };
  subscriber = nh_.subscribe<Message>(topic, 50, callback);
}

template class CheckedGoals<ComputeMapActionGoal>;
template class CheckedGoals<PlanPathActionGoal>;

}  // namespace parallel_aspects
