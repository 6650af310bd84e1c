// SPDX-License-Identifier: BSD-3-Clause
//
// Distances, levels and hazards in the state.
#include "ros/monitor/decimation.h"
#include "ros/monitor/robot_monitor_fixture.h"
#include "ros/monitor/threshold_offer.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace parallel_aspects {
namespace {

using test::expect_says_nothing;
using test::RobotMonitorTest;
using test::start_at_pose;

class HazardState : public RobotMonitorTest {};

// Between two measurements distances are bounded by the motion since; the nearest boundary here is det A = 0.
TEST_F(HazardState, DistancesAreBoundedAndJudged) {
  NodeOptions options = start_at_pose(4.5, 8.0);
  RobotMonitor unlimited(mechanism_, options);
  const auto first = unlimited.update(joint_values(4.5, 8.0, {1, -1}, 1.0), at(1.0));
  EXPECT_TRUE(std::isnan(first.state->parallel_distance.lower)) << "not measured yet";
  unlimited.work();
  const AspectState here = *unlimited.update(joint_values(4.5, 8.0, {1, -1}, 1.01), at(1.01)).state;
  EXPECT_EQ(here.level, AspectState::NO_THRESHOLD) << "however far the nearest one is";
  EXPECT_GE(here.level, AspectState::STOP);
  EXPECT_EQ(here.reason.find("no threshold is set: the nearest parallel singularity may be "), 0U)
      << here.reason;
  EXPECT_EQ(first.state->reason, "no threshold is set") << "nor any distance known";
  EXPECT_FALSE(here.escape_twist.empty());
  ASSERT_GT(here.parallel_distance.lower, 0.0);
  EXPECT_GE(here.parallel_distance.upper, here.parallel_distance.lower);
  EXPECT_TRUE(std::isnan(first.state->stand_off)) << "not measured yet";
  EXPECT_GT(here.stand_off, 0.0);
  EXPECT_LT(here.stand_off, here.parallel_distance.lower);
  EXPECT_EQ(here.limit_distance.lower, std::numeric_limits<double>::infinity());
  const AspectState near = *unlimited.update(joint_values(4.5, 8.2, {1, -1}, 1.1), at(1.1)).state;
  EXPECT_NEAR(near.parallel_distance.lower, here.parallel_distance.lower - 0.2, 1e-6);
  EXPECT_NEAR(near.parallel_distance.upper, here.parallel_distance.upper + 0.2, 1e-6);

  options.thresholds.parallel_warn = here.parallel_distance.lower + 0.01;
  options.thresholds.parallel_stop = here.parallel_distance.lower - 0.1;
  RobotMonitor monitor(mechanism_, options);
  monitor.update(joint_values(4.5, 8.0, {1, -1}, 1.0), at(1.0));
  monitor.work();
  const AspectState warned = *monitor.update(joint_values(4.5, 8.0, {1, -1}, 1.01), at(1.01)).state;
  EXPECT_EQ(warned.level, AspectState::WARN);
  EXPECT_NE(warned.reason.find("parallel singularity"), std::string::npos) << warned.reason;
  const AspectState stopped = *monitor.update(joint_values(4.5, 8.2, {1, -1}, 1.1), at(1.1)).state;
  EXPECT_EQ(stopped.level, AspectState::STOP) << "it may be that much closer now";
}

TEST_F(HazardState, AMessageThatNobodyHasFilledIsNoLevel) {
  EXPECT_LT(AspectState().level, AspectState::CLEAR);
  EXPECT_EQ(unknown_state(*mechanism_->manipulator(), {}, {}).level, AspectState::UNKNOWN);
}

// Straight towards the nearest pose with det A = 0 of the present mode, and back: a share of the way and a
// time that go on in small steps.
class NearDeterminantZero : public RobotMonitorTest {
 protected:
  // Until the status is another one.
  AspectState go_to(double share) {
    for (const std::uint8_t code = state_.status.code;
         std::abs(share - share_) > 1e-9 && state_.status.code == code;) {
      share_ += std::clamp(share - share_, -0.001, 0.001);
      time_ += 0.01;
      if (state_.level != 0) last_ = state_;
      state_ = *monitor_
                    .update(joint_values(at_share().position.x(), at_share().position.y(), {1, -1}, time_),
                            at(time_))
                    .state;
      monitor_.work();
    }
    return state_;
  }
  Pose at_share() const {
    Pose pose = start_;
    pose.position += share_ * (nearest_.witness.position - start_.position);
    return pose;
  }
  NodeOptions options() const {
    NodeOptions options = start_at_pose(4.5, 8.0);
    options.thresholds.parallel_warn = 0.1 * nearest_.upper;
    return options;
  }

