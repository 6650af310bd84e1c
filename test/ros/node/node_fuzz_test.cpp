// SPDX-License-Identifier: BSD-3-Clause
//
// A running node under messages, requests, goals and parameters made at random. It may refuse them, with a
// message; it must not end, not hang, and not answer wrongly. Parameters: ~seconds for each robot, ~seed.
// The inputs before a failure are printed; the same seed makes the same ones.
#include "model/linear_algebra.h"
#include "ros/messages/conversions.h"
#include "ros/node/node_client.h"
#include "ros/node/process.h"
#include "ros/node/random_messages.h"
#include "ros/node/watchdog.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/ComputeMapAction.h>
#include <parallel_aspects/GetCurrentAspect.h>
#include <parallel_aspects/GetJacobian.h>
#include <parallel_aspects/GetSingularityDistance.h>
#include <parallel_aspects/GetWorkingMode.h>
#include <parallel_aspects/ListAspects.h>
#include <parallel_aspects/Reload.h>
#include <parallel_aspects/SetAssemblyMode.h>

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include "support/robots/shipped.h"
#include <atomic>
#include <cmath>
#include <deque>
#include <dynamic_reconfigure/Reconfigure.h>
#include <memory>
#include <sensor_msgs/JointState.h>
#include <sstream>
#include <string>
#include <utility>
#include <vector>
#include <visualization_msgs/MarkerArray.h>
#include <xmlrpcpp/XmlRpcValue.h>

namespace parallel_aspects {
namespace {

using test::eventually;
using test::RandomMessages;
using test::Recorder;
using test::Watchdog;
using XmlRpc::XmlRpcValue;

constexpr std::uint8_t last_code = Status::READ_ONLY;

std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 1500;
  return text.size() <= longest ? text
                                : text.substr(0, longest) + "... and " +
                                      std::to_string(text.size() - longest) + " characters more";
}

/// One robot's node, and what is thrown at it.
class NodeFuzz : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    ros::param::param("~seconds", seconds_, seconds_);
    ros::param::param("~seed", seed_, seed_);
    const std::string robot = GetParam(), space = "/" + robot;
    node_ = space + "/aspect_node";
    ros::param::get(node_, parameters_);
    ros::param::get(space + "/robot_description", description_);
    process_ = std::make_unique<test::Process>(PARALLEL_ASPECTS_NODE, space);
    random_ = std::make_unique<RandomMessages>(static_cast<unsigned>(seed_), words());
    joints_to_actuate_ = advertise<sensor_msgs::JointState>(space + "/joint_states");
    transforms_ = advertise<tf2_msgs::TFMessage>("/tf");
    goals_ = advertise<ComputeMapActionGoal>(node_ + "/compute_map/goal");
    cancels_ = advertise<actionlib_msgs::GoalID>(node_ + "/compute_map/cancel");
    states_ = ros::NodeHandle().subscribe<AspectState>(node_ + "/state", 1000,
                                                       [this](const auto& state) { check_state(*state); });
    const boost::function<void(const visualization_msgs::MarkerArrayConstPtr&)> nothing = [](const auto&) {};
    markers_ = ros::NodeHandle().subscribe(node_ + "/markers", 10, nothing);  // so that they are drawn

