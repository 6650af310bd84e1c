// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/urdf_frames.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace parallel_aspects {
namespace {

struct Expected {
  std::string robot;
  TaskSpace space;
  std::string kind;
  std::size_t modes;
};

void PrintTo(const Expected& expected, std::ostream* stream) { *stream << expected.robot; }

class ShippedRobot : public ::testing::TestWithParam<Expected> {
 protected:
  const std::shared_ptr<const Mechanism> mechanism_ = test::shipped(GetParam().robot);
  const Manipulator& manipulator_ = *mechanism_->manipulator();
  const YAML::Node config_ = YAML::Load(test::source_file("config/robots/" + GetParam().robot + ".yaml"));
};

// The pose coordinates are the values of the joints of the passive chain.
void expect_hinges_at(const Pose& pose, const std::map<std::string, double>& joints) {
  const bool is_one = joints.count("rocker_joint") > 0;
  const PoseCoordinates angles = pose_coordinates(is_one ? TaskSpace::R1 : TaskSpace::R2, pose);
  std::vector<const char*> names{"rocker_joint"};
  if (joints.count("first_joint") > 0) names = {"first_joint", "second_joint"};
  if (joints.count("pitch_joint") > 0) names = {"pitch_joint", "roll_joint"};
  if (joints.count("strut_1_joint") > 0) names = {"roll_joint", "pitch_joint"};
  for (std::size_t i = 0; i < names.size(); ++i)
    EXPECT_NEAR(std::remainder(joints.at(names[i]) - angles[static_cast<Eigen::Index>(i)], 2.0 * EIGEN_PI),
                0.0, 1e-11)
        << names[i];
}

TEST_P(ShippedRobot, IsRecognised) {
  EXPECT_EQ(manipulator_.name(), GetParam().robot);
  EXPECT_EQ(manipulator_.task_space(), GetParam().space);
  if (GetParam().space != TaskSpace::R2) {
    EXPECT_TRUE(manipulator_.task_frame().isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  }
  EXPECT_EQ(static_cast<std::size_t>(mechanism_->mobility()), degrees_of_freedom(GetParam().space));
  EXPECT_EQ(mechanism_->idle_degrees_of_freedom(), 0);
  EXPECT_EQ(working_modes(manipulator_).size(), GetParam().modes);
  for (std::size_t j = 0; j < manipulator_.leg_count(); ++j) {
    EXPECT_EQ(manipulator_.leg(j).kind().name, GetParam().kind);
    EXPECT_EQ(manipulator_.leg(j).actuated_joint,
              config_["mechanism"]["actuated_joints"][j].as<std::string>());
  }
  EXPECT_TRUE(mechanism_->notes().empty()) << mechanism_->notes().front();
}

TEST_P(ShippedRobot, StartsAtAPoseThatItReachesOffItsSingularities) {
  const auto numbers = config_["start"]["pose"].as<std::vector<double>>();
  const auto pose = pose_from_coordinates(manipulator_.motions(),
                                          PoseCoordinates(Eigen::Map<const Eigen::VectorXd>(
                                              numbers.data(), static_cast<Eigen::Index>(numbers.size()))));
  ASSERT_TRUE(pose);
  const auto solutions = inverse_in_all_modes(manipulator_, *pose);
  const bool reached = std::any_of(solutions.begin(), solutions.end(), [&](const InverseSolution& solution) {
    return solution.status == InverseStatus::solved &&
           std::abs(direct_matrix(manipulator_, *pose, solution.q).normalized().determinant()) > 1e-6;
  });
  EXPECT_TRUE(reached);
}

// Every passive joint, at random poses in all working modes, against the closures as urdfdom sees the links.
TEST_P(ShippedRobot, CompletesItsPassiveJoints) {
  const auto model = urdf::parseURDF(test::source_file("urdf/" + GetParam().robot + ".urdf"));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism_->joint_names().size()));
  int completed = 0;
  for (int trial = 0; trial < 200; ++trial) {
    TaskVector step(static_cast<Eigen::Index>(manipulator_.leg_count()));
    for (double& entry : coefficients_of(step)) entry = 0.3 * manipulator_.size() * number(random);
    if (has_hinges(GetParam().space))
      step /= 0.3 * manipulator_.size();
    else if (has_rotation(GetParam().space))
      step.head(step.size() / 2) /= 0.3 * manipulator_.size();
    const Pose pose = displaced(manipulator_.motions(), mechanism_->assembled().pose, step);
    for (const InverseSolution& solution : inverse_in_all_modes(manipulator_, pose)) {
      if (solution.status == InverseStatus::out_of_reach) continue;
      ASSERT_TRUE(mechanism_->complete(pose, solution.q, positions)) << to_string(GetParam().space, pose);
      ++completed;
      std::map<std::string, double> joints;
      for (std::size_t k = 0; k < mechanism_->joint_names().size(); ++k)
        joints[mechanism_->joint_names()[k]] = positions[static_cast<Eigen::Index>(k)];
      for (std::size_t j = 0; j < manipulator_.leg_count(); ++j)
        EXPECT_EQ(joints.at(manipulator_.leg(j).actuated_joint), solution.q[static_cast<Eigen::Index>(j)]);
      for (const auto& closure : config_["mechanism"]["closures"]) {
        const auto one = test::link_frame(*model, closure["frames"][0].as<std::string>(), joints);
        const auto other = test::link_frame(*model, closure["frames"][1].as<std::string>(), joints);
        EXPECT_LT((one.translation() - other.translation()).norm(), 1e-12 * manipulator_.size());
      }
      if (has_hinges(GetParam().space)) {
        expect_hinges_at(pose, joints);
        continue;
      }
      const Eigen::Isometry3d platform = test::link_frame(*model, mechanism_->platform_link(), joints);
      EXPECT_LT((platform.translation() - pose.position).norm(), 1e-12 * manipulator_.size());
      if (!has_rotation(GetParam().space)) continue;
      EXPECT_LT((platform.linear() - pose.orientation.matrix()).norm(), 1e-11);
    }
  }
  EXPECT_GE(completed, 40);
}

