// SPDX-License-Identifier: BSD-3-Clause
// What a map made ready for distances claims of singularities, against singular poses that are found without
// enclosures; and its contract.
#include "aspects/map/map_contents.h"
#include "distance/anchor_metric.h"
#include "distance/leaf_view.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/robots.h"
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>

namespace parallel_aspects {
namespace {

using Robot = std::shared_ptr<const Manipulator>;

std::shared_ptr<const AspectMap> coarse_map(const Robot& robot) {
  MapOptions options;
  options.resolution = robot->task_space() == TaskSpace::SO3 ? 0.6 : 0.06 * robot->size();
  options.extra_levels = 0;
  return compute_aspect_map(robot, options).map;
}

double determinant_at(const Robot& robot, const Pose& pose, const WorkingMode& mode) {
  const InverseSolution solution = inverse(*robot, pose, mode);
  return solution.status == InverseStatus::out_of_reach ? std::nan("")
                                                        : direct_determinant(*robot, pose, solution.q);
}

/// Where det A vanishes between two poses, by bisection; nothing where it has one sign or a leg does not
/// reach.
std::optional<Pose> singular_between(const Robot& robot, Pose from, Pose to, const WorkingMode& mode) {
  const double first = determinant_at(robot, from, mode);
  if (!(first * determinant_at(robot, to, mode) < 0.0)) return std::nullopt;
  for (int i = 0; i < 80; ++i) {
    const Pose middle = pose_between(from, to, 0.5);
    const double value = determinant_at(robot, middle, mode);
    if (std::isnan(value)) return std::nullopt;
    (value * first > 0.0 ? from : to) = middle;
  }
  // Between poses on either side of a gap that a leg cannot reach across det A jumps.
  return std::abs(determinant_at(robot, to, mode)) < 1e-9 * std::abs(first) ? std::optional<Pose>(to)
                                                                            : std::nullopt;
}

/// The coordinates of a pose about a center: of the displacement of the centroid, and 2 W^-1 v of the
/// rotation.
Eigen::VectorXd coordinates(const Robot& robot, const Pose& center, const Pose& pose) {
  const AnchorMetric metric(*robot);
  const TaskSpace space = robot->task_space();
  const Eigen::Vector3d moved = pose.transform(metric.center) - center.transform(metric.center);
  Eigen::Quaterniond by = center.orientation.conjugate() * pose.orientation;
  if (by.w() < 0.0) by.coeffs() *= -1.0;
  if (space == TaskSpace::SO3) return 2.0 * (metric.half_turns.inverse() * by.vec());
  if (space == TaskSpace::SE2)
    return Eigen::Vector3d(moved.x(), moved.y(), 2.0 * by.z() / metric.half_turns(2, 2));
  return moved.head(static_cast<Eigen::Index>(robot->leg_count()));
}

template <TaskSpace space>
bool is_in_a_leaf(const Robot& robot, const LeafTree& tree, const Pose& pose) {
  const AnchorMetric metric(*robot);
  for (const SingularLeaf& leaf : tree.leaves) {
    const Pose center = pose_of<space>(leaf.center, metric);
    if (!(anchor_distance(*robot, center, pose) <= 1.000001 * static_cast<double>(leaf.radius))) continue;
    if (!leaf.has_plane()) return true;
    const Eigen::VectorXd y = coordinates(robot, center, pose);
    double along = 0.0;
    for (Eigen::Index i = 0; i < y.size(); ++i)
      along += static_cast<double>(leaf.normal[static_cast<std::size_t>(i)]) * y[i];
    if (std::abs(along - static_cast<double>(leaf.offset)) <=
        static_cast<double>(leaf.thickness) + 1e-7 * robot->size())
      return true;
  }
  return false;
}

template <TaskSpace space>
void expect_leaves_hold_singularities(const Robot& robot, int wanted) {
  const auto map = coarse_map(robot);
  ASSERT_TRUE(map);
  const DistanceMap ready(map);
  test::PosePairs random(robot, 20261123);
  int found = 0;
  for (int i = 0; i < 4000 && found < wanted; ++i) {
    const WorkingMode mode = random.mode();
    const auto from = random.reached(mode), to = random.reached(mode);
    if (!from || !to) continue;
    const auto singular = singular_between(robot, *from, *to, mode);
    if (!singular) continue;
    ++found;
    const auto index = mode_index(map->contents(), mode);
    ASSERT_TRUE(index);
    EXPECT_TRUE(is_in_a_leaf<space>(robot, ready.leaves().of(*index), *singular))
        << robot->name() << " " << to_string(mode) << " at " << to_string(space, *singular);
  }
  EXPECT_EQ(found, wanted) << robot->name();
}

TEST(DistanceMap, LeavesHoldEverySingularity) {
  expect_leaves_hold_singularities<TaskSpace::T2>(test::five_bar(), 100);
  expect_leaves_hold_singularities<TaskSpace::T2>(test::bipod(), 100);
  expect_leaves_hold_singularities<TaskSpace::SE2>(test::three_rrr(), 50);
  expect_leaves_hold_singularities<TaskSpace::SE2>(test::three_rpr(), 50);
  expect_leaves_hold_singularities<TaskSpace::T3>(test::delta(), 30);
  expect_leaves_hold_singularities<TaskSpace::SO3>(test::spherical_three_rrr(), 50);
}

// The metric from any pose is no less than what a view bounds leaves and their balls by.
template <TaskSpace space>
void expect_balls_hold_what_is_below(const Robot& robot) {
  const DistanceMap ready(coarse_map(robot));
  const AnchorMetric metric(*robot);
  test::PosePairs random(robot, 20261124);
  const WorkingMode mode = working_modes(*robot).front();
  const LeafTree& tree = ready.leaves().of(0);
  ASSERT_FALSE(tree.levels.empty());
  LeafView<space> view(metric);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) {
    const auto pose = random.reached(mode);
    ASSERT_TRUE(pose);
    const RoundingUpward rounding;
    view.look_from(*pose, ready.leaves().extent());
    for (std::size_t k = 0; k < tree.leaves.size(); ++k) {
      const SingularLeaf& leaf = tree.leaves[k];
      const double distance = anchor_distance(*robot, *pose, pose_of<space>(leaf.center, metric));
      ASSERT_NEAR(view.distance(leaf.center), distance, 1e-9 * (1.0 + distance)) << robot->name();
      ASSERT_LE(view.least_distance(leaf, infinite), distance + static_cast<double>(leaf.radius))
          << robot->name();
      std::size_t above = k;
      for (const auto& level : tree.levels) {
        above /= LeafTree::children;
        ASSERT_LE(view.least_distance(level[above]),
                  view.least_distance(LeafBall{leaf.center, leaf.radius}) + 1e-9)
            << robot->name();
      }
    }
  }
}

TEST(DistanceMap, BallsHoldWhatIsBelow) {
  expect_balls_hold_what_is_below<TaskSpace::T2>(test::five_bar());
  expect_balls_hold_what_is_below<TaskSpace::SE2>(test::three_rpr());
  expect_balls_hold_what_is_below<TaskSpace::SO3>(test::spherical_three_rrr());
}

// With a map of the default resolution nearly all bounds are tight.
TEST(DistanceMap, BoundsAreTightWithIt) {
  const Robot robot = test::five_bar();
  BoundaryDistanceMeter meter(robot);
  meter.use(std::make_shared<const DistanceMap>(compute_aspect_map(robot).map));
  test::PosePairs random(robot, 20261125);
  int near = 0, tight = 0, boxes = 0;
  for (int i = 0; i < 200; ++i) {
    const WorkingMode mode = random.mode();
    const auto pose = random.reached(mode);
    ASSERT_TRUE(pose);
    const BoundaryDistance parallel = meter.measure(*pose, mode).parallel;
    near += parallel.lower >= 0.949 * parallel.upper;
    tight += parallel.status == DistanceStatus::tight;
    boxes += parallel.boxes;
  }
  EXPECT_GE(near, 195);
  EXPECT_GE(tight, 180);
  EXPECT_LE(boxes, 200 * 20);
}

TEST(DistanceMap, OthersAreRefused) {
  BoundaryDistanceMeter meter(test::bipod());
  EXPECT_THROW(DistanceMap(nullptr), InvalidDescription);
  EXPECT_THROW(meter.use(std::make_shared<const DistanceMap>(coarse_map(test::five_bar()))),
               InvalidDescription);
  meter.use(nullptr);
  MapOptions slice;
  slice.slice = MapSlice{};
  slice.slice->held = Pose::planar(4.5, 8.0);
  slice.slice->moves = {true, false, false};
  const MapResult sliced = compute_aspect_map(test::five_bar(), slice);
  ASSERT_TRUE(sliced) << sliced.message;
  EXPECT_THROW(DistanceMap(sliced.map), InvalidDescription);
}

TEST(DistanceMap, ACancelledOneIsNotAsked) {
  const std::atomic<bool> cancelled{true};
  MapControl control;
  control.cancelled = &cancelled;
  const Robot robot = test::five_bar();
  const auto map = coarse_map(robot);
  BoundaryDistanceMeter meter(robot), without(robot);
  meter.use(std::make_shared<const DistanceMap>(map, control));
  const Pose pose = Pose::planar(4.5, 8.0);
  const WorkingMode mode = *WorkingMode::from_signs({-1, 1});
  EXPECT_EQ(meter.measure(pose, mode).parallel.boxes, without.measure(pose, mode).parallel.boxes);
}

}  // namespace
}  // namespace parallel_aspects
