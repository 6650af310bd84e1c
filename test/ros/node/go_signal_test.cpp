// SPDX-License-Identifier: BSD-3-Clause
// The example that stops a robot where nothing is heard of its node.
#include "ros/node/node_life.h"

#include <csignal>
#include <cstdlib>
#include <memory>
#include <std_msgs/Bool.h>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::eventually;
using test::NodeLife;
using test::Recorder;

/// A node that is to be killed, and the example that listens to it.
class GoSignal : public NodeLife {
 protected:
  void SetUp() override {
    NodeLife::SetUp();
    set("thresholds/parallel_stop", threshold());
    start();
    ros::param::set(space_ + "/go_signal/silence", 1.0);
    const char* before = std::getenv("PYTHONPATH");
    setenv("PYTHONPATH",
           (std::string(PARALLEL_ASPECTS_PYTHON ":") + (before != nullptr ? before : "")).c_str(), 1);
    consumer_ = std::make_unique<test::Process>(
        PARALLEL_ASPECTS_SOURCE_DIR "/example/go_signal.py", space_,
        std::vector<std::string>{"__name:=go_signal", "state:=" + node_ + "/state"});
  }
  void TearDown() override {}
  virtual double threshold() const { return 0.1; }

  bool becomes(bool go) {
    return eventually([&] {
      joint_states_.publish(test::joints_at(*robot_->manipulator(), start_, {1, -1}, ros::Time::now()));
      return signals_.last() && static_cast<bool>(signals_.last()->data) == go;
    });
  }
  // Over so many signals, while the actuated joints are published on.
  bool stays_off(std::size_t count) {
    const std::size_t from = signals_.all().size();
    const bool came = eventually([&] { return becomes(false) && signals_.all().size() >= from + count; });
    return came && !signals_.first([](const std_msgs::Bool& go) { return static_cast<bool>(go.data); }, from);
  }

  std::unique_ptr<test::Process> consumer_;
  Recorder<std_msgs::Bool> signals_{
      std::string("/") + testing::UnitTest::GetInstance()->current_test_info()->name() + "/go_signal/go"};
};

TEST_F(GoSignal, IsOffWhereTheNodeIsHaltedOrKilled) {
  ASSERT_TRUE(becomes(true)) << "the first python3 on PATH must have rospy";
  process_->signal(SIGSTOP);
  EXPECT_TRUE(becomes(false));
  EXPECT_TRUE(stays_off(10));
  process_->signal(SIGCONT);
  EXPECT_TRUE(becomes(true));
  process_->signal(SIGKILL);
  EXPECT_TRUE(becomes(false));
  EXPECT_TRUE(stays_off(10));
  EXPECT_FALSE(consumer_->has_ended());
}

class GoSignalWithoutThresholds : public GoSignal {
  double threshold() const override { return 0.0; }
};

// The state is known, but nobody has said what is too near.
TEST_F(GoSignalWithoutThresholds, IsOff) {
  ASSERT_TRUE(eventually([&] { return move_to(start_).level == AspectState::NO_THRESHOLD; }));
  EXPECT_TRUE(stays_off(10));
}

}  // namespace
}  // namespace parallel_aspects