// df/dX = 2 A and df/dq = -2 B, by central differences at random poses in random working modes.
TEST_P(ShippedRobot, HasTheMatricesThatItsEquationsHave) {
  const std::vector<WorkingMode> modes = working_modes(manipulator_);
  const double size = manipulator_.size(), tolerance = 1e-12 * size * size;
  const auto n = static_cast<Eigen::Index>(manipulator_.leg_count());
  const auto turns = static_cast<Eigen::Index>(rotational_degrees_of_freedom(GetParam().space));
  TaskVector twist = TaskVector::Constant(n, 1e-5 * size), change = twist;
  twist.head(turns).setConstant(1e-5);
  for (Eigen::Index j = 0; j < n; ++j)
    if (manipulator_.leg(static_cast<std::size_t>(j)).actuated_by_angle()) change[j] = 1e-5;
  std::mt19937 random(8);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  int compared = 0;
  for (int trial = 0; trial < 1000000 && compared < 2000; ++trial) {
    TaskVector step(n);
    for (Eigen::Index k = 0; k < n; ++k) step[k] = number(random) * (k < turns ? EIGEN_PI : 0.3 * size);
    const Pose pose = displaced(manipulator_.motions(), mechanism_->assembled().pose, step);
    const JointVector q = inverse(manipulator_, pose, modes[random() % modes.size()]).q;
    if (q.size() != n) continue;
    ++compared;
    const TaskMatrix a = direct_matrix(manipulator_, pose, q);
    const TaskVector b = inverse_diagonal(manipulator_, pose, q);
    for (Eigen::Index k = 0; k < n; ++k) {
      const TaskVector t = twist[k] * TaskVector::Unit(n, k), dq = change[k] * TaskVector::Unit(n, k);
      const TaskVector by_pose = residuals(manipulator_, displaced(manipulator_.motions(), pose, t), q) -
                                 residuals(manipulator_, displaced(manipulator_.motions(), pose, -t), q);
      const TaskVector by_joint =
          residuals(manipulator_, pose, q + dq) - residuals(manipulator_, pose, q - dq);
      ASSERT_LT((by_pose - 4.0 * (a * t)).cwiseAbs().maxCoeff(), tolerance)
          << to_string(GetParam().space, pose);
      ASSERT_LT((by_joint + 4.0 * b.cwiseProduct(dq)).cwiseAbs().maxCoeff(), tolerance)
          << to_string(GetParam().space, pose);
    }
  }
  EXPECT_EQ(compared, 2000);
}

