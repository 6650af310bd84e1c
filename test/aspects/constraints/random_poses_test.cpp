// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_contents.h"
#include "aspects/tree/pose_space.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/singularity/indices.h"

#include <gtest/gtest.h>

#include "support/configuration_at.h"
#include "support/robots/shipped.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

namespace parallel_aspects {
namespace {

using Number = long double;

/// What rounding of the formulas may come to, and of the bounds in double precision that they are compared
/// with. In squares of sines and in indices.
constexpr Number rounding = 1e-13L;

/// Poses, half of them all over the region of a map and half in leaves that are not outside, each asked for
/// in a random working mode and evaluated by formulas of the test alone. As many as RANDOM_POSES says, where
/// it is set, such as ten million.
class RandomPoses : public testing::TestWithParam<std::string> {
 protected:
  /// RANDOM_POSES=10000000 asks for so many of each robot, in maps of the default resolution.
  static bool is_thorough() { return std::getenv("RANDOM_POSES") != nullptr; }
  static std::size_t pose_count(const Manipulator& robot) {
    if (is_thorough()) return std::strtoul(std::getenv("RANDOM_POSES"), nullptr, 10);
    return test::thinned<std::size_t>(degrees_of_freedom(robot.task_space()) < 3 ? 20000 : 2000);
  }

  void compare(const Margins& margins) {
    ConstraintKinds kinds;
    kinds[index_of(ConstraintKind::actuated_limits)] = true;
    const auto plain = test::shipped(GetParam())->mapped_manipulator()->with_constraints(kinds);
    const auto robot = plain->with_margins(margins);
    const MapResult result = compute_aspect_map(robot, options_of(*robot));
    ASSERT_TRUE(result.map) << result.message;
    const std::size_t poses = pose_count(*robot);
    const AspectMap::Contents& contents = result.map->contents();
    const std::vector<Leaves> leaves = leaves_of(contents);
    const Leaves anywhere;
    std::size_t inside = 0, outside = 0;
    for (std::size_t n = 0; n < poses && !HasFailure(); ++n) {
      const std::size_t k = random_() % contents.modes.size();
      const WorkingMode& mode = contents.modes[k];
      const Pose pose = contents.tree.space().pose(draw(contents, n % 2 == 0 ? leaves[k] : anywhere));
      const Location location = result.map->locate(pose, mode);
      if (location.status == LocationStatus::inside) {
        ++inside;
        const int sign =
            result.map->aspects()[static_cast<std::size_t>(location.aspect - 1)].determinant_sign;
        EXPECT_TRUE(may_be_inside(*robot, pose, mode, sign)) << text(*robot, pose, mode);
      } else if (location.status == LocationStatus::outside) {
        ++outside;
        EXPECT_TRUE(may_be_outside(*robot, pose, mode)) << text(*robot, pose, mode);
      }
    }
    std::cout << "| " << GetParam() << " | " << to_string(margins) << " | " << inside << " | " << outside
              << " | " << poses - inside - outside << " |\n";
    // A coarse map may decide little with margins.
    if (margins.any() && !is_thorough()) return;
    EXPECT_GT(inside, poses / 100);
  }

 private:
  using Leaves = std::vector<NodeIndex>;

  /// Coarse with three degrees of freedom, unless there is time.
  static MapOptions options_of(const Manipulator& robot) {
    MapOptions options;
    if (is_thorough() || degrees_of_freedom(robot.task_space()) < 3) return options;
    options.resolution = robot.task_space() == TaskSpace::SO3 ? 0.15 : 0.04 * robot.size();
    options.extra_levels = 0;
    return options;
  }

  /// By working mode, those that are not outside.
  static std::vector<Leaves> leaves_of(const AspectMap::Contents& contents) {
    std::vector<Leaves> leaves(contents.modes.size());
    for (std::size_t k = 0; k < leaves.size(); ++k)
      for (NodeIndex node = 0; node < contents.tree.node_count(); ++node)
        if (const LeafState state = contents.tree.state(node, k); !state.is_divided() && !state.is_outside())
          leaves[k].push_back(node);
    return leaves;
  }

  /// In one of the leaves, or anywhere where there are none.
  MapPosition draw(const AspectMap::Contents& contents, const Leaves& leaves) {
    if (leaves.empty()) return test::random_position(contents.tree.space(), random_);
    const NodeIndex leaf = leaves[random_() % leaves.size()];
    const Box box = contents.tree.box(leaf);
    MapPosition position{contents.tree.place(leaf).root, {}};
    for (std::size_t i = 0; i < box.dimension; ++i)
      position.point[i] = test::uniform(random_, box.lower[i], box.upper[i]);
    return position;
  }

  static bool may_be_inside(const Manipulator& robot, const Pose& pose, const WorkingMode& mode, int sign) {
    const test::ConfigurationAt<Number> at(robot, pose, mode);
    const Margins& margins = robot.constraints().margins;
    const Number serial = static_cast<Number>(margins.serial);
    return at.squared_serial() > serial * serial - rounding && at.within_limits() > -rounding &&
           sign * at.parallel() > static_cast<Number>(margins.parallel) - rounding &&
           std::abs(at.determinant()) > static_cast<Number>(margins.det_a) * (1.0L - 1e-12L);
  }

  /// Whether something is missing that a configuration of an aspect has.
  static bool may_be_outside(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
    const test::ConfigurationAt<Number> at(robot, pose, mode);
    const Margins& margins = robot.constraints().margins;
    const Number serial = static_cast<Number>(margins.serial);
    return at.squared_serial() < serial * serial + rounding || at.within_limits() < rounding ||
           std::abs(at.parallel()) < static_cast<Number>(margins.parallel) + rounding ||
           std::abs(at.determinant()) < static_cast<Number>(margins.det_a) * (1.0L + 1e-12L);
  }

  static std::string text(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
    const test::ConfigurationAt<Number> at(robot, pose, mode);
    return robot.name() + " at " + to_string(robot.task_space(), pose) + " in " + to_string(mode) +
           ": least square of a serial index " + std::to_string(at.squared_serial()) + ", parallel index " +
           std::to_string(at.parallel()) + ", within limits by " + std::to_string(at.within_limits());
  }

  std::mt19937_64 random_{17};
};

TEST_P(RandomPoses, DoNotContradictTheMap) {
  compare({});
  compare({0.2, 0.1, 0.0});
}

INSTANTIATE_TEST_SUITE_P(Robots, RandomPoses,
                         testing::Values("five_bar", "bipod", "three_prr", "linear_delta", "three_rpr",
                                         "three_rrr", "delta", "agile_eye", "spherical_3rrr"));

}  // namespace
}  // namespace parallel_aspects
