// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/thoroughness.h"
#include <cmath>
#include <functional>
#include <random>

namespace parallel_aspects {
namespace {

std::string text(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
  char buffer[200];
  std::snprintf(buffer, sizeof(buffer), "%s, pose (%a, %a), mode %s", robot.name().c_str(), pose.position.x(),
                pose.position.y(), to_string(mode).c_str());
  return buffer;
}

// A second way to S(s, sigma): the sign of det A at one pose, in plain double precision; 0 outside.
int sign_at(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
  const InverseSolution solution = inverse(robot, pose, mode);
  if (solution.status != InverseStatus::solved) return 0;
  return direct_determinant(robot, pose, solution.q) > 0.0 ? 1 : -1;
}

// So close to a singularity or limit rounding may tell one from the other.
bool too_close_to_decide(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
  const InverseSolution solution = inverse(robot, pose, mode);
  const double size = robot.size();
  for (std::size_t j = 0; j < robot.leg_count(); ++j) {
    const Leg& leg = robot.leg(j);
    const Eigen::Vector3d point = pose.transform(leg.anchor);
    if (std::abs(squared_inverse_entry(leg, point)) < 1e-10 * size * size) return true;
    const double q = joint_value(leg, point, mode.sign(j));
    if (std::abs(q - leg.limits.lower) < 1e-9 || std::abs(q - leg.limits.upper) < 1e-9) return true;
  }
  return solution.status == InverseStatus::solved &&
         std::abs(direct_determinant(robot, pose, solution.q)) < 1e-8 * size * size;
}

struct MappedRobot {
  const char* name;
  std::function<std::shared_ptr<const Manipulator>()> make;
};

// Axis down, zero direction oblique, anchors off the operational point and out of the plane.
std::shared_ptr<const Manipulator> oblique_five_bar() {
  ManipulatorDescription description{"oblique_five_bar", TaskSpace::T2, test::five_bar()->legs(), "base", {}};
  description.task_frame.setIdentity();
  auto& actuation = std::get<RevoluteActuation>(description.legs[0].actuation);
  actuation.axis = -Eigen::Vector3d::UnitZ();
  actuation.zero_direction = Eigen::Vector3d(0.6, 0.8, 0.0);
  description.legs[0].anchor = {0.3, -0.4, 0.5};
  description.legs[0].limits = {0.2, 4.0};
  description.legs[1].anchor = {-0.2, 0.1, -0.7};
  return std::make_shared<const Manipulator>(description);
}

std::shared_ptr<const Manipulator> rails() {
  ManipulatorDescription description{"rails", TaskSpace::T2, {}, "base", {}};
  description.task_frame.setIdentity();
  for (const double side : {-1.0, 1.0}) {
    Leg leg;
    leg.name = side < 0.0 ? "left" : "right";
    leg.actuated_joint = leg.name;
    leg.actuation = PrismaticActuation{{side, 0.0, 0.0}, Eigen::Vector3d(side * 0.6, 0.8, 0.0)};
    leg.rod_length = 1.5;
    leg.limits = {-1.0, 2.0};
    description.legs.push_back(leg);
  }
  return std::make_shared<const Manipulator>(description);
}

std::shared_ptr<const Manipulator> elbows() {
  ManipulatorDescription description{"elbows", TaskSpace::T2, {}, "base", {}};
  description.task_frame.setIdentity();
  for (const double side : {-1.0, 1.0}) {
    Leg leg;
    leg.name = side < 0.0 ? "left" : "right";
    leg.actuated_joint = leg.name;
    leg.actuation = ElbowActuation{{side, 0.0, 0.0}, 1.2, 0.9, 0.3, side};
    leg.limits = {-2.5, 0.8};
    description.legs.push_back(leg);
  }
  return std::make_shared<const Manipulator>(description);
}

class MapProperties : public testing::TestWithParam<MappedRobot> {
 protected:
  std::shared_ptr<const Manipulator> robot = GetParam().make();
  std::shared_ptr<const AspectMap> map = compute_aspect_map(robot).map;
};

// A million poses: what the map calls inside or outside must hold at every one of them.
TEST_P(MapProperties, NoPoseContradictsItsLeaf) {
  ASSERT_TRUE(map);
  std::mt19937_64 random(99);
  const Box& region = map->region();
  std::uniform_real_distribution<double> x(region.lower[0], region.upper[0]),
      y(region.lower[1], region.upper[1]);
  const auto modes = working_modes(*robot);
  std::size_t inside = 0;
  for (int i = 0; i < test::thinned(250000); ++i) {
    Pose pose;
    pose.position << x(random), y(random), 0.0;
    for (const WorkingMode& mode : modes) {
      const Location location = map->locate(pose, mode);
      if (location.status == LocationStatus::undecided || too_close_to_decide(*robot, pose, mode)) continue;
      const int expected =
          location.status == LocationStatus::inside
              ? map->aspects()[static_cast<std::size_t>(location.aspect - 1)].determinant_sign
              : 0;
      inside += expected != 0;
      ASSERT_EQ(sign_at(*robot, pose, mode), expected) << text(*robot, pose, mode);
    }
  }
  EXPECT_GT(inside, test::thinned(1000U));
}

// With the local proof hardly any pose is left undecided.
TEST_P(MapProperties, FewPosesAreUndecided) {
  ASSERT_TRUE(map);
  std::mt19937_64 random(100);
  const Box& region = map->region();
  std::uniform_real_distribution<double> x(region.lower[0], region.upper[0]),
      y(region.lower[1], region.upper[1]);
  int undecided = 0, total = 0;
  for (int i = 0; i < test::thinned(20000); ++i) {
    Pose pose;
    pose.position << x(random), y(random), 0.0;
    for (const WorkingMode& mode : working_modes(*robot)) {
      if (sign_at(*robot, pose, mode) == 0) continue;
      ++total;
      undecided += map->locate(pose, mode).status != LocationStatus::inside;
    }
  }
  EXPECT_LT(undecided, total / 100) << undecided << " of " << total;
}

// The ball around the deepest pose holds no pose of another sign, mode limit or aspect.
TEST_P(MapProperties, NothingIsCloserThanTheClearance) {
  ASSERT_TRUE(map);
  std::mt19937_64 random(101);
  std::uniform_real_distribution<double> angle(-EIGEN_PI, EIGEN_PI), share(0.0, 1.0);
  for (const Aspect& aspect : map->aspects()) {
    EXPECT_GT(aspect.deepest_clearance, 0.0);
    for (int i = 0; i < 1000; ++i) {
      Pose pose = aspect.deepest;
      const double direction = angle(random), radius = aspect.deepest_clearance * share(random);
      pose.position += radius * Eigen::Vector3d(std::cos(direction), std::sin(direction), 0.0);
      ASSERT_EQ(sign_at(*robot, pose, aspect.mode), aspect.determinant_sign)
          << text(*robot, pose, aspect.mode);
      ASSERT_EQ(map->locate(pose, aspect.mode).aspect, aspect.id) << text(*robot, pose, aspect.mode);
    }
  }
}

TEST_P(MapProperties, LeavesOfAnAspectAddUpToItsMeasure) {
  ASSERT_TRUE(map);
  for (const Aspect& aspect : map->aspects()) {
    double measure = 0.0;
    std::size_t count = 0;
    map->visit_inside_leaves(aspect.id, [&](const Box& box) {
      measure += box.measure();
      ++count;
    });
    EXPECT_NEAR(measure, aspect.measure_lower, 1e-9 * measure);
    EXPECT_EQ(count, aspect.inside_leaves);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, MapProperties,
                         testing::Values(MappedRobot{"five_bar", test::five_bar},
                                         MappedRobot{"bipod", test::bipod},
                                         MappedRobot{"limited_five_bar", test::limited_five_bar},
                                         MappedRobot{"oblique_five_bar", oblique_five_bar},
                                         MappedRobot{"rails", rails}, MappedRobot{"elbows", elbows}),
                         [](const auto& robot) { return std::string(robot.param.name); });

}  // namespace
}  // namespace parallel_aspects
