// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/symmetry/map_symmetry.h"

#include "aspects/map/map_contents.h"
#include "aspects/map/map_plan.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/robots/symmetric_robots.h"
#include "support/sign_at.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <functional>
#include <map>
#include <random>

namespace parallel_aspects {
namespace {

using Robot = std::shared_ptr<const Manipulator>;

struct Case {
  const char* name;
  std::function<Robot()> make;
  double resolution;
  int extra_levels;
  std::size_t computed_modes;
};

Robot built(unsigned seed, const Eigen::Vector3d& signs, TaskSpace space, test::ActuationKind kind,
            bool limited) {
  return test::SymmetricRobots(seed, signs.asDiagonal()).robot(space, kind, limited);
}

const Case cases[] = {
    {"five_bar", test::five_bar, 0.3, 12, 2},
    {"bipod", test::bipod, 0.1, 12, 1},
    {"delta", [] { return test::shipped("delta")->manipulator(); }, 0.1, 0, 3},
    {"agile_eye", [] { return test::shipped("agile_eye")->manipulator(); }, 0.3, 0, 2},
    {"built_t2",
     [] {
       return built(3, {-1.0, 1.0, 1.0}, TaskSpace::T2, test::ActuationKind::revolute, true);
     },
     0.05, 12, 3},
    {"built_se2",
     [] {
       return built(5, {-1.0, 1.0, 1.0}, TaskSpace::SE2, test::ActuationKind::revolute, false);
     },
     0.14, 0, 4},
    {"built_t3",
     [] {
       return built(7, {1.0, -1.0, 1.0}, TaskSpace::T3, test::ActuationKind::prismatic, true);
     },
     0.1, 0, 6},
    {"actuated_elbow", test::three_rrr_actuated_elbow, 2.0, 2, 1},
};

class MapWithSymmetry : public testing::TestWithParam<Case> {
 protected:
  MapOptions options(bool use_symmetry) const {
    MapOptions result;
    result.resolution = GetParam().resolution * (test::is_sanitized ? 2.0 : 1.0);
    result.extra_levels = GetParam().extra_levels;
    result.use_symmetry = use_symmetry;
    return result;
  }

