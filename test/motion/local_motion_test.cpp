// SPDX-License-Identifier: BSD-3-Clause
#include "motion/demo_rounds.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/tracking/tracker.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

bool anything(const Pose&, const JointVector&) { return true; }

class LocalMotion : public testing::TestWithParam<const char*> {
 protected:
  LocalMotion() {
    const YAML::Node config =
        YAML::Load(test::source_file("config/robots/" + std::string(GetParam()) + ".yaml"));
    const auto values = config["start"]["pose"].as<std::vector<double>>();
    start_ = *pose_from_coordinates(
        robot_.task_space(),
        Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  }

  // The tracker, which knows only the actuated joints, sees one assembly mode in one working mode all along.
  void follow(const std::vector<JointVector>& joint_values, const WorkingMode& mode) const {
    TrackerOptions straight;
    straight.samples.path_bend = 0.0;
    straight.samples.encoder_noise = 0.0;
    Tracker tracker(mechanism_->manipulator(), straight);
    ASSERT_TRUE(tracker.start_near(0.0, joint_values.front(), start_, 1e-6 * robot_.size()));
    EXPECT_EQ(tracker.state().mode, mode);
    double farthest = 0.0;
    for (std::size_t i = 1; i < joint_values.size(); ++i) {
      EXPECT_TRUE(robot_.within_limits(joint_values[i]));
      tracker.update(0.1 * static_cast<double>(i), joint_values[i]);
      ASSERT_EQ(tracker.state().status, TrackStatus::tracking) << "corner " << i;
      ASSERT_TRUE(tracker.transitions().empty()) << "corner " << i;
      for (const Leg& leg : robot_.legs())
        farthest = std::max(
            farthest, (tracker.state().pose.transform(leg.anchor) - start_.transform(leg.anchor)).norm());
    }
    EXPECT_GT(farthest, 0.002 * robot_.size());
    std::cout << to_string(mode) << " moves " << farthest / robot_.size() << " of the size\n";
    EXPECT_LT((tracker.state().pose.position - start_.position).norm(), 1e-9 * robot_.size());
    EXPECT_LT(tracker.state().pose.orientation.angularDistance(start_.orientation), 1e-7);
  }

  // Eight at most under the sanitizers, spread over all.
  std::vector<WorkingMode> some_modes() const {
    const std::vector<WorkingMode> all = working_modes(robot_);
    const std::size_t step = test::is_sanitized ? std::max<std::size_t>(1, all.size() / 8) : 1;
    std::vector<WorkingMode> some;
    for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
    return some;
  }

  const std::shared_ptr<const Mechanism> mechanism_ = test::shipped(GetParam());
  const Manipulator& robot_ = *mechanism_->manipulator();
  Pose start_;
};

TEST_P(LocalMotion, IsARoundThatTheTrackerFollowsWithoutATransition) {
  int found = 0;
  for (const WorkingMode& mode : some_modes()) {
    const auto joint_values = plan_local_motion(robot_, start_, mode, anything);
    if (joint_values.empty()) continue;
    ++found;
    SCOPED_TRACE(to_string(mode));
    follow(joint_values, mode);
  }
  EXPECT_GT(found, 0);
}

TEST_P(LocalMotion, IsEmptyWhereNothingIsAllowed) {
  for (const WorkingMode& mode : some_modes())
    EXPECT_TRUE(
        plan_local_motion(robot_, start_, mode, [](const auto&, const auto&) { return false; }).empty());
}

INSTANTIATE_TEST_SUITE_P(ShippedRobots, LocalMotion,
                         testing::Values("five_bar", "bipod", "three_rrr", "three_rpr", "three_prr", "delta",
                                         "linear_delta", "hexa", "stewart", "six_pus", "agile_eye",
                                         "spherical_3rrr"),
                         [](const auto& robot) { return std::string(robot.param); });

TEST(LocalMotionOfAFiveBar, IsEmptyWhereTheRobotDoesNotReach) {
  Pose pose;
  pose.position << 40.0, 0.0, 0.0;
  EXPECT_TRUE(plan_local_motion(*test::five_bar(), pose, WorkingMode(2), anything).empty());
}

}  // namespace
}  // namespace parallel_aspects