  const Pose start_ = test::pose_at(4.5, 8.0);
  const BoundaryDistance nearest_ = BoundaryDistanceMeter(mechanism_->manipulator())
                                        .measure(start_, *WorkingMode::from_signs({1, -1}))
                                        .parallel;
  RobotMonitor monitor_{mechanism_, options()};
  double share_ = -0.001, time_ = 1.0;
  AspectState state_, last_;  // present, and before
};

TEST_F(NearDeterminantZero, ReportsTheLastProvedHazardWhileLostAndUntilItIsClearOfThat) {
  const AspectState lost = go_to(1.5);
  EXPECT_EQ(last_.level, AspectState::WARN);
  EXPECT_EQ(last_.last_hazard.kind, LastHazard::NONE);
  EXPECT_TRUE(std::isnan(last_.last_hazard.lower));
  EXPECT_EQ(lost.status.code, Status::AMBIGUOUS) << lost.status.message;
  expect_says_nothing(lost);
  EXPECT_EQ(lost.last_hazard.kind, LastHazard::PARALLEL_SINGULARITY);
  EXPECT_EQ(lost.last_hazard.stamp, last_.header.stamp);
  EXPECT_EQ(lost.last_hazard.lower, last_.parallel_distance.lower);
  EXPECT_LT(lost.last_hazard.speed, 0.0);
  EXPECT_NE(lost.reason.find("approached"), std::string::npos) << lost.reason;

  // Steps may be made good on the way, and lost again.
  while (std::abs(share_ - 0.95) > 1e-9) go_to(0.95);
  EXPECT_GE(state_.last_hazard.stamp, lost.last_hazard.stamp);
  ASSERT_EQ(monitor_.start_near(at_share(), at(time_)).code, Status::OK);
  state_.status.code = Status::OK;
  const AspectState near = go_to(0.94);
  EXPECT_EQ(near.level, AspectState::WARN) << near.reason;
  EXPECT_GE(near.last_hazard.stamp, lost.last_hazard.stamp);
  const AspectState held = go_to(0.895);
  EXPECT_EQ(held.level, AspectState::WARN) << "within the hysteresis: " << held.reason;
  EXPECT_EQ(held.last_hazard.kind, LastHazard::PARALLEL_SINGULARITY);
  const AspectState clear = go_to(0.8);
  EXPECT_EQ(clear.level, AspectState::CLEAR) << clear.reason;
  EXPECT_EQ(clear.last_hazard.kind, LastHazard::NONE);
}

// One publisher for each joint: what loses the assembly mode here is the singularity, so that messages of all
// joints are no remedy.
TEST_F(NearDeterminantZero, IsSaidToBeTheCauseAlsoOfPartialJointStates) {
  AspectState state;
  for (int i = 0; i < 3000 && (i < 10 || state.status.code == Status::OK); ++i) {
    share_ += 0.0005;
    time_ += 0.005;
    auto message = joint_values(at_share().position.x(), at_share().position.y(), {1, -1}, time_);
    const auto joint = static_cast<std::size_t>(i % 2);
    message.name = {message.name[joint]};
    message.position = {message.position[joint]};
    const auto merged = monitor_.update(message, at(time_), joint == 0 ? "/one" : "/two").state;
    if (merged) state = *merged;
    monitor_.work();
  }
  EXPECT_EQ(state.status.code, Status::AMBIGUOUS) << state.status.message;
  EXPECT_GT(share_, 0.7);
  EXPECT_NE(state.status.message.find("det A = 0"), std::string::npos) << state.status.message;
  EXPECT_EQ(state.status.message.find("in one message"), std::string::npos) << state.status.message;
}

TEST(StandOffWarning, IsGivenWhereAThresholdLiesInside) {
  StandOffEstimate estimate;
  EXPECT_EQ(message_of(estimate, {}), "") << "no parallel singularity was found";
  EXPECT_EQ(warning_of(estimate, 0.1, {}), "");
  estimate.largest = 0.14;
  estimate.poses = 50;
  EXPECT_NE(message_of(estimate, {}).find("0.14 m"), std::string::npos);
  EXPECT_NE(message_of(estimate, {}).find("estimate"), std::string::npos);
  EXPECT_EQ(warning_of(estimate, 0.2, {}), "");
  EXPECT_EQ(warning_of(estimate, 0.0, {}), "") << "there is no threshold";
  EXPECT_NE(warning_of(estimate, 0.1, {}).find("parallel_stop"), std::string::npos);
}

// A wrist is told angles, and told its thresholds in them: nothing says m of a number in rad or the reverse.
TEST(DistancesOfWrists, AreAngles) {
  for (const char* name : {"agile_eye", "spherical_3rrr"}) {
    const DistanceUnit unit(*test::shipped(name)->manipulator());
    ASSERT_TRUE(unit.is_angle()) << name;
    ThresholdParameters given;
    given.parallel_warn = 1.0;
    given.parallel_stop = 0.5;
    given.serial_stop = 1e6;
    const DistanceThresholds::Options options = thresholds_of(given, unit);
    EXPECT_DOUBLE_EQ(options[0].warn, 2.0 * std::sin(0.5));
    EXPECT_DOUBLE_EQ(options[1].stop, 2.0) << "no chord is longer";
    DistanceThresholds thresholds(options);
    const double inf = std::numeric_limits<double>::infinity();
    const auto level_at = [&](double angle) {
      return thresholds.update({2.0 * std::sin(0.5 * angle), inf, inf}).level;
    };
    EXPECT_EQ(level_at(1.001), ThresholdLevel::clear);
    EXPECT_EQ(level_at(0.999), ThresholdLevel::warn);
    EXPECT_EQ(reason_of(thresholds.state(), unit),
              "warn: the nearest parallel singularity may be 0.999 rad away; the threshold is 1 rad");
    EXPECT_EQ(level_at(0.499), ThresholdLevel::stop);
    const auto last = std::make_optional(ProvedHazard{Hazard::limit, 2.0 * std::sin(0.125), 0.1, 1.0});
    EXPECT_NE(reason_of(last, unit).find("0.25 rad away"), std::string::npos);
    EXPECT_NEAR(unit.displayed_speed(2.0 * std::sin(0.5), std::cos(0.5)), 1.0, 1e-12);
  }
  EXPECT_FALSE(DistanceUnit(*test::shipped("five_bar")->manipulator()).is_angle());
}

// What is offered can be used as it is, and noise of the encoders does not hide the assembly mode there.
TEST(ThresholdOffer, CanBePasted) {
  for (const char* name : {"five_bar", "delta", "three_rrr", "stewart", "spherical_3rrr"}) {
    const auto mechanism = test::shipped(name);
    const DistanceUnit unit(*mechanism->manipulator());
    StandOffEstimate estimate;
    for (const double largest : {0.0, 0.0123, 0.1 * mechanism->manipulator()->size()}) {
      estimate.largest = largest;
      estimate.poses = 1;
      const std::string offer = threshold_offer(*mechanism, estimate);
      const std::size_t begin = offer.find("thresholds: {"), end = offer.find('}', begin);
      ASSERT_NE(end, std::string::npos) << offer;
      const YAML::Node given = YAML::Load(offer.substr(begin, end + 1 - begin))["thresholds"];
      ThresholdParameters parameters;
      parameters.parallel_stop = given["parallel_stop"].as<double>();
      parameters.serial_stop = given["serial_stop"].as<double>();
      parameters.limit_stop = given["limit_stop"].as<double>();
      EXPECT_EQ(given.size(), 3U);
      EXPECT_TRUE(problems_of(parameters, "thresholds/").empty()) << offer;
      EXPECT_EQ(warning_of(estimate, unit.length_of(parameters.parallel_stop), unit), "") << offer;
      EXPECT_NE(offer.find(std::string("} [") + unit.name() + "]"), std::string::npos) << offer;
      EXPECT_GT(parameters.serial_stop, 0.0);
      EXPECT_LT(parameters.serial_stop, 0.05 * mechanism->manipulator()->size()) << offer;
      EXPECT_NE(offer.find("velocity limits allow up to "), std::string::npos) << offer;
    }
  }
}

// A level that comes between two samples that are published is published too.
TEST(Decimation, ReportsLevelsThatChange) {
  Decimation tested(10);
  AspectState state;
  state.level = AspectState::CLEAR;
  EXPECT_TRUE(tested.differs(state));
  EXPECT_FALSE(tested.differs(state));
  state.level = AspectState::STOP;
  EXPECT_TRUE(tested.differs(state));
}

}  // namespace
}  // namespace parallel_aspects
