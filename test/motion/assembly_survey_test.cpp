// SPDX-License-Identifier: BSD-3-Clause
#include "motion/assembly_survey.h"

#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
#include <atomic>
#include <cmath>
#include <memory>
#include <string>
#include <variant>

namespace parallel_aspects {
namespace {

std::shared_ptr<const PoseRoadmap> roadmap_of(const std::shared_ptr<const Manipulator>& robot,
                                              std::size_t samples, std::size_t mode_count) {
  RoadmapOptions options;
  options.samples = samples;
  options.modes = working_modes(*robot);
  options.modes.resize(std::min(options.modes.size(), mode_count));
  return compute_pose_roadmap(robot, options).roadmap;
}

/// How far the anchor is from where the actuated joint lets it be [m], with 64 bits and by formulas of its
/// own.
long double error_of(const Leg& leg, const Pose& pose, double q) {
  using Vector = Eigen::Matrix<long double, 3, 1>;
  const Eigen::Quaternion<long double> turn = pose.orientation.cast<long double>().normalized();
  const Vector p = pose.position.cast<long double>() + turn * leg.anchor.cast<long double>();
  if (const auto* crank = std::get_if<RevoluteActuation>(&leg.actuation)) {
    const Eigen::AngleAxis<long double> turned(q, crank->axis.cast<long double>().normalized());
    const Vector tip = crank->center.cast<long double>() +
                       turned * (crank->radius * crank->zero_direction.cast<long double>());
    return (p - tip).norm() - leg.rod_length;
  }
  if (const auto* rail = std::get_if<PrismaticActuation>(&leg.actuation)) {
    const Vector carriage = rail->origin.cast<long double>() + q * rail->direction.cast<long double>();
    return (p - carriage).norm() - leg.rod_length;
  }
  const auto& strut = std::get<StrutActuation>(leg.actuation);
  return (p - strut.base.cast<long double>()).norm() - (strut.length_at_zero + strut.sense * q);
}

void expect_solution(const Manipulator& robot, const ComponentSurvey& component, const JointVector& q,
                     const ProvedSolution& solution) {
  EXPECT_EQ(solution.mode, component.mode);
  EXPECT_EQ(test::sign_in_doubles(robot, solution.pose, component.mode), component.determinant_sign);
  for (std::size_t j = 0; j < robot.leg_count(); ++j) {
    const double value = q[static_cast<Eigen::Index>(j)];
    EXPECT_LT(std::abs(error_of(robot.leg(j), solution.pose, value)), 1e-12 * robot.size());
    EXPECT_TRUE(robot.leg(j).limits.contain(value));
  }
}

/// det A has one sign all along, and each leg stays in its working mode and limits.
void expect_free(const Manipulator& robot, const ComponentSurvey& component, const std::vector<Pose>& path) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    for (int k = 0; k <= 1000; ++k)
      ASSERT_EQ(test::sign_in_doubles(robot, pose_between(path[i], path[i + 1], k / 1000.0), component.mode),
                component.determinant_sign)
          << robot.name();
}

void expect_change(const Manipulator& robot, const ComponentSurvey& component) {
  const AssemblyChange& change = *component.change;
  expect_solution(robot, component, change.actuated, change.from);
  expect_solution(robot, component, change.actuated, change.to);
  EXPECT_GT((robot.leg(0).anchor.norm() + 1e-3) *  // their platforms are not in one place
                    change.from.pose.orientation.angularDistance(change.to.pose.orientation) +
                (change.from.pose.position - change.to.pose.position).norm(),
            1e-3 * robot.size());
  ASSERT_GE(change.path.size(), 2U);
  EXPECT_EQ(change.path.front().position, change.from.pose.position);
  EXPECT_EQ(change.path.front().orientation.coeffs(), change.from.pose.orientation.coeffs());
  EXPECT_EQ(change.path.back().position, change.to.pose.position);
  EXPECT_EQ(change.path.back().orientation.coeffs(), change.to.pose.orientation.coeffs());
  expect_free(robot, component, change.path);
}

std::size_t sum(const PosesBySolutions& counts) {
  std::size_t all = 0;
  for (const auto& [solutions, poses] : counts) all += poses;
  return all;
}

TEST(AssemblySurvey, ChangesLeadFromOneSolutionToAnotherInOneAspect) {
  for (const char* name : {"stewart", "hexa", "six_pus"}) {
    const auto robot = test::shipped(name)->manipulator();
    const auto roadmap = roadmap_of(robot, 400, 3);
    const auto survey = survey_assembly_modes(*roadmap, 150);
    ASSERT_TRUE(survey);
    EXPECT_EQ(survey->poses, 150U);
    EXPECT_EQ(sum(survey->solutions), 150U);
    std::size_t changes = 0, looked_at = 0;
    for (const ComponentSurvey& component : survey->components) {
      looked_at += component.poses;
      EXPECT_EQ(sum(component.in_aspect), component.poses);
      EXPECT_LE(component.poses, component.samples);
      EXPECT_EQ(component.in_aspect.count(0), 0U) << "each pose is a solution of its own values";
      const bool has_several = !component.in_aspect.empty() && component.in_aspect.rbegin()->first > 1;
      EXPECT_EQ(component.change.has_value(), has_several) << name;
      if (!component.change) continue;
      ++changes;
      expect_change(*robot, component);
    }
    EXPECT_EQ(looked_at, survey->poses);
    EXPECT_GE(changes, 1U) << name;
  }
}

// Of the Agile Eye each aspect is known to have one solution (Bonev, Chablat and Wenger, 2006).
TEST(AssemblySurvey, FindsOneSolutionInEachAspectOfTheAgileEye) {
  const auto robot = test::shipped("agile_eye")->manipulator();
  const auto survey = survey_assembly_modes(*roadmap_of(robot, 100, 8), 80);
  ASSERT_TRUE(survey);
  EXPECT_EQ(survey->solutions, (PosesBySolutions{{4, 80}}));
  for (const ComponentSurvey& component : survey->components) {
    EXPECT_EQ(component.in_aspect, (PosesBySolutions{{1, component.poses}}));
    EXPECT_EQ(component.unknown, 0U);
    EXPECT_FALSE(component.change);
  }
}

TEST(AssemblySurvey, IsTheSameForTheSameRoadmap) {
  const auto robot = test::shipped("hexa")->manipulator();
  const auto first = survey_assembly_modes(*roadmap_of(robot, 100, 2), 30);
  const auto second = survey_assembly_modes(*roadmap_of(robot, 100, 2), 30);
  ASSERT_TRUE(first && second);
  ASSERT_EQ(first->components.size(), second->components.size());
  EXPECT_EQ(first->solutions, second->solutions);
  for (std::size_t i = 0; i < first->components.size(); ++i) {
    const ComponentSurvey &one = first->components[i], &other = second->components[i];
    EXPECT_EQ(one.in_aspect, other.in_aspect);
    EXPECT_EQ(one.unknown, other.unknown);
    ASSERT_EQ(one.change.has_value(), other.change.has_value());
    if (!one.change) continue;
    EXPECT_EQ(one.change->actuated, other.change->actuated);
  }
}

TEST(AssemblySurvey, EndsWhenCancelled) {
  const auto roadmap = roadmap_of(test::shipped("stewart")->manipulator(), 50, 1);
  std::atomic<bool> cancelled{false};
  std::size_t reports = 0;
  MapControl control;
  control.cancelled = &cancelled;
  control.progress = [&](double share) {
    EXPECT_GE(share, 0.0);
    EXPECT_LE(share, 1.0);
    cancelled = ++reports == 3;
  };
  EXPECT_FALSE(survey_assembly_modes(*roadmap, 50, control));
  EXPECT_EQ(reports, 3U);
}

}  // namespace
}  // namespace parallel_aspects
