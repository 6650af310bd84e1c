// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/symmetry/robot_symmetry.h"

#include "aspects/symmetry/map_symmetry.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/robots/symmetric_robots.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace parallel_aspects {
namespace {

using Robot = std::shared_ptr<const Manipulator>;

const Box cube{3, {-4.0, -4.0, -4.0}, {4.0, 4.0, 4.0}};

Box region_of(const Robot& robot) {
  Box region = cube;
  region.dimension = degrees_of_freedom(robot->task_space());
  return region;
}

std::set<std::string> motions(const Robot& robot) {
  std::set<std::string> result;
  for (const RobotSymmetry& each : find_robot_symmetries(*robot, region_of(robot)))
    result.insert(to_string(each.motion, robot->task_space()));
  return result;
}

Pose image(const RigidSymmetry& motion, const Pose& pose) {
  Pose result;
  result.position = motion.base * pose.position + motion.shift;
  result.orientation = Eigen::Quaterniond(
      Eigen::Matrix3d(motion.base * pose.orientation.toRotationMatrix() * motion.platform.transpose()));
  return result;
}

/// The image in plain double precision: the same legs reach within limits, and B and det A are as promised.
/// Returns whether the pose is reached.
bool expect_image(const Robot& robot, const RobotSymmetry& symmetry, const Pose& pose,
                  const WorkingMode& mode) {
  const Pose there = image(symmetry.motion, pose);
  const WorkingMode image_mode = symmetry.image(mode);
  const InverseSolution solution = inverse(*robot, pose, mode), other = inverse(*robot, there, image_mode);
  EXPECT_EQ(solution.status, other.status);
  if (solution.status != InverseStatus::solved || other.status != InverseStatus::solved) return false;
  const TaskVector entries = inverse_diagonal(*robot, pose, solution.q);
  const TaskVector image_entries = inverse_diagonal(*robot, there, other.q);
  for (std::size_t j = 0; j < robot->leg_count(); ++j)
    EXPECT_NEAR(image_entries[static_cast<Eigen::Index>(symmetry.leg_image[j])],
                symmetry.entry_sign[j] * entries[static_cast<Eigen::Index>(j)], 1e-6)
        << "leg " << j + 1;
  const TaskMatrix direct = direct_matrix(*robot, pose, solution.q);
  EXPECT_NEAR(direct_determinant(*robot, there, other.q),
              symmetry.determinant_sign * direct_determinant(*robot, pose, solution.q),
              1e-6 * std::pow(direct.norm(), direct.rows()));
  return true;
}

/// How many of some random poses are reached.
int expect_images(const Robot& robot, const RobotSymmetry& symmetry, unsigned seed, double spread,
                  int poses) {
  SCOPED_TRACE(testing::Message() << robot->name() << " in " << name(robot->task_space()) << ", seed " << seed
                                  << ", motion " << to_string(symmetry.motion, robot->task_space()));
  test::RandomRobots random(seed);
  int reached = 0;
  for (int i = 0; i < poses && !testing::Test::HasFailure(); ++i) {
    const Pose pose = random.pose(robot->task_space(), spread);
    for (const WorkingMode& mode : working_modes(*robot))
      reached += expect_image(robot, symmetry, pose, mode);
  }
  return reached;
}

struct Shipped {
  const char* name;
  std::set<std::string> motions;
};

class SymmetriesOfShippedRobots : public testing::TestWithParam<Shipped> {};

TEST_P(SymmetriesOfShippedRobots, AreThese) {
  const Robot robot = test::shipped(GetParam().name)->manipulator();
  EXPECT_EQ(motions(robot), GetParam().motions);
}

TEST_P(SymmetriesOfShippedRobots, KeepTheirPromisesInPlainNumbers) {
  const Robot robot = test::shipped(GetParam().name)->manipulator();
  for (const RobotSymmetry& each : find_robot_symmetries(*robot, region_of(robot))) {
    int reached = 0;
    for (const double share : {0.1, 0.3, 1.0})
      reached += expect_images(robot, each, 1, share * robot->size(), test::thinned(2000));
    EXPECT_GT(reached, test::thinned(100));
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, SymmetriesOfShippedRobots,
                         testing::Values(Shipped{"five_bar", {"(x, -y)"}}, Shipped{"bipod", {"(x, -y)"}},
                                         Shipped{"three_rpr", {}}, Shipped{"three_rrr", {}},
                                         Shipped{"three_prr", {"(-x, y)"}},
                                         Shipped{"linear_delta", {"(x, -y, z)"}},
                                         Shipped{"delta", {"(x, -y, z)", "(x, y, -z)", "(x, -y, -z)"}},
                                         Shipped{"spherical_3rrr", {"(-x, y, z)"}},
                                         Shipped{"agile_eye",
                                                 {"(-x, -y, z)", "(-x, y, -z)", "(x, -y, -z)", "(z, x, y)",
                                                  "(z, -x, -y)", "(-z, -x, y)", "(-z, x, -y)", "(y, z, x)",
                                                  "(-y, z, -x)", "(y, -z, -x)", "(-y, -z, x)"}},
                                         Shipped{"stewart", {}}),
                         [](const auto& robot) { return std::string(robot.param.name); });

/// Motions that are their own inverse.
std::vector<Eigen::Matrix3d> involutions(TaskSpace space) {
  std::vector<Eigen::Matrix3d> result;
  for (const RigidSymmetry& each : find_rigid_symmetries(space, cube))
    if (each.base * each.base == Eigen::Matrix3d::Identity() && !each.base.isIdentity() &&
        each.platform == each.base)
      result.push_back(each.base);
  return result;
}

struct Constructed {
  TaskSpace space;
  test::ActuationKind kind;
  bool limited;
};

std::vector<Constructed> constructed() {
  std::vector<Constructed> cases;
  for (const TaskSpace space : {TaskSpace::T2, TaskSpace::SE2, TaskSpace::T3, TaskSpace::SO3})
    for (const test::ActuationKind kind : test::all_actuation_kinds)
      for (const bool limited : {false, true}) cases.push_back({space, kind, limited});
  return cases;
}

const RobotSymmetry* with_motion(const std::vector<RobotSymmetry>& found, const Eigen::Matrix3d& motion) {
  for (const RobotSymmetry& each : found)
    if (each.motion.base == motion && each.motion.platform == motion) return &each;
  return nullptr;
}

TEST(RobotSymmetry, IsFoundWhereARobotIsBuiltWithIt) {
  int reached = 0;
  unsigned seed = 0;
  for (const Constructed& each : constructed())
    for (const Eigen::Matrix3d& motion : involutions(each.space)) {
      const Robot robot = test::SymmetricRobots(++seed, motion).robot(each.space, each.kind, each.limited);
      const auto found = find_robot_symmetries(*robot, region_of(robot));
      ASSERT_NE(with_motion(found, motion), nullptr)
          << name(each.space) << ", kind " << static_cast<int>(each.kind) << ", seed " << seed << ", motion\n"
          << motion;
      for (const RobotSymmetry& symmetry : found)
        reached += expect_images(robot, symmetry, seed, 1.5, test::thinned(40));
    }
  EXPECT_GT(reached, test::thinned(10000));
}

// The weakest break of all: one number of one leg by one unit in the last place.
TEST(RobotSymmetry, IsNotFoundWhereANumberIsOffByOneUlp) {
  const std::vector<std::function<void(Leg&)>> breaks{
      [](Leg& leg) { leg.anchor.x() = std::nextafter(leg.anchor.x(), 9.0); },
      [](Leg& leg) { leg.anchor.y() = std::nextafter(leg.anchor.y(), 9.0); },
      [](Leg& leg) { leg.rod_length = std::nextafter(leg.rod_length, 9.0); },
      [](Leg& leg) { leg.limits.lower = std::nextafter(leg.limits.lower, 9.0); },
      [](Leg& leg) { leg.limits.upper = std::nextafter(leg.limits.upper, -9.0); },
      [](Leg& leg) {
        auto& actuation = std::get<RevoluteActuation>(leg.actuation);
        actuation.center.y() = std::nextafter(actuation.center.y(), 9.0);
      },
      [](Leg& leg) {
        auto& actuation = std::get<RevoluteActuation>(leg.actuation);
        actuation.radius = std::nextafter(actuation.radius, 9.0);
      },
      [](Leg& leg) {
        auto& actuation = std::get<RevoluteActuation>(leg.actuation);
        actuation.zero_direction.x() = std::nextafter(actuation.zero_direction.x(), 9.0);
      }};
  unsigned seed = 0;
  for (const TaskSpace space : {TaskSpace::T2, TaskSpace::SE2, TaskSpace::T3, TaskSpace::SO3})
    for (const Eigen::Matrix3d& motion : involutions(space))
      for (std::size_t i = 0; i < breaks.size(); ++i) {
        const Robot whole =
            test::SymmetricRobots(++seed, motion).robot(space, test::ActuationKind::revolute, true);
        ASSERT_NE(with_motion(find_robot_symmetries(*whole, region_of(whole)), motion), nullptr);
        ManipulatorDescription description = whole->description();
        breaks[i](description.legs[0]);
        const Robot broken = std::make_shared<const Manipulator>(description);
        EXPECT_EQ(with_motion(find_robot_symmetries(*broken, region_of(broken)), motion), nullptr)
            << name(space) << ", break " << i << ", seed " << seed << ", motion\n"
            << motion;
      }
}

TEST(RobotSymmetry, IsAboutTheMiddleOfTheRegion) {
  const auto legs = [](double second) {
    return test::manipulator("symmetric five-bar", TaskSpace::T2,
                             {test::planar_revolute_leg(0, {0.0, 0.0}, 2.0, 3.0),
                              test::planar_revolute_leg(1, {second, 0.0}, 2.0, 3.0)});
  };
  const Box region{2, {-5.0, -5.0, 0.0}, {7.0, 5.0, 0.0}};
  std::set<std::string> found;
  for (const RobotSymmetry& each : find_robot_symmetries(*legs(2.0), region))
    found.insert(to_string(each.motion, TaskSpace::T2));
  EXPECT_EQ(found, (std::set<std::string>{"(x, -y)", "(2-x, y)", "(2-x, -y)"}));
  EXPECT_EQ(find_robot_symmetries(*legs(std::nextafter(2.0, 3.0)), region).size(), 1U);
  const Box elsewhere{2, {-5.0, -5.0, 0.0}, {7.5, 5.5, 0.0}};
  EXPECT_TRUE(find_robot_symmetries(*legs(2.0), elsewhere).empty());
}

Robot five_bar_with(const Constraints& constraints) {
  ManipulatorDescription description = test::five_bar()->description();
  description.constraints = constraints;
  return std::make_shared<const Manipulator>(description);
}

bool keeps_its_reflection(const Constraints& constraints) {
  return motions(five_bar_with(constraints)) == std::set<std::string>{"(x, -y)"};
}

PassiveLimit elbow_limit(std::size_t leg, double lower, double upper) {
  return {"elbow " + std::to_string(leg), leg, PassiveAngle::crank_to_rod, 0.25, 1.0, {lower, upper}};
}

TEST(RobotSymmetry, IsKeptByConstraintsThatHaveItOnly) {
  Constraints constraints;
  constraints.thickness = {0.1, 0.1, {}};
  constraints.self_collision.emplace();
  constraints.workspace = WorkspaceBox{{-3.0, -2.0, 0.0}, {4.0, 2.0, 0.0}};
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()));
  constraints.obstacles.push_back({"ball", BallObstacle{{3.0, 0.0, 0.0}, 0.5}});
  constraints.obstacles.push_back({"above", BoxObstacle{{1.0, 2.0, 0.0}, turned, {0.5, 0.25, 1.0}}});
  EXPECT_FALSE(keeps_its_reflection(constraints));
  constraints.obstacles.push_back(
      {"below", BoxObstacle{{1.0, -2.0, 0.0}, turned.conjugate(), {0.5, 0.25, 1.0}}});
  EXPECT_TRUE(keeps_its_reflection(constraints));

