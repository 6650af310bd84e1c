// SPDX-License-Identifier: BSD-3-Clause
//
// Joint_states of more than one publisher: two that contradict, and one for each joint.
#include "ros/monitor/robot_monitor_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::RobotMonitorTest;
using test::start_at_pose;
using test::timeout;

class SeveralPublishers : public RobotMonitorTest {};

// The second player has another name, its first messages come before the clock that it sets back.
TEST_F(SeveralPublishers, ABagThatIsPlayedTwiceHasOnePublisher) {
  for (int i = 0; i <= 30; ++i)
    monitor_.update(joint_values(4.5, 8.0, {1, -1}, 1.0 + 0.1 * i), at(1.0 + 0.1 * i), "/play_1");
  for (int i = 0; i < 3; ++i) {
    const auto early = monitor_.update(joint_values(4.5, 8.0, {1, -1}, 1.0 + 0.1 * i), at(4.0), "/play_2");
    EXPECT_FALSE(early.state) << early.state->status.message;
  }
  const auto again = monitor_.update(joint_values(4.5, 8.0, {1, -1}, 1.3), at(1.3), "/play_2");
  EXPECT_EQ(again.state->status.code, Status::OK) << again.state->status.message;
}

TEST_F(SeveralPublishers, TwoNodesThatPublishTheDrivesAreRefused) {
  const auto send = [&](const char* publisher, double seconds) {
    return monitor_.update(joint_values(4.5, 8.0, {1, -1}, seconds), at(seconds), publisher).state;
  };
  const auto from = [&](const char* publisher, double seconds) { return send(publisher, seconds)->status; };
  EXPECT_EQ(from("/one", 1.0).code, Status::OK);
  EXPECT_FALSE(send("/two", 1.05)) << "the first may have ended";
  const Status refused = from("/one", 1.1);
  EXPECT_EQ(refused.code, Status::SEVERAL_PUBLISHERS);
  EXPECT_NE(refused.message.find("/one"), std::string::npos);
  EXPECT_NE(refused.message.find("/two"), std::string::npos);
  EXPECT_EQ(from("/two", 1.15).code, Status::SEVERAL_PUBLISHERS);
  EXPECT_EQ(from("/one", 1.2).code, Status::SEVERAL_PUBLISHERS);
  EXPECT_EQ(code(1.2), Status::SEVERAL_PUBLISHERS);
  EXPECT_NE(from("/one", 1.7).code, Status::SEVERAL_PUBLISHERS) << "the other one has been silent since";
}

// While both publish, that is what is said; only when they are silent, that nothing comes.
TEST_F(SeveralPublishers, TwoNodesThatPublishTheDrivesAreNotStale) {
  const auto send = [&](const char* publisher, double seconds) {
    monitor_.update(joint_values(4.5, 8.0, {1, -1}, seconds), at(seconds), publisher);
  };
  send("/one", 1.0);
  for (int i = 1; i <= 20; ++i) {
    send("/two", 1.0 + 0.1 * i - 0.05);
    send("/one", 1.0 + 0.1 * i);
    ASSERT_FALSE(expire(1.0 + 0.1 * i)) << i;
  }
  EXPECT_EQ(code(3.0), Status::SEVERAL_PUBLISHERS);
  const auto stale = expire(3.6);
  ASSERT_TRUE(stale);
  EXPECT_EQ(stale->status.code, Status::STALE);
  EXPECT_EQ(code(3.6), Status::STALE);
}

// One of them ends: until it has been silent for the timeout nothing is said, least of all that nothing
// comes.
TEST_F(SeveralPublishers, TheLastOfTwoPublishersIsNotStale) {
  const auto send = [&](const char* publisher, double seconds) {
    return monitor_.update(joint_values(4.5, 8.0, {1, -1}, seconds), at(seconds), publisher).state;
  };
  for (int i = 0; i < 10; ++i) send(i % 2 == 0 ? "/one" : "/two", 1.0 + 0.1 * i);
  std::optional<AspectState> state;
  for (int i = 10; !state || state->status.code == Status::SEVERAL_PUBLISHERS; ++i) {
    ASSERT_LT(i, 20);
    state = send("/one", 1.05 + 0.1 * i);
    ASSERT_FALSE(expire(1.05 + 0.1 * i)) << i;
  }
  EXPECT_EQ(state->status.code, Status::AMBIGUOUS) << "nobody knows how it moved meanwhile";
}

