// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/jacobian.h"

#include "model/linear_algebra.h"
#include "parallel_aspects/singularity/indices.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/texts.h"
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace parallel_aspects::ask {
namespace {

const std::array<const char*, 12> shipped_names{"agile_eye", "bipod",        "delta",     "five_bar",
                                                "hexa",      "linear_delta", "six_pus",   "spherical_3rrr",
                                                "stewart",   "three_prr",    "three_rpr", "three_rrr"};

/// The twist that takes one pose to another near it, of what the task space has.
TaskVector difference(TaskSpace space, const Pose& from, const Pose& to) {
  const Eigen::AngleAxisd turn(to.orientation * from.orientation.conjugate());
  const double angle = std::remainder(turn.angle(), 2.0 * EIGEN_PI);
  const Eigen::Vector3d w = angle * turn.axis(), v = to.position - from.position;
  const auto rotations = static_cast<Eigen::Index>(rotational_degrees_of_freedom(space));
  const auto n = static_cast<Eigen::Index>(degrees_of_freedom(space));
  TaskVector twist(n);
  twist << w.tail(rotations), v.head(n - rotations);
  return twist;
}

Pose nearest_solution(const Manipulator& robot, const JointVector& q, const Pose& pose) {
  Pose nearest;
  double least = 1e9;
  for (const AssemblyMode& each : direct(robot, q).solutions) {
    const double distance = anchor_distance(robot, each.pose, pose);
    if (distance < least) nearest = each.pose;
    least = std::min(least, distance);
  }
  return nearest;
}

TaskMatrix differences_of_direct(const Manipulator& robot, const JacobianAt& at, double step) {
  const auto n = static_cast<Eigen::Index>(robot.leg_count());
  TaskMatrix result(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const JointVector change = step * JointVector::Unit(n, j);
    const Pose ahead = nearest_solution(robot, at.q + change, at.pose),
               behind = nearest_solution(robot, at.q - change, at.pose);
    result.col(j) = difference(robot.task_space(), behind, ahead) / (2.0 * step);
  }
  return result;
}

TaskMatrix differences_of_inverse(const Manipulator& robot, const JacobianAt& at, double step) {
  const auto n = static_cast<Eigen::Index>(robot.leg_count());
  TaskMatrix result(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const TaskVector twist = step * TaskVector::Unit(n, k);
    const JointVector ahead = inverse(robot, displaced(robot.motions(), at.pose, twist), *at.mode).q,
                      behind = inverse(robot, displaced(robot.motions(), at.pose, -twist), *at.mode).q;
    for (Eigen::Index j = 0; j < n; ++j) {
      const double moved = ahead[j] - behind[j];
      const bool is_angle = robot.leg(static_cast<std::size_t>(j)).actuated_by_angle();
      result(j, k) = (is_angle ? std::remainder(moved, 2.0 * EIGEN_PI) : moved) / (2.0 * step);
    }
  }
  return result;
}

/// With two steps, so that the third derivatives drop out.
template <class Differences>
double relative_error(const TaskMatrix& matrix, const Manipulator& robot, const JacobianAt& at,
                      const Differences& differences_of) {
  constexpr double step = 4e-5;
  const TaskMatrix differences =
      (4.0 * differences_of(robot, at, 0.5 * step) - differences_of(robot, at, step)) / 3.0;
  return (matrix - differences).cwiseAbs().maxCoeff() / (1.0 + matrix.cwiseAbs().maxCoeff());
}

/// Far enough from singularities for differences to be of use.
bool is_well_conditioned(const Manipulator& robot, const JacobianAt& at) {
  return at.status == JacobianStatus::regular &&
         singularity_indices(robot, at.pose, at.q).smallest_singular_value > 0.1 &&
         serial_indices(robot, at.pose, at.q).minCoeff() > 0.1;
}

JacobianAnswer jacobians(const std::shared_ptr<const Manipulator>& robot, const JacobianQuestion& question) {
  Session session(robot);
  const auto outcome = answer(session, question);
  EXPECT_TRUE(outcome);
  return outcome.answer;
}

JacobianAnswer at_pose(const std::shared_ptr<const Manipulator>& robot, const Pose& pose) {
  JacobianQuestion question;
  question.pose = pose;
  return jacobians(robot, question);
}

class ShippedJacobian : public testing::TestWithParam<const char*> {};

TEST_P(ShippedJacobian, IsThatOfDifferencesOfTheKinematics) {
  const auto mechanism = test::shipped(GetParam());
  const auto& robot = mechanism->manipulator();
  const TaskSpace space = robot->task_space();
  const auto rotations = static_cast<Eigen::Index>(rotational_degrees_of_freedom(space));
  test::RandomRobots random(20261129);
  int compared = 0;
  for (int i = 0; i < 2000 && compared < (space == TaskSpace::SE3 ? 5 : 50); ++i) {
    TaskVector twist(static_cast<Eigen::Index>(degrees_of_freedom(space)));
    for (double& each : coefficients_of(twist)) each = random.uniform(-0.5, 0.5);
    twist.tail(twist.size() - rotations) *= 0.3 * robot->size();
    const JacobianAnswer found = at_pose(robot, displaced(space, mechanism->home().pose, twist));
    ASSERT_EQ(found.configurations.size(), working_modes(*robot).size());
    const auto pick = static_cast<std::size_t>(random.uniform(0.0, 0.999) *
                                               static_cast<double>(found.configurations.size()));
    const JacobianAt& at = found.configurations[pick];
    if (!is_well_conditioned(*robot, at)) continue;
    ++compared;
    const std::string where = to_string(space, at.pose) + " in " + to_string(*at.mode);
    ASSERT_LT(relative_error(*at.inverse_jacobian, *robot, at, differences_of_inverse), 1e-6) << where;
    ASSERT_LT(relative_error(*at.jacobian, *robot, at, differences_of_direct), 1e-6) << where;
    EXPECT_LT((*at.jacobian * *at.inverse_jacobian - TaskMatrix::Identity(twist.size(), twist.size())).norm(),
              1e-9)
        << where;
    EXPECT_EQ(*at.force_transmission, at.inverse_jacobian->transpose());
    EXPECT_GE(at.condition_number.value(), 1.0) << where;
  }
  EXPECT_GE(compared, 5);
}

INSTANTIATE_TEST_SUITE_P(Robots, ShippedJacobian, testing::ValuesIn(shipped_names),
                         [](const auto& info) { return std::string(info.param); });

// By the geometry of the mechanism alone: velocities by Cramer's rule, forces by the lever arms of the rods.
TEST(Jacobian, OfAFiveBarIsThatOfItsGeometry) {
  const auto robot = test::five_bar();
  const std::array<Eigen::Vector2d, 2> centers{Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(9.0, 0.0)};
  const std::array<double, 2> cranks{8.0, 5.0};
  for (const JacobianAt& at : at_pose(robot, Pose::planar(4.5, 8.0)).configurations) {
    std::array<Eigen::Vector2d, 2> rod, elbow_speed;
    Eigen::Matrix2d transmission;
    for (std::size_t j = 0; j < 2; ++j) {
      const double q = at.q[static_cast<Eigen::Index>(j)];
      const Eigen::Vector2d elbow = centers[j] + cranks[j] * Eigen::Vector2d(std::cos(q), std::sin(q));
      rod[j] = (Eigen::Vector2d(4.5, 8.0) - elbow).normalized();
      elbow_speed[j] = cranks[j] * Eigen::Vector2d(-std::sin(q), std::cos(q));
      const Eigen::Vector2d arm = elbow - centers[j];
      transmission.col(static_cast<Eigen::Index>(j)) = rod[j] / (arm.x() * rod[j].y() - arm.y() * rod[j].x());
    }
    const double det = rod[0].x() * rod[1].y() - rod[0].y() * rod[1].x();
    const double r0 = rod[0].dot(elbow_speed[0]), r1 = rod[1].dot(elbow_speed[1]);
    Eigen::Matrix2d expected;
    expected << r0 * rod[1].y(), -r1 * rod[0].y(), -r0 * rod[1].x(), r1 * rod[0].x();
    expected /= det;
    EXPECT_LT((*at.jacobian - expected).norm(), 1e-12);
    EXPECT_LT((*at.force_transmission - transmission).norm(), 1e-12);
    const double sum = expected.squaredNorm(), product = std::abs(expected.determinant());
    const double largest = std::sqrt(0.5 * (sum + std::sqrt(sum * sum - 4.0 * product * product)));
    EXPECT_NEAR(*at.condition_number, largest * largest / product, 1e-9) << "all anchors move as one";
  }
}

bool is_finite(const std::optional<TaskMatrix>& matrix) { return !matrix || matrix->allFinite(); }

void expect_finite(const JacobianAt& at) {
  EXPECT_TRUE(is_finite(at.jacobian) && is_finite(at.inverse_jacobian) && is_finite(at.force_transmission));
  EXPECT_TRUE(std::isfinite(at.condition_number.value_or(1.0)));
}

// Both rods on the line between the elbows, which are 13 apart.
TEST(Jacobian, AtAParallelSingularityHasItsInverseAlone) {
  const auto robot = test::five_bar();
  const JointVector q = Eigen::Vector2d(EIGEN_PI, std::acos(-145.0 / 170.0));
  const Eigen::Vector2d first(-8.0, 0.0), second(9.0 + 5.0 * std::cos(q[1]), 5.0 * std::sin(q[1]));
  const Eigen::Vector2d point = first + 5.0 / 13.0 * (second - first);
  const JacobianAt at = jacobian_at(*robot, Pose::planar(point.x(), point.y()), q);
  EXPECT_EQ(at.status, JacobianStatus::parallel_singularity);
  EXPECT_TRUE(test::has(at.reason, "A is singular"));
  EXPECT_FALSE(at.jacobian || at.singular_values || at.condition_number);
  ASSERT_TRUE(at.inverse_jacobian && at.force_transmission);
  expect_finite(at);
}

TEST(Jacobian, AtASerialSingularityHasNoInverse) {
  const auto robot = test::five_bar();
  const Pose pose = Pose::planar(13.0 * std::cos(0.9), 13.0 * std::sin(0.9));
  const JointVector q = Eigen::Vector2d(0.9, joint_value(robot->leg(1), pose.position, 1));
  const JacobianAt at = jacobian_at(*robot, pose, q);
  EXPECT_EQ(at.status, JacobianStatus::serial_singularity);
  EXPECT_TRUE(test::has(at.reason, "'" + robot->leg(0).name + "'"));
  EXPECT_FALSE(at.inverse_jacobian || at.force_transmission || at.condition_number);
  ASSERT_TRUE(at.jacobian && at.singular_values);
  expect_finite(at);
}

TEST(Jacobian, OfStrutsWithoutLengthIsSingular) {
  const auto robot = test::bipod();
  const JacobianAt at = jacobian_at(*robot, Pose(), Eigen::Vector2d(0.0, 5.0));
  EXPECT_EQ(at.status, JacobianStatus::both);
  expect_finite(at);
}

TEST(Jacobian, AtJointValuesIsThatOfEachDirectSolution) {
  const auto robot = test::shipped("agile_eye")->manipulator();
  JacobianQuestion question;
  question.joints = Eigen::Vector3d(0.3, 0.2, -0.4);
  const JacobianAnswer found = jacobians(robot, question);
  ASSERT_EQ(found.configurations.size(), 8U);
  EXPECT_EQ(found.direct_status, DirectStatus::solved);
  int trivial = 0;
  for (const JacobianAt& at : found.configurations) {
    expect_finite(at);
    trivial += at.mode ? 0 : 1;
    EXPECT_EQ(at.mode.has_value(), at.inverse_jacobian.has_value());
  }
  EXPECT_EQ(trivial, 4);
  question.mode =
      found.configurations.back().mode ? found.configurations.back().mode : found.configurations.front().mode;
  for (const JacobianAt& at : jacobians(robot, question).configurations) EXPECT_EQ(at.mode, question.mode);
}

TEST(Jacobian, SaysWhatIsOutOfReach) {
  for (const JacobianAt& at : at_pose(test::five_bar(), Pose::planar(-1.0, 2.0)).configurations) {
    EXPECT_EQ(at.status, JacobianStatus::out_of_reach);
    EXPECT_TRUE(test::has(at.reason, "cannot reach"));
    EXPECT_FALSE(at.a || at.jacobian || at.inverse_jacobian);
  }
}

TEST(Jacobian, NamesItsRowsAndColumns) {
  const JacobianAnswer planar = jacobian_units(*test::three_rpr());
  EXPECT_EQ(planar.twist, (std::vector<std::string>{"wz", "vx", "vy"}));
  EXPECT_EQ(planar.twist_units, (std::vector<std::string>{"rad/s", "m/s", "m/s"}));
  EXPECT_EQ(planar.wrench, (std::vector<std::string>{"mz", "fx", "fy"}));
  EXPECT_EQ(planar.wrench_units, (std::vector<std::string>{"N m", "N", "N"}));
  EXPECT_EQ(planar.rate_units, (std::vector<std::string>{"m/s", "m/s", "m/s"}));
  EXPECT_EQ(jacobian_units(*test::shipped("agile_eye")->manipulator()).twist,
            (std::vector<std::string>{"wx", "wy", "wz"}));
  EXPECT_EQ(jacobian_units(*test::shipped("stewart")->manipulator()).twist.size(), 6U);
}

// The metric is that of the anchors, which do not know where the operational point is.
TEST(Jacobian, HasAConditionNumberWhateverTheOperationalPoint) {
  const auto robot = test::three_rrr();
  ManipulatorDescription description = robot->description();
  const Eigen::Vector3d shift(0.7, -0.3, 0.0);
  for (Leg& leg : description.legs) leg.anchor -= shift;
  const auto same = std::make_shared<const Manipulator>(std::move(description));
  const Pose pose = test::shipped("three_rrr")->home().pose;
  Pose shifted = pose;
  shifted.position = pose.transform(shift);
  const JacobianAnswer found = at_pose(robot, pose), other = at_pose(same, shifted);
  int compared = 0;
  for (std::size_t i = 0; i < found.configurations.size(); ++i) {
    const JacobianAt &here = found.configurations[i], &there = other.configurations[i];
    ASSERT_EQ(here.status, there.status);
    if (here.status != JacobianStatus::regular) continue;
    ++compared;
    EXPECT_NEAR(*here.condition_number / *there.condition_number, 1.0, 1e-9);
  }
  EXPECT_GT(compared, 0);
}

TEST(Jacobian, OfAnglesAndLengthsHasNoConditionNumber) {
  const auto mixed =
      test::manipulator("mixed", TaskSpace::T2, {test::five_bar()->leg(0), test::bipod()->leg(1)});
  const JacobianAt at = at_pose(mixed, Pose::planar(4.5, 8.0)).configurations.at(0);
  EXPECT_EQ(at.status, JacobianStatus::regular);
  EXPECT_TRUE(at.jacobian);
  EXPECT_FALSE(at.singular_values || at.condition_number);
}

TEST(Jacobian, IsRefusedWithTheFieldAtFault) {
  Session session(test::five_bar());
  JacobianQuestion question;
  EXPECT_EQ(answer(session, question).problems.at(0).field, "pose");
  question.pose = Pose::planar(4.5, 8.0);
  question.joints = Eigen::Vector2d(0.4835, 3.1385);
  EXPECT_EQ(answer(session, question).problems.at(0).kind, ProblemKind::together);
}

}  // namespace
}  // namespace parallel_aspects::ask