INSTANTIATE_TEST_SUITE_P(
    Robots, ShippedRobot,
    ::testing::Values(Expected{"five_bar", TaskSpace::T2, "actuated revolute joint", 4},
                      Expected{"bipod", TaskSpace::T2, "strut", 1},
                      Expected{"three_rpr", TaskSpace::SE2, "strut", 1},
                      Expected{"three_rrr", TaskSpace::SE2, "actuated revolute joint", 8},
                      Expected{"three_prr", TaskSpace::SE2, "actuated prismatic joint", 8},
                      Expected{"delta", TaskSpace::T3, "actuated revolute joint", 8},
                      Expected{"linear_delta", TaskSpace::T3, "actuated prismatic joint", 8},
                      Expected{"stewart", TaskSpace::SE3, "strut", 1},
                      Expected{"hexa", TaskSpace::SE3, "actuated revolute joint", 64},
                      Expected{"six_pus", TaskSpace::SE3, "actuated prismatic joint", 64},
                      Expected{"ankle", TaskSpace::R2, "actuated revolute joint", 4},
                      Expected{"skew_wrist", TaskSpace::R2, "actuated revolute joint", 4},
                      Expected{"tilt_table", TaskSpace::R2, "strut", 1},
                      Expected{"four_bar", TaskSpace::R1, "actuated revolute joint", 2},
                      Expected{"agile_eye", TaskSpace::SO3, "actuated revolute joint", 8},
                      Expected{"spherical_3rrr", TaskSpace::SO3, "actuated revolute joint", 8}),
    [](const ::testing::TestParamInfo<Expected>& tested) { return tested.param.robot; });

// Three of the six direct solutions at these lengths (Innocenti and Parenti-Castelli).
TEST(ThreeRpr, HasThePublishedLengths) {
  const auto mechanism = test::shipped("three_rpr");
  for (const Eigen::Vector3d& coordinates : {Eigen::Vector3d(-8.72659533, 12.17566975, -0.98697424),
                                             Eigen::Vector3d(-14.89612810, 1.58296166, 0.24530953),
                                             Eigen::Vector3d(14.67394366, -3.01260312, 2.13290437)}) {
    const Pose pose = *pose_from_coordinates(TaskSpace::SE2, coordinates);
    const InverseSolution solution = inverse(*mechanism->manipulator(), pose, WorkingMode(3));
    ASSERT_EQ(solution.status, InverseStatus::solved);
    EXPECT_NEAR(solution.q[0], 14.98, 1e-6);
    EXPECT_NEAR(solution.q[1], 15.38, 1e-6);
    EXPECT_NEAR(solution.q[2], 12.0, 1e-6);
  }
}

// That of `test::ankle`, which is written in the task frame by hand.
TEST(Ankle, IsThatOfItsUrdf) {
  const auto loaded = test::shipped("ankle")->manipulator(), made = test::ankle();
  EXPECT_NEAR(loaded->motions().hinges.offset, 0.016, 1e-15);
  EXPECT_EQ(loaded->motions().hinges.twist, made->motions().hinges.twist);
  EXPECT_TRUE(loaded->task_frame().isApprox(made->task_frame(), 1e-14));
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_LT((loaded->leg(j).anchor - made->leg(j).anchor).norm(), 1e-14);
    EXPECT_NEAR(loaded->leg(j).rod_length, made->leg(j).rod_length, 1e-14);
    for (double q = -3.0; q < 3.0; q += 0.5)
      EXPECT_LT((loaded->leg(j).proximal_point(q) - made->leg(j).proximal_point(q)).norm(), 1e-14) << q;
  }
}

// ABB IRB 360-800: base 0.200, crank 0.235, rod 0.800, platform 0.045 m.
TEST(Delta, HasThePublishedLengths) {
  const auto mechanism = test::shipped("delta");
  for (const Leg& leg : mechanism->manipulator()->legs()) {
    const auto& actuation = std::get<RevoluteActuation>(leg.actuation);
    EXPECT_NEAR(actuation.center.norm(), 0.200, 1e-12);
    EXPECT_EQ(actuation.radius, 0.235);
    EXPECT_EQ(leg.rod_length, 0.800);
    EXPECT_NEAR(leg.anchor.norm(), 0.045, 1e-12);
    EXPECT_NEAR(actuation.zero_direction.dot(actuation.center), 0.200, 1e-12)
        << "cranks point outwards at zero";
  }
}

// Kossel Mini: sliders 0.145 - 0.0195 m from the axis, rods 0.215, platform 0.0199 m.
TEST(LinearDelta, HasThePublishedLengths) {
  const auto mechanism = test::shipped("linear_delta");
  for (const Leg& leg : mechanism->manipulator()->legs()) {
    const auto& actuation = std::get<PrismaticActuation>(leg.actuation);
    EXPECT_NEAR(actuation.origin.head<2>().norm(), 0.1255, 1e-12);
    EXPECT_NEAR((actuation.direction - Eigen::Vector3d::UnitZ()).norm(), 0.0, 1e-12);
    EXPECT_EQ(leg.rod_length, 0.215);
    EXPECT_NEAR(leg.anchor.norm(), 0.0199, 1e-12);
  }
}

}  // namespace
}  // namespace parallel_aspects
