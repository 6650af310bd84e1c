// SPDX-License-Identifier: BSD-3-Clause
#include "ros/joint_states/joint_merger.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
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

// Half way between two values both cones are equally wide, and the narrower the faster the straight way is.
TEST_F(JointMergerTest, AVelocityLimitBoundsTheWayBetweenValues) {
  SampleOptions options;
  options.path_bend = 1000.0;
  options.velocity_tolerance = 0.0;
  const auto at_half_way = [&](double last, double next) {
    JointMerger merger(with_velocity(2.0), options, window);
    send(merger, 0, 1.00, last);
    send(merger, 1, 1.01, -0.5);
    const auto merged = send(merger, 0, 1.02, next);
    EXPECT_TRUE(merged);
    EXPECT_NEAR(merged->q[0], 0.5 * (last + next), 1e-6);
    EXPECT_EQ(merged->uncertainty[1], 0.0);
    return merged->uncertainty[0];
  };
  EXPECT_EQ(at_half_way(0.0, 0.0), 0.0) << "at rest, by the last steps";
  EXPECT_NEAR(at_half_way(0.5, 0.50002), 0.02 / 8.0 * 1.0, 1e-4) << "the path may be bent, from rest";
  EXPECT_NEAR(at_half_way(0.5, 0.52), 0.01 * (2.0 + 1.0) - 0.02, 1e-6) << "no more than the limit allows";
  EXPECT_NEAR(at_half_way(0.5, 0.54), 0.0, 1e-6) << "at the limit there is one way";
  EXPECT_EQ(at_half_way(0.5, 0.6), 0.0) << "beyond it the step says so";
}

TEST_F(JointMergerTest, AWayThatIsStraightIsSoAfterThreeSteps) {
  double uncertainty = 1.0;
  for (int i = 0; i < 5; ++i) {
    send(free_, 0, 1.00 + 0.02 * i, 0.01 * i);
    if (const auto merged = send(free_, 1, 1.01 + 0.02 * i, -0.01 * i))
      uncertainty = merged->uncertainty.maxCoeff();
  }
  EXPECT_NEAR(uncertainty, 0.0, 1e-12);
  const auto bent = send(free_, 0, 1.10, 0.06);
  ASSERT_TRUE(bent);
  EXPECT_EQ(bent->stamp, at(1.09));
  EXPECT_NEAR(bent->uncertainty[0], 2.0 / 8.0 * 0.01, 1e-9);
  EXPECT_EQ(bent->uncertainty[1], 0.0) << "it is known there";
  send(free_, 1, 1.11, -0.05);
  EXPECT_NEAR(send(free_, 0, 1.12, 0.08)->uncertainty[0], 2.0 / 8.0 * 0.01, 1e-9) << "so lately it did bend";
  send(free_, 1, 1.13, -0.06);
  EXPECT_NEAR(send(free_, 0, 1.14, 0.10)->uncertainty[0], 0.0, 1e-9);
}

TEST_F(JointMergerTest, ValuesThatOvertookOneAnotherAreNoNewConfiguration) {
  send(limited_, 0, 1.00, 0.5);
  send(limited_, 1, 1.01, -0.5);
  ASSERT_TRUE(send(limited_, 0, 1.02, 0.5));
  EXPECT_FALSE(send(limited_, 1, 1.005, -0.4)) << "older than what is known of it";
  EXPECT_FALSE(send(limited_, 0, 1.02, 0.7)) << "that too";
  const auto merged = send(limited_, 1, 1.03, -0.5);
  ASSERT_TRUE(merged);
  EXPECT_EQ(merged->stamp, at(1.02));
  EXPECT_EQ(merged->q, values(0.5, -0.5));
}

TEST_F(JointMergerTest, ATimeMustLieBetweenValues) {
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
