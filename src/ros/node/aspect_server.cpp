// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/aspect_server.h"

#include "parallel_aspects/model/problems.h"

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
#include <XmlRpcValue.h>
#include <cstdint>
#include <exception>
#include <iterator>
#include <map>
#include <optional>
#include <string>
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

// While this process shuts down, its own connections are still open, but not served.
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

// The publishers that the new master knows already are connected as if it had reported them.
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
    ROS_WARN("The ROS master does not answer. What is connected goes on, and the node tries again.");
  if (now == Master::forgetful)
    ROS_WARN_STREAM("The ROS master did not know this node any more, as after a restart: "
                    << registered_ << " topics and services were registered again.");
  if (now == Master::present && last_ == Master::unreachable) ROS_INFO("The ROS master answers again.");
  return last_ = now;
}

namespace {

const ros::WallDuration between_looks(2.0);  // at the master

/// Keeps the parameters that a robot sets to what is in force as they were asked for: the next reload reads
/// them.
class AskedParameters {
 public:
  explicit AskedParameters(const ros::NodeHandle& private_nh) : private_nh_(private_nh) {
    for (const char* group : {"thresholds", "display"}) {
      XmlRpc::XmlRpcValue value;
      groups_[group] = private_nh_.getParam(group, value) ? std::make_optional(value) : std::nullopt;
    }
  }
  ~AskedParameters() {
    for (const auto& [group, value] : groups_)
      if (value)
        private_nh_.setParam(group, *value);
      else
        private_nh_.deleteParam(group);
  }
  AskedParameters(const AskedParameters&) = delete;
  AskedParameters& operator=(const AskedParameters&) = delete;

 private:
  ros::NodeHandle private_nh_;
  std::map<std::string, std::optional<XmlRpc::XmlRpcValue>> groups_;
};

}  // namespace

AspectServer::AspectServer(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : AspectServer(nh, private_nh, load_setup(nh, private_nh)) {}

AspectServer::AspectServer(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh, NodeSetup setup)
    : nh_(nh),
      private_nh_(private_nh),
      read_only_(setup.options.read_only),
      robot_(std::make_unique<RobotServer>(nh, private_nh, std::move(setup))),
      spinner_(1, &queue_) {
  ros::NodeHandle on_own_queue(private_nh);
  on_own_queue.setCallbackQueue(&queue_);
  const boost::function<bool(Reload::Request&, Reload::Response&)> callback =
      [this](Reload::Request&, Reload::Response& response) {
        response = reload();
        return true;
      };
  reload_ = on_own_queue.advertiseService("reload", callback);
  master_.look();
  master_timer_ =
      on_own_queue.createWallTimer(between_looks, [this](const ros::WallTimerEvent&) { master_.look(); });
  spinner_.start();
}

AspectServer::~AspectServer() {
  reload_.shutdown();
  master_timer_.stop();
  spinner_.stop();
}

// Names of topics and services are free again only once the robot before is gone. Where the new one cannot be
// served after all, that one is served anew, with what was in force, but without a start: where the robot
// is by now must be stated anew.
void AspectServer::replace_robot(NodeSetup setup) {
  if (robot_) last_served_ = robot_->setup();
  robot_.reset();
  try {
    robot_ = std::make_unique<RobotServer>(nh_, private_nh_, std::move(setup));
  } catch (const std::exception& failure) {
    const std::string reason = std::string("The robot cannot be served: ") + failure.what();
    serve_last_again(reason);
    throw InvalidDescription({reason, "The robot before is served anew; set its assembly mode."});
  }
}

void AspectServer::serve_last_again(const std::string& reason) {
  NodeSetup again = *last_served_;
  again.options.start = {};
  const AskedParameters asked(private_nh_);
  try {
    robot_ = std::make_unique<RobotServer>(nh_, private_nh_, std::move(again));
  } catch (const std::exception& failure) {
    throw InvalidDescription({reason, std::string("Nor can the one before: ") + failure.what()});
  }
}

Reload::Response AspectServer::reload() {
  Reload::Response response;
  if (read_only_) {
    response.status = refused_as_read_only();
    return response;
  }
  try {
    replace_robot(load_setup(nh_, private_nh_));
    ROS_INFO("robot_description and the parameters were loaded anew.");
  } catch (const InvalidDescription& invalid) {
    response.problems.assign(invalid.problems().begin(), invalid.problems().end());
    response.status.code = Status::FAILED;
    response.status.message = "What was there before stays in use, as there are problems: " +
                              std::to_string(response.problems.size()) + ".";
    for (const std::string& problem : invalid.problems()) ROS_ERROR_STREAM("Not loaded anew: " << problem);
  }
  return response;
}

}  // namespace parallel_aspects
