// SPDX-License-Identifier: BSD-3-Clause
// Where a robot is shown: within all limits, and at its stated start.
#include "parallel_aspects/kinematics/kinematics.h"
#include "urdf/mechanism_recognition.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include <algorithm>
#include <string>

namespace parallel_aspects {
namespace {

using test::Description;

Description described(const std::string& urdf, const std::string& config) {
  return {test::source_file("test/data/described/" + urdf + ".urdf"),
          test::source_file("test/data/described/" + config + ".yaml")};
}

void expect_within_limits(const Mechanism& mechanism, const AssembledConfiguration& home) {
  const auto solutions = inverse_in_all_modes(*mechanism.manipulator(), home.pose);
  EXPECT_TRUE(std::any_of(solutions.begin(), solutions.end(), [&](const InverseSolution& solution) {
    return solution.status == InverseStatus::solved && (solution.q - home.q).isZero(1e-12);
  }));
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism.joint_names().size()));
  ASSERT_TRUE(mechanism.complete(home.pose, home.q, positions));
  const auto outside = mechanism.joint_outside_limits(positions);
  EXPECT_FALSE(outside) << mechanism.joint_names()[*outside] << " at "
                        << positions[static_cast<Eigen::Index>(*outside)];
}

double tilt(const Pose& pose) { return pose.orientation.angularDistance(Eigen::Quaterniond::Identity()); }

// Frames are parallel at zero, where struts and joints with limits from 0 to 6.283185 stand on them; the
// loops are open by some millimetres.
TEST(HomeConfiguration, IsBesideAZeroOnItsLimits) {
  for (const char* name : {"open_hexapod", "hexapod_at_limits"}) {
    const auto mechanism = test::load(described(name, "hexapod"));
    const AssembledConfiguration home = mechanism->home();
    expect_within_limits(*mechanism, home);
    EXPECT_LT(tilt(home.pose), 0.05) << name;
    EXPECT_LT((home.pose.position - Eigen::Vector3d(0.0, 0.0, 0.3)).norm(), 0.02) << name;
  }
}

TEST(HomeConfiguration, IsTheStatedStart) {
  const auto mechanism = test::load(described("short_strokes", "short_strokes"));
  const AssembledConfiguration home = mechanism->home();
  EXPECT_EQ(home.pose.position, Eigen::Vector3d(0.0, 0.0, 0.08));
  EXPECT_EQ(tilt(home.pose), 0.0);
  expect_within_limits(*mechanism, home);
  EXPECT_TRUE(mechanism->notes().empty());
}

TEST(HomeConfiguration, IsNoStartBeyondReach) {
  Description robot = described("short_strokes", "short_strokes");
  robot.change_config("0.0, 0.0, 0.08", "0.0, 0.0, 0.3");
  const auto mechanism = test::load(robot);
  expect_within_limits(*mechanism, mechanism->home());
  EXPECT_LT(mechanism->home().pose.position.z(), 0.11);
  ASSERT_EQ(mechanism->notes().size(), 1U);
  EXPECT_EQ(mechanism->notes().front(),
            "robot.yaml states a start.pose that the joints of robot.urdf do not reach within their limits; "
            "its home is the pose in which the loops were closed.");
}

TEST(HomeConfiguration, IsWithinTheLimitsOfShippedRobots) {
  for (const char* name :
       {"agile_eye", "bipod", "delta", "five_bar", "hexa", "linear_delta", "six_pus", "spherical_3rrr",
        "stewart", "three_prr", "three_rpr", "three_rrr", "ankle", "skew_wrist", "tilt_table", "four_bar"}) {
    SCOPED_TRACE(name);
    const auto mechanism = test::load(test::shipped_text(name));
    expect_within_limits(*mechanism, mechanism->home());
  }
}

}  // namespace
}  // namespace parallel_aspects
