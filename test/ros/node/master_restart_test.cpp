// SPDX-License-Identifier: BSD-3-Clause
//
// The ROS master ends and is started anew, knowing nothing: the node goes on, is found again by nodes that
// ask the new master, and has lost neither its map nor the robot.
#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/monitor/five_bar_setup.h"
#include "ros/node/node_client.h"
#include "ros/node/process.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/AspectTransition.h>
#include <parallel_aspects/ListAspects.h>

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>

#include <arpa/inet.h>
#include <cstdlib>
#include <memory>
#include <netinet/in.h>
#include <std_msgs/Bool.h>
#include <string>
#include <sys/socket.h>
#include <unistd.h>

namespace parallel_aspects {
namespace {

using test::eventually;
using test::Recorder;

const std::string node = "/aspect_node";

// A port that nobody listens at; 0 where there is none.
int free_port() {
  const int handle = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  const bool bound = bind(handle, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
                     getsockname(handle, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  close(handle);
  return bound ? ntohs(address.sin_port) : 0;
}

/// A master that can be ended and started anew at the same port.
class Master {
 public:
  Master() : port_(std::to_string(free_port())) {
    setenv("ROS_MASTER_URI", ("http://localhost:" + port_).c_str(), 1);
  }
  bool start() {
    process_ =
        std::make_unique<test::Process>("rosmaster", "", std::vector<std::string>{"--core", "-p", port_});
    return eventually([] { return ros::master::check(); });
  }
  bool end() {
    process_.reset();  // at once, as in a crash
    return eventually([] { return !ros::master::check(); });
  }

 private:
  const std::string port_;
  std::unique_ptr<test::Process> process_;
};

Master& master() {
  static Master the_master;
  return the_master;
}

class MasterRestart : public testing::Test {
 protected:
  void SetUp() override {
    ros::param::set("/robot_description", test::source_file("urdf/five_bar.urdf"));
    ros::param::set(node + "/start/pose", std::vector<double>{4.5, 8.0});
    ros::param::set(node + "/map/resolution", 0.2);
    ros::param::set(node + "/thresholds/parallel_stop", 0.1);
    ros::param::set(node + "/joint_states_timeout", 2.0);  // a busy computer holds messages up
    ros::param::set(node + "/tracking/longest_interval", std::numeric_limits<double>::infinity());
    ros::param::set(node + "/tracking/check_velocity", false);  // no actuated joint is as fast
    ros::param::set(node + "/mechanism", test::five_bar_mechanism_parameter());
    process_ = std::make_unique<test::Process>(PARALLEL_ASPECTS_NODE, "/");
    advertise();
    ASSERT_TRUE(eventually([&] { return states_.last().has_value() && log_.connected(); }));
  }
  void TearDown() override {
    EXPECT_FALSE(process_->has_ended());
    EXPECT_EQ(process_->end(), 0);
  }

  void advertise() {
    joint_states_ = ros::NodeHandle().advertise<sensor_msgs::JointState>("/joint_states", 1000);
    ASSERT_TRUE(eventually([&] { return joint_states_.getNumSubscribers() == 1; }));
  }
  // What the node says of the robot there, 0.01 further down.
  std::uint8_t move() {
    const ros::Time stamp = ros::Time::now();
    y_ -= 0.01;
    joint_states_.publish(test::joints_at(*robot_->manipulator(), test::pose_at(4.5, y_), {1, -1}, stamp));
    return states_.answer(stamp).status.code;
  }
  std::size_t times_said(const std::string& words) const {
    std::size_t count = 0;
    for (const auto& line : log_.all()) count += line.msg.find(words) != std::string::npos ? 1 : 0;
    return count;
  }

  const std::shared_ptr<const Mechanism> robot_ = test::five_bar_mechanism();
  double y_ = 8.0;
  ros::Publisher joint_states_;
  std::unique_ptr<test::Process> process_;
  const Recorder<AspectState> states_{node + "/state"};
  const Recorder<rosgraph_msgs::Log> log_{"/rosout"};
};

TEST_F(MasterRestart, TheNodeIsFoundAgainWithItsMapAndItsRobot) {
  ListAspects::Response aspects;
  ASSERT_TRUE(eventually([&] {
    aspects = test::call<ListAspects>(node + "/list_aspects", {});
    return aspects.status.code == Status::OK;
  }));
  // Further than the start's tolerance, so that a node that began anew would not find the robot.
  while (y_ > 6.5) ASSERT_EQ(move(), Status::OK) << y_;

  for (std::size_t round = 1; round <= 2; ++round) {
    ASSERT_TRUE(master().end());
    ASSERT_TRUE(eventually([&] { return times_said("master does not answer") == round; }));
    EXPECT_EQ(move(), Status::OK) << "connections need no master";
    ASSERT_TRUE(master().start());
    ASSERT_TRUE(eventually([&] { return times_said("were registered again") == round; }));
    EXPECT_EQ(move(), Status::OK);

    // The service and the topics are looked up at the new master.
    const auto after = test::call<ListAspects>(node + "/list_aspects", {});
    EXPECT_EQ(after.status.code, Status::OK) << after.status.message;
    EXPECT_EQ(after.aspects.size(), aspects.aspects.size());
    const Recorder<AspectTransition> late(node + "/transitions");
    EXPECT_TRUE(eventually([&] { return late.connected(); }));
    joint_states_.shutdown();
    advertise();
    EXPECT_EQ(move(), Status::OK) << states_.last()->status.message;
  }
  EXPECT_EQ(times_said("were registered again"), 2U) << "and nothing twice";
}

// Rospy does not register again, so that the example starts itself anew.
TEST_F(MasterRestart, TheGoSignalIsFoundAgain) {
  const char* before = std::getenv("PYTHONPATH");
  setenv("PYTHONPATH", (std::string(PARALLEL_ASPECTS_PYTHON ":") + (before != nullptr ? before : "")).c_str(),
         1);
  test::Process signal(PARALLEL_ASPECTS_SOURCE_DIR "/example/go_signal.py", "/",
                       {"__name:=go_signal", "state:=" + node + "/state", "_silence:=1.0"});
  const auto says = [&](const Recorder<std_msgs::Bool>& signals, bool go) {
    return eventually([&] {
      if (go) move();
      return signals.last() && static_cast<bool>(signals.last()->data) == go;
    });
  };
  {
    const Recorder<std_msgs::Bool> signals("/go_signal/go");
    ASSERT_TRUE(says(signals, true));
  }
  ASSERT_TRUE(master().end());
  ASSERT_TRUE(master().start());
  ASSERT_TRUE(eventually([&] { return times_said("were registered again") == 1; }));
  const Recorder<std_msgs::Bool> late("/go_signal/go");
  EXPECT_TRUE(eventually([&] { return late.connected(); })) << "looked up at the new master";
  EXPECT_TRUE(says(late, true));
  double silence = 0.0;
  EXPECT_TRUE(ros::param::get("/go_signal/silence", silence));
  EXPECT_EQ(silence, 1.0) << "as it was started";
  EXPECT_FALSE(signal.has_ended());
}

}  // namespace
}  // namespace parallel_aspects

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  parallel_aspects::master();  // before ROS asks where it is
  ros::init(argc, argv, "master_restart_test", ros::init_options::NoRosout);
  if (!parallel_aspects::master().start()) return EXIT_FAILURE;
  const ros::NodeHandle nh;
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
