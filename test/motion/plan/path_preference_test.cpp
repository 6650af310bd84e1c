// SPDX-License-Identifier: BSD-3-Clause
//
// Short, clear and fast paths between the same random ends.
#include "motion/plan/path_builder.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/motion/plan_path.h"

#include <gtest/gtest.h>

#include "support/campaign_figures.h"
#include "support/path_samples.h"
#include "support/robots/robots.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::Robot;

Robot with_speeds(const Robot& robot) {
  ManipulatorDescription description = robot->description();
  for (Leg& leg : description.legs) leg.limits.velocity = leg.actuated_by_angle() ? 2.0 : 0.5 * robot->size();
  return std::make_shared<const Manipulator>(description);
}

struct PreferenceCase {
  const char* name;
  Robot robot;
  std::optional<double> resolution;
  int pairs;
  PathPolicy policy;
  bool differs;  // whether some ends are not the narrowest places of the paths between them
};

class PathPreferenceOf : public testing::TestWithParam<PreferenceCase> {};

/// What the paths between some ends have, one entry a question.
struct Compared {
  std::vector<double> short_index, clear_index, best_index;  // the last proved to be more than any path keeps
  int clearer = 0, faster = 0;
};

TEST_P(PathPreferenceOf, IsWhatItSays) {
  const Robot robot = with_speeds(GetParam().robot);
  MapOptions options;
  options.resolution = GetParam().resolution;
  const auto map = test::map_of(robot, options);
  PathPlanner planner(map);
  const SegmentCertifier certifier(robot);
  const PathTime time =
      path_timer(certifier, between_poses(TaskSpace::SE3), test::usual_accelerations(*robot));
  const PathPolicy policy = GetParam().policy;
  Compared compared;
  const int pairs = test::is_sanitized ? 3 : GetParam().pairs;
  for (int i = 0; i < pairs; ++i) {
    SCOPED_TRACE("pair " + std::to_string(i));
    std::mt19937_64 random(static_cast<unsigned>(i));
    const Aspect &first = test::random_aspect(*map, random),
                 &second = policy == PathPolicy::stay ? first : test::random_aspect(*map, random);
    const PathEnd from = test::random_path_end(*map, first, random),
                  to = test::random_path_end(*map, second, random);
    const PlannedPath shortest = planner.plan(from, to, {policy, PathPreference::shortest, {}}),
                      clear = planner.plan(from, to, {policy, PathPreference::clear, {}}),
                      fast = planner.plan(from, to, {policy, PathPreference::fast, time});
    ASSERT_EQ(shortest.answer, clear.answer) << clear.message;
    ASSERT_EQ(shortest.answer, fast.answer) << fast.message;
    if (!shortest) continue;
    EXPECT_EQ(test::contradictions(*robot, clear, 2000), 0);
    EXPECT_EQ(test::contradictions(*robot, fast, 2000), 0);
    EXPECT_GE(clear.least_index, shortest.least_index);
    EXPECT_LE(time(fast), time(shortest));
    const PlannedPath quick = planner.plan(from, to, {policy, PathPreference::quick, {}});
    for (const PlannedPath* other : {&clear, &fast, &quick})
      EXPECT_LE(test::path_length(*robot, shortest), test::path_length(*robot, *other));
    compared.clearer += clear.least_index > 1.01 * shortest.least_index ? 1 : 0;
    compared.faster += time(fast) < 0.99 * time(shortest) ? 1 : 0;
    compared.short_index.push_back(shortest.least_index);
    compared.clear_index.push_back(clear.least_index);
    if (policy != PathPolicy::stay) continue;
    const Bottleneck best = find_bottleneck(*map, first.mode, from.pose, to.pose, ParallelIndex::normalised,
                                            {0.05, 0.001, 2000, 100000});
    if (best.status == BottleneckStatus::found)
      compared.best_index.push_back(clear.least_index / best.index.upper);
  }
  std::printf("%s: %zu paths, clearer %d, faster %d, index median %.4f and %.4f, of the best %.3f\n",
              GetParam().name, compared.short_index.size(), compared.clearer, compared.faster,
              test::quantile(compared.short_index, 0.5), test::quantile(compared.clear_index, 0.5),
              test::quantile(compared.best_index, 0.5));
  // In the median no path keeps a larger index than the clear one but by a twentieth.
  EXPECT_FALSE(test::quantile(compared.best_index, 0.5) < 0.95);
  if (test::is_sanitized || !GetParam().differs) return;
  EXPECT_GT(compared.clearer, 0);
  EXPECT_GT(compared.faster, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Robots, PathPreferenceOf,
    testing::Values(PreferenceCase{"five_bar", test::five_bar(), std::nullopt, 60, PathPolicy::stay, true},
                    PreferenceCase{"five_bar_serial", test::five_bar(), std::nullopt, 60, PathPolicy::serial,
                                   true},
                    PreferenceCase{"three_rpr", test::three_rpr(), 1.5, 20, PathPolicy::stay, true},
                    PreferenceCase{"three_rrr", test::three_rrr(), 1.0, 20, PathPolicy::stay, true},
                    PreferenceCase{"delta", test::delta(), 0.3, 20, PathPolicy::stay, false}),
    [](const auto& each) { return std::string(each.param.name); });

PlannedPath path_through(const Robot& robot, const std::vector<Pose>& poses) {
  PathBuilder builder(*robot, between_poses(TaskSpace::SE3));
  builder.go(poses, working_modes(*robot).front());
  return builder.take("");
}

// Points on the straight way do not make a path longer; a detour does, and so does the long way round.
TEST(PathPreference, KnowsPathsThanWhichNoneIsShorter) {
  const Robot robot = test::three_rpr();
  const Pose from = Pose::planar(14.0, -3.0, 2.1), to = Pose::planar(-5.0, -14.0, -0.9);
  const auto on_the_way = [&](double t) { return pose_between(from, to, t); };
  EXPECT_TRUE(is_straight(path_through(robot, {from, to})));
  EXPECT_TRUE(is_straight(path_through(robot, {from, on_the_way(0.2), on_the_way(0.5), to})));
  Pose beside = on_the_way(0.5);
  beside.position.y() += 0.1;
  EXPECT_FALSE(is_straight(path_through(robot, {from, beside, to})));
  EXPECT_FALSE(is_straight(path_through(robot, {from, Pose::planar(4.5, -8.5, 2.6), to})));
  const Pose half = Pose::planar(4.5, -8.5, 0.6 + EIGEN_PI);
  EXPECT_FALSE(is_straight(path_through(robot, {from, half, to})));
  EXPECT_FALSE(is_straight(PlannedPath()));
  PlannedPath crossed = path_through(robot, {from, to});
  crossed.crossings.emplace_back();
  EXPECT_FALSE(is_straight(crossed));
}

// About half a turn, rounding would decide which way round a segment goes.
TEST(PathPreference, LeavesNoSegmentThatTurnsByMoreThanAQuarter) {
  MapOptions options;
  options.resolution = 1.5;
  const auto map = test::map_of(test::three_rpr(), options);
  PathPlanner planner(map);
  int divided = 0;
  for (unsigned i = 0; i < (test::is_sanitized ? 20U : 200U); ++i) {
    SCOPED_TRACE("pair " + std::to_string(i));
    std::mt19937_64 random(i);
    const Aspect& aspect = test::random_aspect(*map, random);
    const PathEnd from = test::random_path_end(*map, aspect, random),
                  to = test::random_path_end(*map, aspect, random);
    for (const PathPreference prefer : {PathPreference::quick, PathPreference::clear}) {
      const PlannedPath path = planner.plan(from, to, {PathPolicy::stay, prefer, {}});
      if (!path) continue;
      double turned = 0.0;
      for (std::size_t k = 0; k + 1 < path.points.size(); ++k) {
        const double turn =
            path.points[k].pose.orientation.angularDistance(path.points[k + 1].pose.orientation);
        EXPECT_LE(turn, 0.5 * EIGEN_PI * (1.0 + 1e-9));
        turned += turn;
      }
      EXPECT_NEAR(path.turned, turned, 1e-9);
      EXPECT_EQ(test::contradictions(*map->manipulator(), path, 500), 0);
      divided += path.points.size() > 2 && is_straight(path) ? 1 : 0;
    }
  }
  EXPECT_TRUE(test::is_sanitized || divided > 0);  // 20 pairs are too few to meet one
}

}  // namespace
}  // namespace parallel_aspects
