// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ROS_NODE_CLIENT_H
#define PARALLEL_ASPECTS_TEST_ROS_NODE_CLIENT_H

#include <parallel_aspects/Configuration.h>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects::test {

inline constexpr double deadline = 60.0;  // [s]

// Whether `condition` becomes true before the deadline.
inline bool eventually(const std::function<bool()>& condition) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(deadline);
  while (ros::WallTime::now() < end) {
    if (condition()) return true;
    ros::WallDuration(0.005).sleep();
  }
  return condition();
}

// Keeps every message of a topic.
template <typename Message>
class Recorder {
 public:
  explicit Recorder(const std::string& topic)
      : subscriber_(ros::NodeHandle().subscribe<Message>(topic, 10000, [this](const auto& message) {
          const std::lock_guard<std::mutex> lock(mutex_);
          messages_.push_back(*message);
        })) {}

  std::vector<Message> all() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_;
  }
  std::optional<Message> last() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_.empty() ? std::nullopt : std::make_optional(messages_.back());
  }
  // The first message that fits, from the one numbered `start` on.
  std::optional<Message> first(const std::function<bool(const Message&)>& fits, std::size_t start = 0) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto begin = messages_.begin() + static_cast<std::ptrdiff_t>(std::min(start, messages_.size()));
    const auto found = std::find_if(begin, messages_.end(), fits);
    return found == messages_.end() ? std::nullopt : std::make_optional(*found);
  }
  // The answer to what was stamped so, once it is there: the first with that stamp. What the node says later,
  // that nothing came since or of another's message, may bear the same stamp or come in between.
  Message answer(const ros::Time& stamp) const {
    std::optional<Message> answer;
    EXPECT_TRUE(eventually([&] {
      answer = first([&](const Message& message) { return message.header.stamp == stamp; });
      return answer.has_value();
    })) << stamp;
    return answer.value_or(Message());
  }
  bool connected() const { return subscriber_.getNumPublishers() > 0; }

 private:
  mutable std::mutex mutex_;
  std::vector<Message> messages_;
  ros::Subscriber subscriber_;
};

template <typename Service>
typename Service::Response call(const std::string& name, const typename Service::Request& request) {
  const std::string full = name.front() == '/' ? name : "/aspect_node/" + name;
  EXPECT_TRUE(ros::service::waitForService(full, ros::Duration(deadline))) << full;
  Service service;
  service.request = request;
  EXPECT_TRUE(ros::service::call(full, service)) << full;
  return service.response;
}

inline Configuration at_pose(double x, double y, const std::string& frame,
                             const std::vector<std::int8_t>& mode = {}) {
  Configuration configuration;
  configuration.kind = Configuration::POSE;
  configuration.pose.header.frame_id = frame;
  configuration.pose.pose.position.x = x;
  configuration.pose.pose.position.y = y;
  configuration.pose.pose.orientation.w = 1.0;
  configuration.working_mode = mode;
  return configuration;
}

template <typename Service>
typename Service::Response ask(const std::string& name, const Configuration& configuration) {
  typename Service::Request request;
  request.configuration = configuration;
  return call<Service>(name, request);
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_ROS_NODE_CLIENT_H