  const auto broken = [&constraints](const std::function<void(Constraints&)>& change) {
    Constraints changed = constraints;
    change(changed);
    return !keeps_its_reflection(changed);
  };
  EXPECT_TRUE(broken([](Constraints& c) { c.workspace->upper.y() = std::nextafter(2.0, 3.0); }));
  EXPECT_FALSE(broken([](Constraints& c) { c.workspace->upper.x() = 3.5; }));
  EXPECT_TRUE(broken([](Constraints& c) {
    std::get<BallObstacle>(c.obstacles[0].shape).center.y() = std::nextafter(0.0, 1.0);
  }));
  EXPECT_TRUE(broken([](Constraints& c) {
    double& size = std::get<BoxObstacle>(c.obstacles[1].shape).half_size.x();
    size = std::nextafter(size, 1.0);
  }));
  EXPECT_TRUE(broken(
      [&turned](Constraints& c) { std::get<BoxObstacle>(c.obstacles[2].shape).orientation = turned; }));
  EXPECT_TRUE(broken([](Constraints& c) { c.passive_limits.push_back(elbow_limit(0, -1.0, 1.5)); }));
  EXPECT_FALSE(broken([](Constraints& c) {
    PassiveLimit limit = elbow_limit(0, -1.5, 1.5);
    limit.offset = 0.0;
    c.passive_limits.push_back(limit);
  }));
  EXPECT_FALSE(broken([](Constraints& c) {
    c.self_collision->ignored.push_back({LinkName{LinkKind::rod, 0}, LinkName{LinkKind::crank, 1}});
  }));
}

