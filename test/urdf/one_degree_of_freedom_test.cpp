// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include <cmath>
#include <regex>
#include <set>

// The PRRP of Caro et al., |(a, q) - (x, b)| = l, and its kin with one actuated joint and one degree of
// freedom.
namespace parallel_aspects {
namespace {

constexpr double a = 1.0, b = 2.0, l = 3.0;

Pose at(double x) {
  Pose pose;
  pose.position.x() = x;
  return pose;
}

class Prrp : public ::testing::Test {
 protected:
  const std::shared_ptr<const Mechanism> mechanism_ =
      test::load(test::source_file("test/data/prrp.urdf"), test::source_file("test/data/prrp.yaml"));
  const std::shared_ptr<const Manipulator>& manipulator_ = mechanism_->manipulator();
};

TEST_F(Prrp, IsRecognised) {
  EXPECT_EQ(manipulator_->task_space(), TaskSpace::T1);
  EXPECT_EQ(mechanism_->mobility(), 1);
  ASSERT_EQ(manipulator_->leg_count(), 1U);
  EXPECT_NEAR(manipulator_->leg(0).rod_length, l, 1e-12);
  EXPECT_NEAR((manipulator_->task_frame().translation() - Eigen::Vector3d(0, b, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((manipulator_->task_frame().linear().col(0) - Eigen::Vector3d::UnitX()).norm(), 0.0, 1e-12);
  EXPECT_EQ(test::open_loops(*mechanism_), 0);
}

TEST_F(Prrp, HasTwoSolutionsEachWay) {
  for (const double x : {-1.5, 0.3, 3.2}) {
    const auto solutions = inverse_in_all_modes(*manipulator_, at(x));
    ASSERT_EQ(solutions.size(), 2U);
    const double height = std::sqrt(l * l - (x - a) * (x - a));
    std::set<double> heights;
    for (const InverseSolution& solution : solutions) {
      ASSERT_EQ(solution.status, InverseStatus::solved);
      const double q = solution.q[0];
      EXPECT_NEAR(std::abs(q - b), height, 1e-12);
      heights.insert(q);
      // A = x - a, B = b - q, as the derivatives of the equation say.
      EXPECT_NEAR(direct_determinant(*manipulator_, at(x), solution.q), x - a, 1e-12);
      EXPECT_NEAR(inverse_diagonal(*manipulator_, at(x), solution.q)[0], b - q, 1e-12);
      const DirectResult direct_solutions = direct(*manipulator_, solution.q);
      ASSERT_EQ(direct_solutions.solutions.size(), 2U);
      EXPECT_NEAR(direct_solutions.solutions[0].pose.position.x(), a + std::abs(x - a), 1e-12);
      EXPECT_NEAR(direct_solutions.solutions[1].pose.position.x(), a - std::abs(x - a), 1e-12);
    }
    EXPECT_EQ(heights.size(), 2U);
  }
  EXPECT_EQ(inverse_in_all_modes(*manipulator_, at(a + l + 0.1))[0].status, InverseStatus::out_of_reach);
  EXPECT_TRUE(direct(*manipulator_, JointVector::Constant(1, b + l + 0.1)).solutions.empty());
}

// The quarters of the circle.
TEST_F(Prrp, HasFourAspects) {
  const MapResult result = compute_aspect_map(manipulator_);
  ASSERT_EQ(result.status, MapStatus::complete);
  ASSERT_EQ(result.map->aspects().size(), 4U);
  std::set<std::pair<std::string, int>> branches;
  for (const Aspect& aspect : result.map->aspects()) {
    branches.emplace(to_string(aspect.mode), aspect.determinant_sign);
    EXPECT_TRUE(aspect.unresolved_with.empty());
    EXPECT_LE(aspect.measure_lower, l);
    EXPECT_GE(aspect.measure_upper, l);
    EXPECT_NEAR(aspect.measure, l, 0.1);
    EXPECT_NEAR(aspect.bounds.center(0), a + 0.5 * l * aspect.determinant_sign, 0.1);
  }
  EXPECT_EQ(branches.size(), 4U);
}

TEST_F(Prrp, HasSegmentsThatAreProvedFree) {
  const SegmentCertifier certifier(manipulator_);
  const WorkingMode mode = working_modes(*manipulator_).front();
  EXPECT_EQ(certifier.prove(at(2.0), at(3.5), mode, 100).verdict, SegmentVerdict::free);
  const SegmentProof across = certifier.prove(at(0.5), at(3.5), mode, 100);
  EXPECT_EQ(across.verdict, SegmentVerdict::blocked);
  EXPECT_EQ(across.violation, Violation::singularity);
}

// A crank that actuates a slider through a rod.
TEST(SliderCrank, IsRecognised) {
  const std::string urdf =
      "<robot name=\"slider_crank\"><link name=\"base\"/><link name=\"crank\"/><link name=\"rod\"/><link "
      "name=\"slider\"/>" +
      test::moving_joint("drive", "base", "crank", "0 1 0") +
      test::moving_joint("pin", "crank", "rod", "0 -1 0", "xyz=\"1 0 0\"") + "<link name=\"tip\"/>" +
      test::fixed_joint("rod", "tip", "xyz=\"3 0 0\"") +
      "<joint name=\"slide\" type=\"prismatic\"><parent link=\"base\"/><child link=\"slider\"/><axis xyz=\"0 "
      "0 1\"/></joint></robot>";
  const auto mechanism = test::load(urdf,
                                    "mechanism: {operational_point: slider, actuated_joints: [drive], "
                                    "closures: [{frames: [tip, slider], type: point}]}");
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::T1);
  EXPECT_NEAR(std::get<RevoluteActuation>(mechanism->manipulator()->leg(0).actuation).radius, 1.0, 1e-9);
  EXPECT_NEAR(mechanism->manipulator()->leg(0).rod_length, 3.0, 1e-9);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

// One actuated joint, but the coupler's points run along curves.
TEST(FourBar, IsRefused) {
  const std::string urdf =
      "<robot name=\"four_bar\"><link name=\"base\"/><link name=\"crank\"/><link name=\"coupler\"/><link "
      "name=\"rocker\"/><link name=\"tip\"/><link name=\"end\"/>" +
      test::moving_joint("drive", "base", "crank", "0 0 1") +
      test::moving_joint("pin", "crank", "coupler", "0 0 1", "xyz=\"1 0 0\"") +
      test::fixed_joint("coupler", "tip", "xyz=\"3 0 0\"") +
      test::moving_joint("pivot", "base", "rocker", "0 0 1", "xyz=\"3 0 0\"") +
      test::fixed_joint("rocker", "end", "xyz=\"2 0 0\"") + "</robot>";
  const Problems expected{
      "robot.urdf is a linkage of one degree of freedom, as a four-bar, and its operational_point 'coupler' "
      "is on neither; of those only a platform on a slide (T1) or on a hinge (R1) of the base, which one leg "
      "moves, is treated."};
  EXPECT_EQ(test::refusal(urdf,
                          "mechanism: {operational_point: coupler, actuated_joints: [drive], closures: "
                          "[{frames: [tip, end], type: point}]}"),
            expected);
  // In another plane than the one that revolute closures turn in, the loop is rigid.
  EXPECT_EQ(test::refusal(std::regex_replace(urdf, std::regex("\"0 0 1\""), "\"0 1 0\""),
                          "mechanism: {operational_point: coupler, actuated_joints: [drive], closures: "
                          "[{frames: [tip, end], type: revolute}]}"),
            expected);
}

}  // namespace
}  // namespace parallel_aspects
