// SPDX-License-Identifier: BSD-3-Clause
//
// The nearest pose in reach: that it is in reach, and that no pose which is drawn, all over or round the
// answer, is much nearer. What is in reach is written again here, by distances and angles alone.
#include "motion/nearest_reachable.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr unsigned seed = 20261123;

// The legs close, within their limits, on the branch that is asked for.
bool in_reach(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
  const InverseSolution solution = inverse(robot, pose, mode);
  if (!solution || !robot.within_limits(solution.q)) return false;
  const TaskVector residual = residuals(robot, pose, solution.q);
  const TaskVector entries = inverse_diagonal(robot, pose, solution.q);
  for (Eigen::Index j = 0; j < residual.size(); ++j) {
    if (std::abs(residual[j]) > 1e-9 * robot.size() * robot.size()) return false;
    if (entries[j] * mode.sign(static_cast<std::size_t>(j)) < 0.0) return false;
  }
  return true;
}

class Draws {
 public:
  Draws(const Manipulator& robot, unsigned from) : robot_(robot), engine_(from) {}

  double uniform(double largest) {
    return std::uniform_real_distribution<double>(-largest, largest)(engine_);
  }

  // Round a pose, with anchors some `distance` away.
  Pose round(const Pose& pose, double distance) {
    const TaskSpace space = robot_.task_space();
    TaskVector twist(static_cast<Eigen::Index>(degrees_of_freedom(space)));
    const auto turns = twist.size() - static_cast<Eigen::Index>(directions(space));
    for (Eigen::Index i = 0; i < twist.size(); ++i)
      twist[i] = uniform(distance / (i < turns ? robot_.characteristic_length() : 1.0));
    return displaced(space, pose, twist);
  }

 private:
  const Manipulator& robot_;
  std::mt19937 engine_;
};

std::string named(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
  return robot.name() + " " + to_string(mode) + " wanted at " + to_string(robot.task_space(), pose);
}

class NearestReachableOf : public testing::TestWithParam<const char*> {};

TEST_P(NearestReachableOf, IsInReachAndNoDrawnPoseIsMuchNearer) {
  const auto mechanism = test::shipped(GetParam());
  const auto robot = mechanism->manipulator();
  const auto start = mechanism->assembled();
  const auto mode = working_mode(*robot, start.pose, start.q);
  ASSERT_TRUE(mode);
  NearestReachable nearest(robot);
  Draws draws(*robot, seed);
  const int questions = test::is_sanitized ? 4 : 25, tries = test::is_sanitized ? 500 : 4000;
  int asked = 0;
  double worst = 0.0;
  for (int i = 0; i < 40 * questions && asked < questions; ++i) {
    const Pose wanted = draws.round(start.pose, 1.2 * robot->size());
    if (in_reach(*robot, wanted, *mode)) continue;
    ++asked;
    const auto found = nearest.find(wanted, *mode);
    ASSERT_TRUE(found) << named(*robot, wanted, *mode);
    EXPECT_TRUE(in_reach(*robot, found->pose, *mode)) << named(*robot, wanted, *mode);
    EXPECT_NEAR(found->distance, anchor_distance(*robot, found->pose, wanted), 1e-12 * robot->size());
    for (int k = 0; k < tries; ++k) {
      const double spread =
          k % 2 == 0 ? 2.0 * robot->size() : 1e-5 * std::pow(10.0, draws.uniform(4.0) + 1.0);
      const Pose other = draws.round(k % 2 == 0 ? start.pose : found->pose, spread);
      const double gain = found->distance - anchor_distance(*robot, other, wanted);
      if (gain > worst && in_reach(*robot, other, *mode)) worst = gain;
    }
    EXPECT_LT(worst, 1e-3 * robot->size()) << named(*robot, wanted, *mode);
  }
  RecordProperty("worst", std::to_string(worst / robot->size()));
  std::printf("%s: %d questions, no drawn pose nearer by more than %.1e of the size\n", GetParam(), asked,
              worst / robot->size());
}

INSTANTIATE_TEST_SUITE_P(ShippedRobots, NearestReachableOf,
                         testing::Values("bipod", "five_bar", "three_rrr", "three_rpr", "three_prr", "delta",
                                         "linear_delta", "spherical_3rrr", "agile_eye", "stewart", "hexa",
                                         "six_pus"),
                         [](const auto& robot) { return std::string(robot.param); });

// |p - A| from |8 - 5| to 13, and |p - B| likewise: far out on the line of both, the circle of 13 about A.
TEST(NearestReachable, IsOnTheCircleOfAStretchedLeg) {
  const auto robot = test::five_bar();
  NearestReachable nearest(robot);
  const auto found = nearest.find(Pose::planar(-10.0, 0.0), WorkingMode(2));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->pose.position.x(), -4.0, 1e-5);
  EXPECT_NEAR(found->pose.position.y(), 0.0, 0.02);
  EXPECT_NEAR(found->distance, 6.0, 1e-5);
}

TEST(NearestReachable, IsTheWantedPoseWhereThatIsInReach) {
  NearestReachable nearest(test::five_bar());
  const auto found = nearest.find(Pose::planar(4.5, 8.0), WorkingMode(2));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->pose.position, Eigen::Vector3d(4.5, 8.0, 0.0));
  EXPECT_EQ(found->distance, 0.0);
}

// Struts of 2 to 6 and 4 to 9: from (-20, 0) the nearest is at the largest 9 of the second, or at a corner.
TEST(NearestReachable, IsAtALimitOfAStrut) {
  NearestReachable nearest(test::bipod());
  const auto found = nearest.find(Pose::planar(-20.0, 0.0), WorkingMode(2));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->pose.position.x(), -4.0, 1e-5);
  EXPECT_NEAR(found->pose.position.y(), 0.0, 0.02);
}

// No pose is in reach of both legs.
TEST(NearestReachable, IsNothingWhereTheWorkingModeHasNoPose) {
  const auto robot = test::manipulator("apart", TaskSpace::T2,
                                       {test::planar_revolute_leg(0, {0.0, 0.0}, 1.0, 1.0),
                                        test::planar_revolute_leg(1, {9.0, 0.0}, 1.0, 1.0)});
  EXPECT_FALSE(NearestReachable(robot).find(Pose::planar(4.5, 0.0), WorkingMode(2)));
}

}  // namespace
}  // namespace parallel_aspects
