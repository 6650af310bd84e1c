// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel/node_finder.h"

#include <parallel_aspects/AspectState.h>

#include <ros/master.h>
#include <ros/message_traits.h>
#include <ros/this_node.h>

#include <XmlRpc.h>
#include <algorithm>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::chrono::milliseconds between_looks(1000);
const std::string state_topic = "/state";

// ros::master::getTopics would wait for a master that is not there.
std::optional<XmlRpc::XmlRpcValue> published_topics() {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  request[1] = "";
  if (!ros::master::execute("getPublishedTopics", request, response, payload, false)) return std::nullopt;
  return payload;
}

std::vector<std::string> nodes_in(XmlRpc::XmlRpcValue& topics) {
  std::vector<std::string> nodes;
  for (int i = 0; i < topics.size(); ++i) {
    const std::string name(topics[i][0]), type(topics[i][1]);
    const bool ends_so = name.size() > state_topic.size() &&
                         name.compare(name.size() - state_topic.size(), state_topic.size(), state_topic) == 0;
    if (ends_so && type == ros::message_traits::datatype<AspectState>())
      nodes.push_back(name.substr(0, name.size() - state_topic.size()));
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace

NodeFinder::NodeFinder() {
  worker_.post([this] {
    do look();
    while (worker_.sleep(between_looks));
  });
}

bool NodeFinder::master_answers() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return master_answers_;
}

std::vector<std::string> NodeFinder::nodes() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return nodes_;
}

void NodeFinder::look() {
  auto topics = published_topics();
  std::vector<std::string> found = topics ? nodes_in(*topics) : std::vector<std::string>();
  const std::lock_guard<std::mutex> lock(mutex_);
  master_answers_ = topics.has_value();
  nodes_ = std::move(found);
}

}  // namespace parallel_aspects
