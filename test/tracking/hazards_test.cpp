// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/tracking/hazards.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double far = std::numeric_limits<double>::infinity();

DistanceThresholds thresholds() {
  return DistanceThresholds({ThresholdOptions{0.10, 0.04, 0.5}, {0.05, 0.0, 0.0}, {0.0, 0.0, 0.0}});
}

TEST(DistanceThresholds, TakeTheWorstLevelAndSayWhatItIsDueTo) {
  DistanceThresholds tested = thresholds();
  EXPECT_EQ(tested.state().level, ThresholdLevel::unknown);
  EXPECT_EQ(tested.update({0.2, 0.3, 0.001}).level, ThresholdLevel::clear);
  const ThresholdState warned = tested.update({0.09, 0.3, far});
  EXPECT_EQ(warned.level, ThresholdLevel::warn);
  EXPECT_EQ(warned.hazard, Hazard::parallel_singularity);
  EXPECT_EQ(warned.distance, 0.09);
  EXPECT_EQ(warned.threshold, 0.10);
  EXPECT_FALSE(warned.held);
  EXPECT_EQ(tested.update({0.09, 0.04, far}).hazard, Hazard::serial_singularity);
  const ThresholdState stopped = tested.update({0.03, 0.01, far});
  EXPECT_EQ(stopped.level, ThresholdLevel::stop);
  EXPECT_EQ(stopped.hazard, Hazard::parallel_singularity);
  EXPECT_EQ(stopped.threshold, 0.04);
}

TEST(DistanceThresholds, AreLeftAboveTheHysteresisOnly) {
  DistanceThresholds tested = thresholds();
  EXPECT_EQ(tested.update({0.039, far, far}).level, ThresholdLevel::stop);
  EXPECT_EQ(tested.update({0.059, far, far}).level, ThresholdLevel::stop);
  EXPECT_TRUE(tested.state().held);
  EXPECT_EQ(tested.update({0.061, far, far}).level, ThresholdLevel::warn);
  EXPECT_EQ(tested.update({0.059, far, far}).level, ThresholdLevel::warn);
  EXPECT_EQ(tested.update({0.149, far, far}).level, ThresholdLevel::warn);
  EXPECT_EQ(tested.update({0.151, far, far}).level, ThresholdLevel::clear);
  EXPECT_EQ(tested.update({0.149, far, far}).level, ThresholdLevel::clear);
}

TEST(DistanceThresholds, OrderLevelsByDanger) {
  EXPECT_LT(ThresholdLevel{}, ThresholdLevel::clear) << "what nobody has set is no level";
  EXPECT_LT(ThresholdLevel::clear, ThresholdLevel::warn);
  EXPECT_LT(ThresholdLevel::warn, ThresholdLevel::stop);
  EXPECT_LT(ThresholdLevel::stop, ThresholdLevel::unknown);
}

TEST(DistanceThresholds, TakeTheUnknownForTheWorst) {
  DistanceThresholds tested = thresholds();
  EXPECT_EQ(tested.update({unknown, far, far}).level, ThresholdLevel::unknown);
  EXPECT_TRUE(std::isnan(tested.state().distance));
  EXPECT_EQ(tested.update({unknown, 0.01, far}).level, ThresholdLevel::unknown);
  EXPECT_EQ(tested.state().hazard, Hazard::parallel_singularity);
  EXPECT_EQ(tested.update({0.03, unknown, far}).level, ThresholdLevel::unknown);
  EXPECT_EQ(tested.update({0.2, far, unknown}).level, ThresholdLevel::clear) << "it has no threshold";
  EXPECT_EQ(tested.lose().level, ThresholdLevel::unknown);
}

TEST(DistanceThresholds, HoldTheirHysteresisWhileNothingIsKnown) {
  DistanceThresholds tested = thresholds();
  EXPECT_EQ(tested.update({0.039, far, far}).level, ThresholdLevel::stop);
  tested.lose();
  EXPECT_EQ(tested.update({unknown, far, far}).level, ThresholdLevel::unknown);
  EXPECT_EQ(tested.update({0.059, far, far}).level, ThresholdLevel::stop);
}

TEST(DistanceThresholds, TheNearestIsOneThatIsKnown) {
  DistanceThresholds tested;
  EXPECT_EQ(tested.update({unknown, 0.3, 0.2}).level, ThresholdLevel::unset);
  EXPECT_EQ(tested.state().hazard, Hazard::limit);
}

constexpr HazardMemory::Speeds approaching{-0.1, 0.2, unknown};