// Reflection in the line of the bases turns the side of a crank, which its y counts, but not its x.
TEST(RobotSymmetry, IsKeptByConesThatHaveItOnly) {
  const auto keeps = [](const std::vector<BallJointCone>& cones) {
    Constraints constraints;
    constraints.cones = cones;
    return keeps_its_reflection(constraints);
  };
  const Eigen::Vector3d slanted(0.6, 0.8, 0.0), mirrored(0.6, -0.8, 0.0);
  for (const LegEnd end : {LegEnd::base, LegEnd::platform}) {
    EXPECT_TRUE(keeps({{0, end, Eigen::Vector3d::UnitX(), 1.0}}));
    EXPECT_FALSE(keeps({{0, end, Eigen::Vector3d::UnitY(), 1.0}}));
    EXPECT_FALSE(keeps({{0, end, slanted, 1.0}}));
    EXPECT_TRUE(keeps({{0, end, slanted, 1.0}, {0, end, mirrored, 1.0}}));
    EXPECT_FALSE(keeps({{0, end, slanted, 1.0}, {0, end, mirrored, 1.1}}));
    EXPECT_FALSE(keeps({{0, end, slanted, 1.0}, {1, end, mirrored, 1.0}}));
  }
  EXPECT_FALSE(keeps({{0, LegEnd::base, slanted, 1.0}, {0, LegEnd::platform, mirrored, 1.0}}));
}

