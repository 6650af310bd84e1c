// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/master_watch.h"

#include <ros/connection_manager.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/service_manager.h>
#include <ros/this_node.h>
#include <ros/time.h>
#include <ros/xmlrpc_manager.h>

#include <XmlRpc.h>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

using XmlRpc::XmlRpcValue;
using Types = std::map<std::string, std::string>;  // of topics, by name

const ros::WallDuration patience_with_self(2.0);

std::string own_address() { return ros::XMLRPCManager::instance()->getServerURI(); }

XmlRpcValue request_with(const std::string& first, const std::string& second = {},
                         const std::string& third = {}) {
  XmlRpcValue request;
  request[0] = ros::this_node::getName();
  if (!first.empty()) request[1] = first;
  if (!second.empty()) request[2] = second;
  if (!third.empty()) request[3] = third;
  return request;
}

std::optional<XmlRpcValue> ask_master(const std::string& method, const XmlRpcValue& request) {
  XmlRpcValue response, payload;
  if (!ros::master::execute(method, request, response, payload, false)) return std::nullopt;
  return payload;
}

// While this process shuts down its own connections are still open, but nobody serves them.
std::optional<XmlRpcValue> answer_of(XmlRpc::XmlRpcClient& client, const std::string& method,
                                     const XmlRpcValue& request) {
  if (!client.executeNonBlock(method.c_str(), request)) return std::nullopt;
  XmlRpc::XmlRpcDispatch dispatch;
  dispatch.addSource(&client, XmlRpc::XmlRpcDispatch::WritableEvent | XmlRpc::XmlRpcDispatch::Exception);
  const ros::WallTime end = ros::WallTime::now() + patience_with_self;
  XmlRpcValue answer;
  bool answered = client.executeCheckDone(answer);
  while (!answered && !ros::isShuttingDown() && ros::WallTime::now() < end) {
    dispatch.work(0.01);
    answered = client.executeCheckDone(answer);
  }
  dispatch.removeSource(&client);
  return answered ? std::make_optional(answer) : std::nullopt;
}

// Asks this process itself, in the way in which other nodes do; roscpp has no other for the types of topics.
std::optional<XmlRpcValue> ask_self(const std::string& method, const XmlRpcValue& request) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(own_address(), host, port)) return std::nullopt;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  auto answer = answer_of(client, method, request);
  if (!answer || answer->getType() != XmlRpcValue::TypeArray || answer->size() < 3) return std::nullopt;
  return (*answer)[2];
}

std::optional<Types> own_topics(const std::string& method) {
  auto answer = ask_self(method, request_with({}));
  if (!answer || answer->getType() != XmlRpcValue::TypeArray) return std::nullopt;
  Types topics;
  for (int i = 0; i < answer->size(); ++i)
    topics.emplace(static_cast<std::string>((*answer)[i][0]), static_cast<std::string>((*answer)[i][1]));
  return topics;
}

// Names that the master lists with this node, in one of the three parts of its state.
std::set<std::string> names_known(XmlRpcValue& part) {
  std::set<std::string> names;
  const std::string node = ros::this_node::getName();
  for (int i = 0; i < part.size(); ++i)
    for (int j = 0; j < part[i][1].size(); ++j)
      if (static_cast<std::string>(part[i][1][j]) == node) names.insert(static_cast<std::string>(part[i][0]));
  return names;
}

bool register_publisher(const std::string& topic, const std::string& type) {
  return ask_master("registerPublisher", request_with(topic, type, own_address())).has_value();
}

// The publishers that the new master knows already are connected as if it had told of them.
bool register_subscriber(const std::string& topic, const std::string& type) {
  const auto publishers = ask_master("registerSubscriber", request_with(topic, type, own_address()));
  if (!publishers) return false;
  XmlRpcValue update = request_with(topic);
  update[2] = *publishers;
  return publishers->size() == 0 || ask_self("publisherUpdate", update).has_value();
}

bool register_service(const std::string& name) {
  const std::string address = "rosrpc://" + ros::network::getHost() + ":" +
                              std::to_string(ros::ConnectionManager::instance()->getTCPPort());
  return ask_master("registerService", request_with(name, address, own_address())).has_value();
}

}  // namespace

void MasterWatch::count(bool registered) { ++(registered ? registered_ : refused_); }

// roscpp does not list its services, so those that a master has listed are remembered.
void MasterWatch::compare_services(const std::set<std::string>& known) {
  services_.insert(known.begin(), known.end());
  for (auto name = services_.begin(); name != services_.end();) {
    const bool served = ros::ServiceManager::instance()->lookupServicePublication(*name) != nullptr;
    if (served && known.count(*name) == 0) count(register_service(*name));
    name = served ? std::next(name) : services_.erase(name);
  }
}

MasterWatch::Master MasterWatch::compare() {
  registered_ = refused_ = 0;
  const auto published = own_topics("getPublications");
  const auto subscribed = own_topics("getSubscriptions");
  auto state = ask_master("getSystemState", request_with({}));
  if (!published || !subscribed || !state || state->size() != 3) return Master::unreachable;
  const std::set<std::string> known_published = names_known((*state)[0]);
  const std::set<std::string> known_subscribed = names_known((*state)[1]);
  compare_services(names_known((*state)[2]));
  for (const auto& [topic, type] : *published)
    if (known_published.count(topic) == 0) count(register_publisher(topic, type));
  for (const auto& [topic, type] : *subscribed)
    if (known_subscribed.count(topic) == 0) count(register_subscriber(topic, type));
  if (refused_ > 0) return Master::unreachable;
  return registered_ > 0 ? Master::forgetful : Master::present;
}

// An answer that is not of the form of the ROS API is none.
MasterWatch::Master MasterWatch::look() {
  Master now = Master::unreachable;
  try {
    now = compare();
  } catch (const XmlRpc::XmlRpcException&) {
    now = Master::unreachable;
  }
  if (!ros::ok()) return last_;
  if (now == Master::unreachable && last_ != now)
    ROS_WARN("The ROS master does not answer. What is connected goes on, and the node looks for it again.");
  if (now == Master::forgetful)
    ROS_WARN_STREAM("The ROS master did not know this node any more, as after a restart: "
                    << registered_ << " topics and services were registered again.");
  if (now == Master::present && last_ == Master::unreachable) ROS_INFO("The ROS master answers again.");
  return last_ = now;
}

}  // namespace parallel_aspects