// Of two that publish all joints and never pause for the timeout, by an account of its own: every message
// with its time of arrival.
class TwoPublishers : public SeveralPublishers {
 protected:
  static constexpr double alive = 0.1;  // [s]
  struct Arrival {
    double time;
    bool second;
  };
  struct Counts {
    int believed = 0, wrongly = 0, missed = 0, while_both_speak = 0;
  };

  static NodeOptions trusting() {
    NodeOptions options = start_at_pose(4.5, 8.0);
    options.joint_states_timeout = alive;
    options.tracking.samples.longest_interval = std::numeric_limits<double>::infinity();
    options.tracking.samples.check_velocity = false;
    return options;
  }

  // Arrivals of one of them between two times, each off its time by some of the period.
  void add(bool second, double period, double from, double until, std::vector<Arrival>& arrivals) {
    std::uniform_real_distribution<double> jitter(0.0, 0.3 * period);
    for (double time = from; time < until; time += period)
      arrivals.push_back({time + jitter(random_), second});
  }

  // Whether each is believed as long as the other one has been silent, and no longer.
  Counts play(std::vector<Arrival> arrivals, double offset) {
    std::sort(arrivals.begin(), arrivals.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
    RobotMonitor monitor(mechanism_, trusting());
    Counts counts;
    ros::Time came[2];
    double looked = 0.0;
    for (const Arrival& arrival : arrivals) {
      for (; looked < arrival.time; looked += alive / 4.0)
        monitor.expire(at(looked), ros::SteadyTime(100.0 + looked));
      sensor_msgs::JointState message = joints_;
      message.header.stamp = at(arrival.time);
      if (arrival.second) message.position[0] += offset;
      monitor.beat(ros::SteadyTime(100.0 + arrival.time));
      const auto update = monitor.update(message, at(arrival.time), arrival.second ? "/second" : "/first");
      const bool believed = update.tracked.has_value() || (update.state && is_sample(update.state->status));
      const ros::Time other = came[!arrival.second];
      const bool both_speak = !other.isZero() && at(arrival.time) - other <= ros::Duration(alive);
      came[arrival.second] = at(arrival.time);
      counts.believed += believed;
      counts.wrongly += believed && both_speak;
      counts.while_both_speak += both_speak;
      counts.missed += !both_speak && !believed;
    }
    return counts;
  }

  // What becomes of a sample that was taken.
  static bool is_sample(const Status& status) {
    return status.code == Status::OK || status.code == Status::AMBIGUOUS;
  }

  sensor_msgs::JointState joints_ = joint_values(4.5, 8.0, {1, -1}, 0.0);
  std::mt19937 random_{20261128};
};

TEST_F(TwoPublishers, NoneIsBelievedWhileBothSpeakWhateverTheirRates) {
  const std::vector<double> rates{14.0, 30.0, 100.0, 200.0, 500.0};
  int looked_at = 0;
  for (const double first : rates)
    for (const double second : rates) {
      if (first == second && first != 100.0 && first != 500.0) continue;
      for (int phase = 0; phase < 10; ++phase)
        for (const double offset : {0.0, 0.3, 1e-5}) {
          const double begin = 0.15 + 0.1 * phase / second;
          std::vector<Arrival> arrivals;
          add(false, 1.0 / first, 0.05, 0.5, arrivals);
          add(true, 1.0 / second, begin, 0.8, arrivals);
          const Counts counts = play(arrivals, offset);
          ASSERT_EQ(counts.wrongly, 0)
              << first << " and " << second << " Hz from " << begin << ", off by " << offset;
          ASSERT_EQ(counts.missed, 0)
              << first << " and " << second << " Hz from " << begin << ", off by " << offset;
          ASSERT_GT(counts.believed, 0) << "the first before, and the second after it has ended";
          looked_at += counts.while_both_speak;
        }
    }
  EXPECT_GT(looked_at, 50000);
}

// The second is silent for just less than the timeout, or just more, by turns.
TEST_F(TwoPublishers, NoneIsBelievedWhileSilencesEndJustInTime) {
  for (const double less : {1e-6, 1e-3, 0.01}) {
    std::vector<Arrival> arrivals;
    add(false, 0.002, 0.05, 2.0, arrivals);
    double time = 0.2;
    for (int i = 0; time < 2.0; ++i) {
      arrivals.push_back({time, true});
      time += i % 2 == 0 ? alive - less : alive + less;
    }
    const Counts counts = play(arrivals, 0.3);
    EXPECT_EQ(counts.wrongly, 0) << less;
    EXPECT_EQ(counts.missed, 0) << less;
  }
}

// More of them than are remembered by name.
TEST_F(TwoPublishers, ManyOtherPublishersHideNoContest) {
  PublisherWatch watch(ros::Duration(0.5));
  JointSet all;
  all.set(0).set(1);
  std::string other;
  int believed = 0;
  for (int i = 0; i < 400; ++i) {
    const std::string name = "/node_" + std::to_string(i % 40);
    watch.count(name, static_cast<std::uint32_t>(i));
    believed += watch.claim(name, all, at(1.0 + 0.01 * i), other) == Claim::sole;
  }
  EXPECT_EQ(believed, 1) << "the first of all";
}

// One publisher for each joint, each half a period after the other.
TEST_F(SeveralPublishers, DrivesOfSeveralPublishersAreMerged) {
  const auto send = [&](int actuation, double y, double seconds) {
    auto message = joint_values(4.5, y, {1, -1}, seconds);
    message.name = {message.name[static_cast<std::size_t>(actuation)]};
    message.position = {message.position[static_cast<std::size_t>(actuation)]};
    return monitor_.update(message, at(seconds), actuation == 0 ? "/one" : "/two");
  };
  const auto alone = send(0, 8.0, 1.0);
  EXPECT_EQ(alone.state->status.code, Status::NO_JOINT_STATES);
  EXPECT_NE(alone.state->status.message.find("crank_2_joint"), std::string::npos);
  EXPECT_EQ(send(1, 8.0 + 5e-4, 1.005).state->status.code, Status::NO_JOINT_STATES) << "none is as early";
  for (int i = 2; i < 100; ++i) {
    const MonitorUpdate merged = send(i % 2, 8.0 + 5e-4 * i, 1.0 + 0.005 * i);
    ASSERT_TRUE(merged.state);
    ASSERT_EQ(merged.state->status.code, Status::OK) << i << ": " << merged.state->status.message;
    EXPECT_EQ(merged.state->header.stamp, at(1.0 + 0.005 * (i - 1))) << "the last time that all are known of";
    EXPECT_LE(std::abs(merged.state->pose.position.y - 8.0 - 5e-4 * (i - 1)), merged.tracked->spread + 1e-9);
    monitor_.work();
  }
  EXPECT_TRUE(send(0, 8.05, 1.5).state);
  EXPECT_FALSE(send(0, 8.05, 1.7).state) << "the other value is too old";
  EXPECT_TRUE(expire(2.3)) << "actuated joints that are missing make it stale";
}

TEST_F(SeveralPublishers, TheOneThatHasEndedIsNamedByItsJoint) {
  const auto send = [&](std::size_t actuation, double seconds) {
    auto message = joint_values(4.5, 8.0, {1, -1}, seconds);
    message.name = {message.name[actuation]};
    message.position = {message.position[actuation]};
    monitor_.update(message, at(seconds), actuation == 0 ? "/one" : "/two");
  };
  for (std::size_t i = 0; i < 10; ++i) send(i % 2, 1.0 + 0.02 * static_cast<double>(i));
  for (int i = 0; i < 50; ++i) send(0, 1.2 + 0.02 * i);
  const auto stale = expire(2.2);
  ASSERT_TRUE(stale);
  EXPECT_EQ(
      stale->status.message,
      "Of the actuated joints, crank_2_joint has not come for 1 s, while others arrive; look at the driver.");
}

// Values that are long apart are not joined, which is said with what to do.
TEST_F(SeveralPublishers, DrivesThatComeTooFarApartAreSaidToBe) {
  std::string text;
  for (int i = 0; i < 20 && text.find("in one message") == std::string::npos; ++i) {
    auto message = joint_values(4.5, 8.0, {1, -1}, 1.0 + 0.06 * i);
    const auto actuation = static_cast<std::size_t>(i % 2);
    message.name = {message.name[actuation]};
    message.position = {message.position[actuation]};
    const MonitorUpdate merged =
        monitor_.update(message, message.header.stamp, actuation == 0 ? "/one" : "/two");
    if (merged.state) text = merged.state->status.message;
  }
  EXPECT_NE(text.find("publish all of them in one message, or each more often"), std::string::npos) << text;
}

}  // namespace
}  // namespace parallel_aspects
