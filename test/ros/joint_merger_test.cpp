// SPDX-License-Identifier: BSD-3-Clause
#include "ros/joint_states/joint_merger.h"

#include <gtest/gtest.h>

#include "support/robots.h"
#include <cmath>
#include <optional>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double window = 0.1;

JointVector values(double first, double second) {
  JointVector q(2);
  q << first, second;
  return q;
}

std::shared_ptr<const Manipulator> with_velocity(double velocity) {
  std::vector<Leg> legs = test::five_bar()->legs();
  for (Leg& leg : legs) leg.limits.velocity = velocity;
  return test::manipulator("limited", TaskSpace::T2, std::move(legs));
}

class JointMergerTest : public testing::Test {
 protected:
  static ros::Time at(double seconds) { return ros::Time(100.0 + seconds); }

  std::optional<MergedJoints> send(JointMerger& merger, std::size_t actuation, double seconds, double value) {
    return merger.add(at(seconds), JointSet().set(actuation), values(value, value));
  }

  JointMerger limited_{with_velocity(2.0), SampleOptions(), window};
  JointMerger free_{test::five_bar(), SampleOptions(), window};
};

TEST_F(JointMergerTest, TheAgeOfAValueIsPossibleMotion) {
  EXPECT_FALSE(send(limited_, 0, 1.0, 0.5)) << "nothing is known of the other actuated joint";
  const auto merged = send(limited_, 1, 1.01, -0.5);
  ASSERT_TRUE(merged);
  EXPECT_EQ(merged->stamp, at(1.01));
  EXPECT_EQ(merged->q, values(0.5, -0.5));
  EXPECT_NEAR(merged->uncertainty[0], 2.0 * 1.25 * 0.01, 1e-6);
  EXPECT_EQ(merged->uncertainty[1], 0.0);
  EXPECT_FALSE(send(limited_, 1, 1.2, -0.5)) << "the other value is too old";
  EXPECT_TRUE(send(limited_, 0, 1.15, 0.5)) << "this one is not";
}

TEST_F(JointMergerTest, ValuesThatOvertookOneAnotherAreNoNewConfiguration) {
  send(limited_, 0, 1.0, 0.5);
  ASSERT_TRUE(send(limited_, 1, 1.02, -0.5));
  EXPECT_FALSE(send(limited_, 0, 1.01, 0.6));
  EXPECT_FALSE(send(limited_, 0, 1.0, 0.7)) << "that is older than what is known of it";
  const auto merged = send(limited_, 1, 1.03, -0.4);
  ASSERT_TRUE(merged);
  EXPECT_EQ(merged->q, values(0.6, -0.4));
}

TEST_F(JointMergerTest, WithoutLimitsATimeMustLieBetweenValues) {
  EXPECT_FALSE(send(free_, 0, 1.00, 0.50));
  EXPECT_FALSE(send(free_, 1, 1.01, -0.50)) << "no value of this one is as early as that of the first";
  const auto merged = send(free_, 0, 1.02, 0.54);
  ASSERT_TRUE(merged) << "known at 1.01";
  EXPECT_EQ(merged->stamp, at(1.01));
  EXPECT_NEAR(merged->q[0], 0.52, 1e-6);
  EXPECT_EQ(merged->q[1], -0.5);
  EXPECT_NEAR(merged->uncertainty[0], 2.0 / 8.0 * 0.04, 1e-9) << "the path there may be bent, from rest";
  EXPECT_EQ(merged->uncertainty[1], 0.0);
  const auto next = send(free_, 1, 1.03, -0.52);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->stamp, at(1.02));
  EXPECT_EQ(next->q[0], 0.54);
  EXPECT_NEAR(next->q[1], -0.51, 1e-6);
}

TEST_F(JointMergerTest, ValuesTooFarApartAreNotJoined) {
  send(free_, 0, 1.00, 0.5);
  send(free_, 1, 1.05, -0.5);
  EXPECT_FALSE(send(free_, 0, 1.11, 0.5));
  EXPECT_TRUE(send(free_, 1, 1.11, -0.5)) << "known at that time";
}

TEST_F(JointMergerTest, EncodersMayWrap) {
  send(free_, 0, 1.00, 3.1);
  send(free_, 1, 1.01, -0.5);
  const auto merged = send(free_, 0, 1.02, 3.2 - 2.0 * EIGEN_PI);
  ASSERT_TRUE(merged);
  EXPECT_NEAR(merged->q[0], 3.15, 1e-6);
}

TEST_F(JointMergerTest, ForgetsAnotherRun) {
  send(limited_, 0, 5.0, 0.5);
  send(limited_, 1, 5.0, 0.5);
  limited_.forget();
  EXPECT_FALSE(send(limited_, 0, 1.0, 0.5));
  EXPECT_TRUE(send(limited_, 1, 1.0, 0.5));
}

}  // namespace
}  // namespace parallel_aspects