TEST(HazardMemory, ReportsWhatWasProvedUntilTheRobotIsBackBeyondTheHysteresis) {
  DistanceThresholds levels = thresholds();
  HazardMemory memory;
  const auto see = [&](double parallel, double time) {
    levels.update({parallel, far, far});
    memory.see(levels, approaching, time);
    return memory.reported().has_value();
  };
  EXPECT_FALSE(see(0.2, 1.0));
  EXPECT_FALSE(see(0.03, 2.0)) << "it is in the present distances";
  levels.lose();
  memory.lose();
  ASSERT_TRUE(memory.reported());
  EXPECT_EQ(memory.reported()->hazard, Hazard::parallel_singularity);
  EXPECT_EQ(memory.reported()->distance, 0.03);
  EXPECT_EQ(memory.reported()->speed, -0.1);
  EXPECT_EQ(memory.reported()->time, 2.0);
  EXPECT_TRUE(see(unknown, 3.0));
  EXPECT_EQ(memory.reported()->time, 2.0);
  EXPECT_TRUE(see(0.149, 4.0)) << "within the hysteresis";
  EXPECT_EQ(memory.reported()->time, 2.0);
  EXPECT_FALSE(see(0.151, 5.0));
}

TEST(HazardMemory, HasNothingBeforeADistanceWasProved) {
  DistanceThresholds levels = thresholds();
  HazardMemory memory;
  memory.lose();
  EXPECT_FALSE(memory.reported());
  levels.update({unknown, far, far});
  memory.see(levels, approaching, 1.0);
  EXPECT_FALSE(memory.reported());
  levels.update({far, far, far});
  memory.see(levels, approaching, 2.0);
  memory.lose();
  EXPECT_FALSE(memory.reported()) << "there is no hazard";
  levels.update({0.3, far, far});
  memory.see(levels, approaching, 3.0);
  memory.forget();
  memory.lose();
  EXPECT_FALSE(memory.reported());
}

// Nothing says what is near, so that nothing is clear; one threshold of one hazard is enough.
TEST(DistanceThresholds, WithoutAnyThereIsNoLevel) {
  DistanceThresholds tested;
  EXPECT_FALSE(is_set(DistanceThresholds::Options{}));
  const ThresholdState near = tested.update({0.3, 1e-3, far});
  EXPECT_EQ(near.level, ThresholdLevel::unset);
  EXPECT_GE(near.level, ThresholdLevel::stop);
  EXPECT_EQ(near.hazard, Hazard::serial_singularity);
  EXPECT_EQ(near.distance, 1e-3);
  EXPECT_EQ(tested.update({unknown, unknown, unknown}).level, ThresholdLevel::unset);
  EXPECT_EQ(tested.lose().level, ThresholdLevel::unknown);
  for (std::size_t i = 0; i < hazard_count; ++i) {
    DistanceThresholds::Options one;
    one[i].warn = 0.1;
    EXPECT_TRUE(is_set(one));
    tested.set_options(one);
    EXPECT_EQ(tested.update({far, far, far}).level, ThresholdLevel::clear);
  }
}

TEST(DistanceThresholds, RefuseWhatMakesNoSense) {
  EXPECT_TRUE(problems_of(ThresholdOptions{0.1, 0.05, 0.1}).empty());
  EXPECT_TRUE(problems_of(ThresholdOptions{0.0, 0.05, 0.0}).empty());
  EXPECT_EQ(problems_of(ThresholdOptions{0.05, 0.1, 0.1}).size(), 1U);
  EXPECT_EQ(problems_of(ThresholdOptions{-1.0, unknown, far}).size(), 3U);
}

TEST(ApproachSpeed, IsTheSlopeOfTheLastSamples) {
  ApproachSpeed tested(0.1, 0.01);
  EXPECT_EQ(tested.approach(), Approach::unknown);
  tested.add(1e9, 5.0);
  EXPECT_EQ(tested.approach(), Approach::unknown);
  for (int i = 1; i <= 200; ++i) tested.add(1e9 + 0.01 * i, 5.0 - 0.02 * i);
  EXPECT_NEAR(tested.speed(), -2.0, 1e-4);
  EXPECT_EQ(tested.approach(), Approach::approaching);
  for (int i = 201; i <= 230; ++i) tested.add(1e9 + 0.01 * i, 1.0);
  EXPECT_NEAR(tested.speed(), 0.0, 1e-9);
  EXPECT_EQ(tested.approach(), Approach::steady);
  for (int i = 231; i <= 260; ++i) tested.add(1e9 + 0.01 * i, 0.01 * i);
  EXPECT_EQ(tested.approach(), Approach::leaving);
}

TEST(ApproachSpeed, BeginsAnewWhereTimeOrValueMakesNoSense) {
  ApproachSpeed tested;
  tested.add(1.0, 1.0);
  tested.add(1.01, 0.9);
  EXPECT_TRUE(tested.known());
  tested.add(1.005, 0.8);
  EXPECT_FALSE(tested.known());
  tested.add(1.02, 0.7);
  EXPECT_NEAR(tested.speed(), -0.1 / 0.015, 1e-9);
  tested.add(1.03, unknown);
  EXPECT_EQ(tested.approach(), Approach::unknown);
}

}  // namespace
}  // namespace parallel_aspects