  /// Computed once for all tests of a robot.
  std::shared_ptr<const AspectMap> map() const {
    static std::map<std::string, std::shared_ptr<const AspectMap>> maps;
    auto& result = maps[GetParam().name];
    if (!result) result = compute_aspect_map(GetParam().make(), options(true)).map;
    return result;
  }
};

/// Aspects, by mode and sign.
std::map<std::pair<std::size_t, int>, int> counts(const AspectMap& map) {
  std::map<std::pair<std::size_t, int>, int> result;
  for (const Aspect& aspect : map.aspects()) ++result[{aspect.mode.index(), aspect.determinant_sign}];
  return result;
}

double measure_inside(const AspectMap& map) {
  double sum = 0.0;
  for (const Aspect& aspect : map.aspects()) sum += aspect.measure_lower;
  return sum;
}

TEST_P(MapWithSymmetry, AgreesWithTheMapWithout) {
  const Robot robot = GetParam().make();
  const auto with = map(), without = compute_aspect_map(robot, options(false)).map;
  ASSERT_TRUE(with && without);
  EXPECT_FALSE(with->symmetry_use()->motions.empty());
  EXPECT_EQ(with->symmetry_use()->computed_modes, GetParam().computed_modes);
  EXPECT_TRUE(without->symmetry_use()->motions.empty());
  EXPECT_EQ(with->working_modes(), without->working_modes());
  EXPECT_EQ(with->proved_count(), without->proved_count());
  EXPECT_EQ(with->count_at_most(), without->count_at_most());
  if (without->unresolved().empty()) {
    EXPECT_EQ(counts(*with), counts(*without));
  }
  if (GetParam().extra_levels > 0) return;
  // A box and its image are two tries at one proof.
  EXPECT_GE(measure_inside(*with), 0.99 * measure_inside(*without));
  EXPECT_LE(with->measure_undecided(), 1.01 * without->measure_undecided());
}

// No leaf may contradict its own proof, whichever leaf it is the image of. That there is none for the image,
// since its legs come in another order and its numbers are rounded otherwise, is rare.
TEST_P(MapWithSymmetry, HasLeavesThatTheClassifierConfirms) {
  const auto map = this->map();
  const AspectMap::Contents& contents = map->contents();
  const RoundingUpward rounding;
  std::size_t decided = 0, confirmed = 0;
  for (NodeIndex node = 0; node < contents.tree.node_count(); ++node)
    for (std::size_t mode = 0; mode < contents.modes.size(); ++mode) {
      const LeafState state = contents.tree.state(node, mode);
      if (!state.is_leaf()) continue;
      const LeafState proved =
          contents.classifier->state(contents.tree.place(node).root, contents.tree.box(node), mode);
      for (const int sign : {1, -1}) {
        ASSERT_FALSE(state.is_inside(sign) && !proved.may_be(sign)) << "node " << node << ", mode " << mode;
        ASSERT_FALSE(proved.is_inside(sign) && !state.may_be(sign)) << "node " << node << ", mode " << mode;
      }
      if (!state.is_inside()) continue;
      ++decided;
      confirmed += proved == state;
    }
  if (test::is_sanitized) return;
  EXPECT_GT(decided, 100U);
  EXPECT_GT(static_cast<double>(confirmed), 0.95 * static_cast<double>(decided));
}

TEST_P(MapWithSymmetry, HoldsAtRandomPosesInPlainNumbers) {
  const Robot robot = GetParam().make();
  const auto map = this->map();
  test::RandomRobots random(11);
  const Box region = map->region();
  int inside = 0;
  for (int i = 0; i < test::thinned(1000); ++i) {
    Pose pose = random.pose(robot->task_space());
    for (std::size_t k = 0; k < std::min(region.dimension, directions(robot->task_space())); ++k)
      pose.position[static_cast<Eigen::Index>(k)] = random.uniform(region.lower[k], region.upper[k]);
    for (const WorkingMode& mode : working_modes(*robot)) {
      const Location location = map->locate(pose, mode);
      const auto sign = test::sign_at(*robot, pose, mode);
      if (!sign || (location.status != LocationStatus::inside && location.status != LocationStatus::outside))
        continue;
      const bool held = location.status == LocationStatus::inside;
      inside += held;
      const int told =
          held ? map->aspects()[static_cast<std::size_t>(location.aspect - 1)].determinant_sign : 0;
      ASSERT_EQ(told, *sign) << "pose " << pose.position.transpose() << "; "
                             << pose.orientation.coeffs().transpose() << ", mode " << to_string(mode);
    }
  }
  if (!test::is_sanitized) {
    EXPECT_GT(inside, 10);
  }
}

TEST_P(MapWithSymmetry, HasDeepestPosesAndBoundsWhereItsLeavesAre) {
  const auto map = this->map();
  for (const Aspect& aspect : map->aspects()) {
    EXPECT_EQ(map->locate(aspect.deepest, aspect.mode).aspect, aspect.id);
    EXPECT_GT(aspect.deepest_clearance, 0.0);
    std::size_t leaves = 0;
    map->visit_inside_leaves(aspect.id, [&](const Box& leaf) {
      ++leaves;
      for (std::size_t i = 0; i < aspect.bounds.dimension; ++i) {
        EXPECT_GE(leaf.lower[i], aspect.bounds.lower[i]);
        EXPECT_LE(leaf.upper[i], aspect.bounds.upper[i]);
      }
    });
    EXPECT_EQ(leaves, aspect.inside_leaves);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, MapWithSymmetry, testing::ValuesIn(cases),
                         [](const auto& robot) { return std::string(robot.param.name); });

TEST(MapSymmetry, TakesNodesToTheirImages) {
  for (const Case& each : cases) {
    MapOptions options;
    options.resolution = each.resolution;
    MapPlan plan;
    ASSERT_EQ(make_map_plan(*each.make(), options, plan), "");
    std::mt19937 engine(1);
    for (const MapSymmetry& symmetry : plan.symmetries) {
      PoseTree tree(plan.space, 1);
      RootIndex root = engine() % tree.root_count();
      NodeIndex node = root, image = symmetry.poses.image(root);
      for (int level = 0; level < 12; ++level) {
        const Box expected = symmetry.poses.image(root, tree.box(node)), found = tree.box(image);
        EXPECT_EQ(found.lower, expected.lower) << each.name << ' ' << symmetry.text;
        EXPECT_EQ(found.upper, expected.upper) << each.name << ' ' << symmetry.text;
        EXPECT_EQ(tree.place(image).root, symmetry.poses.image(root));
        const NodeIndex rank = engine() % tree.children_per_node();
        const NodeIndex first = tree.add_children(node), first_image = tree.add_children(image);
        node = first + rank;
        image = first_image + symmetry.poses.image_rank(root, rank);
      }
    }
  }
}

// The pose of the image of a position is the image of the pose.
TEST(MapSymmetry, TakesCubesOfRotationsAsItTakesRotations) {
  const auto space = make_pose_space(TaskSpace::SO3, {}, 1.0);
  test::RandomRobots random(2);
  for (const RigidSymmetry& motion : find_rigid_symmetries(TaskSpace::SO3, {})) {
    const PoseSymmetry symmetry(TaskSpace::SO3, space->region(), motion);
    for (int i = 0; i < 5; ++i) {
      const Pose pose = random.pose(TaskSpace::SO3);
      const Eigen::Matrix3d expected =
          motion.base * pose.orientation.toRotationMatrix() * motion.platform.transpose();
      const Pose image = space->pose(symmetry.image(space->position(pose)));
      EXPECT_TRUE(image.orientation.toRotationMatrix().isApprox(expected, 1e-12)) << motion.base << '\n'
                                                                                  << motion.platform;
    }
  }
}

TEST(MapSymmetry, IsThatOfTheWorkingModesThatAreMapped) {
  MapOptions options;
  options.resolution = 0.5;
  options.modes = {*WorkingMode::from_signs({1, -1})};
  EXPECT_TRUE(compute_aspect_map(test::five_bar(), options).map->symmetry_use()->motions.empty());
  options.modes.push_back(*WorkingMode::from_signs({-1, 1}));
  const auto map = compute_aspect_map(test::five_bar(), options).map;
  EXPECT_EQ(map->symmetry_use()->computed_modes, 1U);
  EXPECT_EQ(map->proved_count(), 6U);
}

}  // namespace
}  // namespace parallel_aspects
