// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/aspect_server.h"

#include "parallel_aspects/model/problems.h"

#include <ros/console.h>

#include <XmlRpcValue.h>
#include <exception>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace parallel_aspects {
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
// served after all, that one is served anew, with what was in force, but without a start: where it is by now
// somebody has to say.
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