    ASSERT_TRUE(ros::service::waitForService(node_ + "/reload", ros::Duration(test::deadline)));
    ASSERT_TRUE(eventually([&] { return joints_to_actuate_.getNumSubscribers() > 0; }));
  }

  void TearDown() override {
    dog_.feed();
    for (ros::Subscriber* subscriber : {&states_, &markers_}) subscriber->shutdown();
    EXPECT_EQ(process_->end(), 0) << said();
  }

  template <typename Message>
  static ros::Publisher advertise(const std::string& topic) {
    return ros::NodeHandle().advertise<Message>(topic, 100);
  }

  // The actuated joints first, in their order.
  std::vector<std::string> words() const {
    std::vector<std::string> words;
    for (const Leg& leg : robot_.legs()) words.push_back(leg.actuated_joint);
    for (const std::string& joint : mechanism_->joint_names()) words.push_back(joint);
    for (const char* word : {"", "base_link", "platform", "table", "parallel_warn", "parallel_stop",
                             "hysteresis", "gallery_scale", "rate", "gallery"})
      words.emplace_back(word);
    return words;
  }

  // Keeps what was sent last, for the report of a failure.
  template <typename Message>
  void note(const std::string& what, const Message& message) {
    std::ostringstream text;
    text << "step " << steps_ << ", " << what << ":\n";
    std::ostringstream content;
    content << message;
    text << shortened(content.str()) << "\n";
    inputs_.push_back(text.str());
    if (inputs_.size() > 6) inputs_.pop_front();
  }

  std::string said() const {
    std::string text = "seed " + std::to_string(seed_) + "\n";
    for (const std::string& input : inputs_) text += input;
    return text;
  }

  void fail(const std::string& what) {
    if (!std::exchange(failed_, true)) ADD_FAILURE() << what << "\n" << said();
  }
  void require(bool holds, const std::string& what) {
    if (!holds) fail(what);
  }

  void check(const Status& status) {
    require(status.code <= last_code, "an unknown status");
    require(status.code == Status::OK || !status.message.empty(), "a status without a message");
  }

  // The legs close: the answer is a configuration of this robot.
  void check(const SolvedConfiguration& solution) {
    const auto pose = pose_from_base(robot_, solution.pose);
    require(pose.has_value(), "a solution without a pose");
    require(solution.joint_positions.size() == robot_.leg_count(), "too few joints in a solution");
    for (std::size_t j = 0; pose && j < robot_.leg_count(); ++j) {
      const Leg& leg = robot_.leg(j);
      const double q = solution.joint_positions[j];
      const double rod = (pose->transform(leg.anchor) - leg.proximal_point(q)).norm();
      const double gap = std::abs(rod - std::sqrt(std::max(0.0, leg.squared_distance(q))));
      require(gap < 1e-5 * (robot_.size() + std::abs(q)), "the legs of a solution do not close");
    }
  }

  template <typename Response>
  void check_solutions(const Response& response) {
    const bool answered = response.status.code == Status::OK || response.status.code == Status::NO_MAP;
    require(!answered || !response.solutions.empty(), "OK without a solution");
    for (const SolvedConfiguration& solution : response.solutions) check(solution);
  }

  void check(const GetWorkingMode::Response& response) { check_solutions(response); }
  void check(const GetCurrentAspect::Response& response) { check_solutions(response); }
  void check(const SetAssemblyMode::Response& response) { check_solutions(response); }
  void check(const ListAspects::Response& response) {
    for (const AspectSummary& aspect : response.aspects)
      require(aspect.id > 0 && aspect.measure >= 0.0, "an aspect without id or measure");
  }
  void check(const GetSingularityDistance::Response& response) {
    require(response.status.code != Status::OK || !response.reports.empty(), "OK without a report");
    for (const SingularityReport& report : response.reports) {
      check(report.configuration);
      for (const MetricDistance* distance :
           {&report.parallel_distance, &report.serial_distance, &report.limit_distance})
        require(!(distance->lower > distance->upper * (1.0 + 1e-9) + 1e-12),
                "a lower bound above the upper one");
    }
  }

  void check(const GetJacobian::Response& response) {
    require(response.status.code != Status::OK || !response.jacobians.empty(), "OK without a Jacobian");
    for (const Jacobian& each : response.jacobians) {
      check(each.configuration);
      require((each.status == Jacobian::REGULAR) == each.reason.empty(), "a singularity without a reason");
      for (const auto* matrix : {&each.a, &each.jacobian, &each.inverse_jacobian, &each.force_transmission})
        for (const double entry : *matrix) require(std::isfinite(entry), "a matrix that is not finite");
    }
  }

  // On another thread.
  void check_state(const AspectState& state) {
    const bool known = state.status.code == Status::OK;
    if (!known && state.status.message.empty()) state_fault_ = "a state without a message";
    if (known != std::isfinite(state.pose.position.x)) state_fault_ = "a state with a pose that is not known";
    if (known == state.working_mode.empty()) state_fault_ = "a state with a working mode that is not known";
  }

  // Whether there was an answer at all.
  template <typename Service>
  bool ask(const std::string& name, Service& service) {
    const std::string full = node_ + "/" + name;
    // The poll thread of roscpp's client takes the end of the server's side (POLLRDHUP) for the end of the
    // connection, even where the answer has arrived and is still to be read: then it is lost. Any roscpp
    // server loses single answers so (ros_comm issue 1976), some in 10,000 on a busy computer; two in a row
    // would be the node's fault.
    if (ros::service::call(full, service)) return true;
    if (!dog_.has_bitten() && !process_->has_ended() && ros::service::call(full, service)) return true;
    fail(dog_.has_bitten() ? "no answer within a minute" : "no answer");
    return false;
  }

  // Else nearly every question would be refused for the fields that its kind does not look at.
  static void leave_what_its_kind_means(Configuration& configuration) {
    if (configuration.kind != Configuration::POSE) configuration.pose = {};
    if (configuration.kind == Configuration::JOINTS) return;
    configuration.joint_names.clear();
    configuration.joint_positions.clear();
  }

  template <typename Service>
  void question(const std::string& name) {
    Service service;
    service.request = random_->make<typename Service::Request>();
    if (random_->pick(2) == 0) leave_what_its_kind_means(service.request.configuration);
    note(name, service.request);
    if (!ask(name, service)) return;
    check(service.response.status);
    check(service.response);
  }

  void reconfigure(const std::string& name) {
    dynamic_reconfigure::Reconfigure service;
    service.request = random_->make<dynamic_reconfigure::ReconfigureRequest>();
    note(name, service.request);
    ask(name, service);
  }

  template <typename Message>
  void publish(const ros::Publisher& publisher) {
    const auto message = random_->make<Message>();
    note(publisher.getTopic(), message);
    publisher.publish(message);
  }

  void publish_true_joints() {
    sensor_msgs::JointState message;
    message.header.stamp = ros::Time::now();
    const AssembledConfiguration assembled = mechanism_->assembled();
    for (const Leg& leg : robot_.legs()) message.name.push_back(leg.actuated_joint);
    for (const double value : coefficients_of(assembled.q)) message.position.push_back(value);
    joints_to_actuate_.publish(message);
  }

  XmlRpcValue random_value(int depth = 0) {
    XmlRpcValue value;
    switch (random_->pick(depth > 2 ? 5 : 8)) {
      case 0:
        return XmlRpcValue(random_->pick(2) == 0);
      case 1:
        return XmlRpcValue(static_cast<int>(random_->pick(2000000001)) - 1000000000);
      case 2:
      case 3:
        return XmlRpcValue(random_->number());
      case 4:
        return XmlRpcValue(printable(random_->text()));
      case 5:
        value.setSize(0);
        for (int i = 0, end = static_cast<int>(random_->pick(5)); i < end; ++i)
          value[i] = random_value(depth + 1);
        return value;
      default:
        for (std::size_t i = random_->pick(3) + 1; i > 0; --i)
          value[printable(random_->text()).substr(0, 20) + "k"] = random_value(depth + 1);
        return value;
    }
  }

  // What XML can carry, and a name may hold.
  static std::string printable(std::string text) {
    for (char& letter : text)
      if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
    return text;
  }

  // Something at random, some levels down, becomes something else.
  void disturb(XmlRpcValue& value) {
    const bool deeper = random_->pick(4) > 0;
    if (value.getType() == XmlRpcValue::TypeStruct && value.size() > 0 && deeper) {
      auto member = value.begin();
      std::advance(member, static_cast<int>(random_->pick(static_cast<std::size_t>(value.size()))));
      return disturb(member->second);
    }
    if (value.getType() == XmlRpcValue::TypeArray && value.size() > 0 && deeper)
      return disturb(value[static_cast<int>(random_->pick(static_cast<std::size_t>(value.size())))]);
    value = random_value();
  }

  std::string disturbed_description() {
    if (random_->pick(3) == 0) return printable(random_->text());
    std::string text = description_;
    const std::size_t start = random_->pick(text.size());
    if (random_->pick(2) == 0) return text.substr(0, start);
    return text.erase(start, random_->pick(40));
  }

  Reload::Response reload() {
    Reload service;
    if (ask("reload", service)) check(service.response.status);
    const bool refused = service.response.status.code != Status::OK;
    require(refused == !service.response.problems.empty(),
            "refused without a problem, or the other way round");
    for (const std::string& problem : service.response.problems)
      require(!problem.empty(), "an empty problem");
    return service.response;
  }

  // A reload with wrong parameters, and one with the right ones.
  void parameters() {
    XmlRpcValue disturbed = parameters_;
    disturb(disturbed);
    note("parameters", disturbed.toXml());
    ros::param::set(node_, disturbed);
    const std::string name = std::string("/") + GetParam() + "/robot_description";
    if (random_->pick(3) == 0) {
      const std::string description = disturbed_description();
      note("robot_description", description);
      ros::param::set(name, description);
    }
    reload();
    ros::param::set(node_, parameters_);
    ros::param::set(name, description_);
    require(reload().status.code == Status::OK, "what was right before is refused");
  }

  // A question with a known answer.
  void known_question() {
    GetWorkingMode service;
    service.request.configuration.kind = Configuration::POSE;
    service.request.configuration.pose.pose =
        pose_message(platform_in_base(robot_, mechanism_->assembled().pose));
    note("a known question", service.request);
    if (!ask("get_working_mode", service)) return;
    check(service.response);
    require(service.response.status.code == Status::OK, "a pose that is reached is refused");
  }

  void step() {
    ++steps_;
    dog_.feed();
    publish_true_joints();
    switch (random_->pick(40)) {
      case 0:
        return parameters();
      case 1:
        return reconfigure("thresholds/set_parameters");
      case 2:
        return reconfigure("display/set_parameters");
      case 3:
        return publish<ComputeMapActionGoal>(goals_);
      case 4:
        return publish<actionlib_msgs::GoalID>(cancels_);
      case 5:
        return publish<tf2_msgs::TFMessage>(transforms_);
      case 6:
        return known_question();
      default:
        break;
    }
    switch (random_->pick(7)) {
      case 0:
        return question<GetWorkingMode>("get_working_mode");
      case 1:
        return question<GetCurrentAspect>("get_current_aspect");
      case 2:
        return question<GetSingularityDistance>("get_singularity_distance");
      case 3:
        return question<ListAspects>("list_aspects");
      case 4:
        return question<SetAssemblyMode>("set_assembly_mode");
      case 5:
        return question<GetJacobian>("get_jacobian");
      default:
        return publish<sensor_msgs::JointState>(joints_to_actuate_);
    }
  }

  double seconds_ = 3.0;
  int seed_ = 1;
  std::string node_, description_;
  XmlRpcValue parameters_;
  const std::shared_ptr<const Mechanism> mechanism_ = test::shipped(GetParam());
  const Manipulator& robot_ = *mechanism_->manipulator();
  std::unique_ptr<test::Process> process_;
  std::unique_ptr<RandomMessages> random_;
  ros::Publisher joints_to_actuate_, transforms_, goals_, cancels_;
  ros::Subscriber states_, markers_;
  std::deque<std::string> inputs_;
  bool failed_ = false;
  std::atomic<const char*> state_fault_{nullptr};
  std::size_t steps_ = 0;
  Watchdog dog_{[this] { process_->signal(SIGKILL); }};
};

TEST_P(NodeFuzz, NeitherEndsNorHangsNorAnswersWrongly) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds_);
  while (ros::WallTime::now() < end && !failed_) {
    step();
    if (process_->has_ended()) fail("the node has ended");
    if (const char* const fault = state_fault_) fail(fault);
  }
  std::printf("%s: %zu steps, seed %d\n", GetParam(), steps_, seed_);
  RecordProperty("steps", static_cast<int>(steps_));
}

INSTANTIATE_TEST_SUITE_P(Robots, NodeFuzz, testing::Values("five_bar", "stewart"),
                         [](const auto& robot) { return std::string(robot.param); });

}  // namespace
}  // namespace parallel_aspects
