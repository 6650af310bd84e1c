// SPDX-License-Identifier: BSD-3-Clause
//
// Short, clear and fast paths between the same random ends.
#include "parallel_aspects/aspects/basins.h"
#include "parallel_aspects/motion/plan_path.h"
#include "parallel_aspects/motion/time_path.h"

#include <gtest/gtest.h>

#include "support/campaign_figures.h"
#include "support/random_path_end.h"
#include "support/robots.h"
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

struct Case {
  const char* name;
  Robot robot;
  std::optional<double> resolution;
  int pairs;
  PathPolicy policy;
  bool differs;  // whether some ends are not the narrowest places of the paths between them
};

class PathPreferenceOf : public testing::TestWithParam<Case> {};

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
  const PathTime time = path_timer(certifier, pose_between, test::usual_accelerations(*robot));
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
    testing::Values(Case{"five_bar", test::five_bar(), std::nullopt, 60, PathPolicy::stay, true},
                    Case{"five_bar_serial", test::five_bar(), std::nullopt, 60, PathPolicy::serial, true},
                    Case{"three_rpr", test::three_rpr(), 1.5, 20, PathPolicy::stay, true},
                    Case{"three_rrr", test::three_rrr(), 1.0, 20, PathPolicy::stay, true},
                    Case{"delta", test::delta(), 0.3, 20, PathPolicy::stay, false}),
    [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace parallel_aspects
