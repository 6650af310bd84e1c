// SPDX-License-Identifier: BSD-3-Clause
//
// The assembly mode is searched for on a copy of the tracker, while samples come and others ask.
#include "ros/monitor/robot_monitor_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using test::pose_at;
using test::RobotMonitorTest;
using test::start_at_pose;

constexpr std::chrono::seconds search_deadline(60);

/// The five-bar at rest at (4.5, 8), lost by a silence that its velocity limits keep near.
class AssemblySearchTest : public RobotMonitorTest {
 protected:
  static NodeOptions options() {
    NodeOptions options = start_at_pose(4.5, 8.0);
    options.tracking.samples.longest_interval = 0.05;
    return options;
  }

  AspectState play(double y, double seconds) {
    const MonitorUpdate update = lost_.update(joint_values(4.5, y, {1, -1}, seconds), at(seconds));
    told_.insert(told_.end(), update.transitions.begin(), update.transitions.end());
    return *update.state;
  }

  void lose() {
    EXPECT_EQ(play(8.0, 1.0).status.code, Status::OK);
    EXPECT_EQ(play(8.0, 1.01).status.code, Status::OK);
    EXPECT_EQ(play(8.0, 1.08).status.code, Status::AMBIGUOUS);
  }

  int told(std::uint8_t kind) const {
    return static_cast<int>(std::count_if(told_.begin(), told_.end(),
                                          [&](const AspectTransition& each) { return each.kind == kind; }));
  }

  RobotMonitor lost_{mechanism_, options()};
  std::vector<AspectTransition> told_;
};

TEST_F(AssemblySearchTest, SamplesMeanwhileAreFollowedToo) {
  lose();
  auto search = lost_.begin_search();
  ASSERT_TRUE(search);
  double y = 8.0, seconds = 1.08;
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(play(y += 1e-4, seconds += 0.001).status.code, Status::AMBIGUOUS) << "nothing is found yet";
  search->run(PassiveJoints(mechanism_));
  EXPECT_EQ(play(y += 1e-4, seconds += 0.001).status.code, Status::AMBIGUOUS) << "nor taken";
  lost_.take(std::move(*search));
  EXPECT_NEAR(lost_.current(at(seconds)).tracked.pose.position.y(), y, 1e-9) << "at the last sample";
  EXPECT_EQ(play(y += 1e-4, seconds += 0.001).status.code, Status::OK);
  EXPECT_EQ(told(AspectTransition::LOST), 1);
  EXPECT_EQ(told(AspectTransition::FOUND), 1);
  play(y += 1e-4, seconds += 0.001);
  EXPECT_EQ(told(AspectTransition::FOUND), 1) << "not twice";
}

// As if the silence had come after the search.
TEST_F(AssemblySearchTest, ASilenceMeanwhileIsALossOfItsOwn) {
  lose();
  auto search = lost_.begin_search();
  ASSERT_TRUE(search);
  EXPECT_EQ(play(8.0, 1.15).status.code, Status::AMBIGUOUS);
  search->run(PassiveJoints(mechanism_));
  lost_.take(std::move(*search));
  EXPECT_EQ(play(8.0, 1.151).status.code, Status::AMBIGUOUS);
  EXPECT_EQ(told(AspectTransition::FOUND), 1);
  EXPECT_EQ(told(AspectTransition::LOST), 2);
  lost_.work();
  EXPECT_EQ(play(8.0, 1.152).status.code, Status::OK);
  EXPECT_EQ(told(AspectTransition::FOUND), 2);
}

TEST_F(AssemblySearchTest, WhatWasStatedMeanwhileStays) {
  lose();
  auto search = lost_.begin_search();
  ASSERT_TRUE(search);
  search->run(PassiveJoints(mechanism_));
  ASSERT_EQ(lost_.start_with_sign({{}, -1}, at(1.08)).code, Status::OK);
  lost_.take(std::move(*search));
  EXPECT_EQ(lost_.current(at(1.08)).tracked.determinant_sign, -1);
  play(8.0, 1.09);
  EXPECT_EQ(told(AspectTransition::FOUND), 0);
}

TEST_F(AssemblySearchTest, AClockThatWentBackMeanwhileVoidsIt) {
  lose();
  auto search = lost_.begin_search();
  ASSERT_TRUE(search);
  search->run(PassiveJoints(mechanism_));
  play(8.0, 0.1);
  lost_.take(std::move(*search));
  play(8.0, 0.11);
  EXPECT_EQ(told(AspectTransition::FOUND), 0);
}

TEST_F(AssemblySearchTest, TheNextSearchFindsWhatAVoidOneDidNot) {
  lose();
  auto search = lost_.begin_search();
  ASSERT_TRUE(search);
  search->run(PassiveJoints(mechanism_));
  lost_.set_map(nullptr);
  lost_.take(std::move(*search));
  EXPECT_EQ(play(8.0, 1.09).status.code, Status::AMBIGUOUS);
  lost_.work();
  EXPECT_EQ(play(8.0, 1.10).status.code, Status::OK);
  EXPECT_EQ(told(AspectTransition::FOUND), 1);
}

using Clock = std::chrono::steady_clock;

/// How long a search of a hexapod took, whose direct solutions take long to list, and how long others had to
/// wait for an answer meanwhile.
struct SearchTimes {
  Clock::duration search{}, longest_wait{};
};

SearchTimes times_of_search() {
  const auto mechanism = test::shipped("stewart");
  const JointVector q = mechanism->assembled().q;
  sensor_msgs::JointState message;
  message.header.stamp = ros::Time(100.0);
  for (const Leg& leg : mechanism->manipulator()->legs()) message.name.push_back(leg.actuated_joint);
  message.position.assign(q.data(), q.data() + q.size());
  RobotMonitor monitor(mechanism, NodeOptions());
  monitor.update(message, message.header.stamp);
  SearchTimes times;
  std::atomic<bool> done{false};
  std::thread searcher([&] {
    const auto start = Clock::now();
    monitor.work();
    times.search = Clock::now() - start;
    done = true;
  });
  while (!done) {
    const auto start = Clock::now();
    monitor.current(message.header.stamp);
    times.longest_wait = std::max(times.longest_wait, Clock::now() - start);
  }
  searcher.join();
  return times;
}

// A busy computer may hold up the one that asks.
TEST(AssemblySearch, OthersAreAnsweredWhileItLooks) {
  const auto end = Clock::now() + search_deadline;
  SearchTimes times = times_of_search();
  while (2 * times.longest_wait >= times.search && Clock::now() < end) times = times_of_search();
  EXPECT_LT(2 * times.longest_wait, times.search);
}

}  // namespace
}  // namespace parallel_aspects