// With both legs alike, reflection in the line between the bases exchanges them.
TEST(RobotSymmetry, ExchangesWhatConstraintsSayOfLegs) {
  const Box region{2, {-5.0, -5.0, 0.0}, {5.0, 5.0, 0.0}};
  ManipulatorDescription description;
  description.name = "five-bar of equal legs";
  description.task_space = TaskSpace::T2;
  description.legs = {test::planar_revolute_leg(0, {-1.0, 0.0}, 2.0, 3.0),
                      test::planar_revolute_leg(1, {1.0, 0.0}, 2.0, 3.0)};
  description.constraints.self_collision.emplace();
  auto& ignored = description.constraints.self_collision->ignored;
  auto& limits = description.constraints.passive_limits;
  const auto exchanges = [&description, &region] {
    for (const RobotSymmetry& each : find_robot_symmetries(Manipulator(description), region))
      if (to_string(each.motion, TaskSpace::T2) == "(-x, y)") return true;
    return false;
  };
  EXPECT_TRUE(exchanges());
  ignored.push_back({LinkName{LinkKind::rod, 0}, LinkName{LinkKind::crank, 1}});
  EXPECT_FALSE(exchanges());
  ignored.push_back({LinkName{LinkKind::crank, 0}, LinkName{LinkKind::rod, 1}});
  EXPECT_TRUE(exchanges());
  limits.push_back(elbow_limit(0, -1.0, 1.5));
  EXPECT_FALSE(exchanges());
  limits.push_back(elbow_limit(1, -1.5, 1.0));
  EXPECT_FALSE(exchanges());
  limits.back().offset *= -1.0;
  EXPECT_TRUE(exchanges());
  limits.front().angle = limits.back().angle = PassiveAngle::base_to_rod;
  EXPECT_FALSE(exchanges());
}

TEST(RobotSymmetry, LetsDrivenElbowsChangeTheirPosture) {
  const Robot robot = test::three_rrr_actuated_elbow();
  const auto found = find_map_symmetries(*robot, region_of(robot), working_modes(*robot));
  EXPECT_EQ(found.size(), 7U);
  const auto sources = find_mode_sources(found, 8);
  EXPECT_EQ(
      std::count_if(sources.begin(), sources.end(), [](const ModeSource& each) { return !each.symmetry; }),
      1);
}

}  // namespace
}  // namespace parallel_aspects
