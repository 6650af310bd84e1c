// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include <cmath>
#include <random>

namespace parallel_aspects {
namespace {

class FiveBarMechanism : public ::testing::Test {
 protected:
  const std::shared_ptr<const Mechanism> mechanism_ = test::shipped("five_bar");
  const Manipulator& manipulator_ = *mechanism_->manipulator();
};

Pose at(double x, double y) {
  Pose pose;
  pose.position << x, y, 0.0;
  return pose;
}

// Two robots with the same names of links have one tf graph.
TEST_F(FiveBarMechanism, ItsBaseFrameTakesAPrefix) {
  EXPECT_EQ(manipulator_.base_frame(), "base_link");
  const auto left = load_mechanism(test::source_file("urdf/five_bar.urdf"), "urdf",
                                   test::source_file("config/robots/five_bar.yaml"), "yaml", "left");
  EXPECT_EQ(left->manipulator()->base_frame(), "left/base_link");
  EXPECT_EQ(left->link_names(), mechanism_->link_names());
  EXPECT_EQ(left->link_names().front(), "base_link");
}

TEST_F(FiveBarMechanism, IsRecognisedAsThePaperDrawsIt) {
  EXPECT_EQ(manipulator_.name(), "five_bar");
  EXPECT_EQ(manipulator_.task_space(), TaskSpace::T2);
  ASSERT_EQ(manipulator_.leg_count(), 2u);
  EXPECT_TRUE(manipulator_.task_frame().isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  EXPECT_EQ(mechanism_->platform_link(), "tool");
  EXPECT_EQ(mechanism_->mobility(), 2);
  EXPECT_EQ(mechanism_->idle_degrees_of_freedom(), 0);
  const std::array<double, 2> cranks{8.0, 5.0}, rods{5.0, 8.0}, bases{0.0, 9.0};
  for (std::size_t j = 0; j < 2; ++j) {
    const Leg& leg = manipulator_.leg(j);
    const auto& actuation = std::get<RevoluteActuation>(leg.actuation);
    EXPECT_EQ(leg.actuated_joint, "crank_" + std::to_string(j + 1) + "_joint");
    EXPECT_EQ(actuation.radius, cranks[j]);
    EXPECT_EQ(leg.rod_length, rods[j]);
    EXPECT_EQ(actuation.center, Eigen::Vector3d(bases[j], 0.0, 0.0));
    EXPECT_EQ(actuation.axis, Eigen::Vector3d::UnitZ());
    EXPECT_EQ(actuation.zero_direction, Eigen::Vector3d::UnitX());
    EXPECT_EQ(leg.anchor, Eigen::Vector3d::Zero());
    EXPECT_FALSE(leg.limits.limited());
  }
}

// Joint values at P = (4.5, 8) by elbow signs, from independent computation.
TEST_F(FiveBarMechanism, GivesTheReferenceDriveValues) {
  const std::vector<std::array<double, 2>> expected{{1.633334, 3.138465}, {1.633334, 1.027907}};
  for (const auto& [q1, q2] : expected) {
    bool found = false;
    for (const InverseSolution& solution : inverse_in_all_modes(manipulator_, at(4.5, 8.0)))
      found = found || (std::abs(solution.q[0] - q1) < 1e-6 && std::abs(solution.q[1] - q2) < 1e-6);
    EXPECT_TRUE(found) << q1 << ", " << q2;
  }
}

// The paper's passive angles: theta3 and theta4 are the directions of the rods.
TEST_F(FiveBarMechanism, CompletesTheElbows) {
  const Pose pose = at(4.5, 8.0);
  for (const InverseSolution& solution : inverse_in_all_modes(manipulator_, pose)) {
    ASSERT_EQ(solution.status, InverseStatus::solved);
    Eigen::VectorXd joints(4);
    ASSERT_TRUE(mechanism_->complete(pose, solution.q, joints));
    const double theta3 = joints[0] + joints[1], theta4 = joints[2] + joints[3];
    EXPECT_NEAR(8.0 * std::cos(joints[0]) + 5.0 * std::cos(theta3), 4.5, 1e-12);
    EXPECT_NEAR(8.0 * std::sin(joints[0]) + 5.0 * std::sin(theta3), 8.0, 1e-12);
    EXPECT_NEAR(9.0 + 5.0 * std::cos(joints[2]) + 8.0 * std::cos(theta4), 4.5, 1e-12);
    EXPECT_NEAR(5.0 * std::sin(joints[2]) + 8.0 * std::sin(theta4), 8.0, 1e-12);
    EXPECT_GT(solution.mode.sign(0) * std::sin(joints[1]), 0.0) << "B11 = L1 L2 sin(theta3 - theta1)";
  }
}

TEST_F(FiveBarMechanism, NamesTheJointsInTheOrderOfTheFile) {
  const std::vector<std::string> expected{"crank_1_joint", "elbow_1_joint", "crank_2_joint", "elbow_2_joint"};
  EXPECT_EQ(mechanism_->joint_names(), expected);
}

TEST_F(FiveBarMechanism, RefusesToCompleteWhatDoesNotClose) {
  Eigen::VectorXd joints = Eigen::VectorXd::Constant(4, 7.0);
  JointVector q(2);
  q << 0.0, 0.0;
  EXPECT_FALSE(mechanism_->complete(at(4.5, 8.0), q, joints));
  EXPECT_FALSE(mechanism_->complete(at(std::nan(""), 8.0), q, joints));
  q[1] = std::nan("");
  EXPECT_FALSE(mechanism_->complete(at(4.5, 8.0), q, joints));
  EXPECT_FALSE(mechanism_->complete(at(4.5, 8.0), JointVector::Zero(3), joints));
  EXPECT_EQ(joints, Eigen::VectorXd::Constant(4, 7.0));
}

TEST_F(FiveBarMechanism, AssemblesOffItsZeroConfiguration) {
  const AssembledConfiguration assembled = mechanism_->assembled();
  Eigen::VectorXd joints(4);
  EXPECT_TRUE(mechanism_->complete(assembled.pose, assembled.q, joints));
}

}  // namespace
}  // namespace parallel_aspects
