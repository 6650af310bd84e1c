// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/aspect_map.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <pthread.h>
#include <thread>
#include <time.h>

namespace parallel_aspects {
namespace {

std::shared_ptr<const AspectMap> map_of(const std::shared_ptr<const Manipulator>& robot, double resolution,
                                        bool use_symmetry = true) {
  MapOptions options;
  options.resolution = resolution;
  options.use_symmetry = use_symmetry;
  const MapResult result = compute_aspect_map(robot, options);
  EXPECT_EQ(result.status, MapStatus::complete) << result.message;
  return result.map;
}

std::string key(const Aspect& aspect) {
  return to_string(aspect.mode) + (aspect.determinant_sign > 0 ? "|+" : "|-");
}

std::map<std::string, int> counts(const AspectMap& map) {
  std::map<std::string, int> result;
  for (const Aspect& aspect : map.aspects()) ++result[key(aspect)];
  return result;
}

const std::map<std::string, int> expected_counts{{"(+,+)|+", 1}, {"(+,+)|-", 1}, {"(-,-)|+", 1},
                                                 {"(-,-)|-", 1}, {"(+,-)|+", 2}, {"(+,-)|-", 1},
                                                 {"(-,+)|+", 1}, {"(-,+)|-", 2}};

// Ten aspects: Chablat & Wenger, "Working modes and aspects in fully parallel manipulators", section 3.5.
TEST(FiveBarMap, HasTheTenAspectsOfThePaper) {
  const auto map = compute_aspect_map(test::five_bar()).map;
  EXPECT_EQ(map->aspects().size(), 10U);
  EXPECT_EQ(map->proved_count(), 10U);
  EXPECT_EQ(map->indeterminate_leaves(), 0U);
  EXPECT_EQ(map->count_at_most().value_or(0), 10U) << "there are no more";
  EXPECT_TRUE(map->unresolved().empty());
  EXPECT_EQ(map->working_modes().size(), 4U);
  EXPECT_EQ(counts(*map), expected_counts);
}

// Areas by brute force: each value twice.
TEST(FiveBarMap, AreasAgreeWithBruteForce) {
  const auto map = map_of(test::five_bar(), 0.02);
  std::vector<double> areas;
  for (const Aspect& aspect : map->aspects()) {
    areas.push_back(aspect.measure);
    EXPECT_LE(aspect.measure_lower, aspect.measure);
    EXPECT_GE(aspect.measure_upper, aspect.measure);
  }
  std::sort(areas.rbegin(), areas.rend());
  const std::vector<double> expected{193.58, 193.58, 135.35, 135.35, 109.78,
                                     109.78, 47.85,  47.85,  3.70,   3.70};
  ASSERT_EQ(areas.size(), expected.size());
  for (std::size_t i = 0; i < areas.size(); ++i) EXPECT_NEAR(areas[i], expected[i], 0.005 * expected[i]);
}

TEST(FiveBarMap, CountDoesNotDependOnTheResolution) {
  for (const double resolution : {3.0, 1.0, 0.5, 0.3, 0.2, 0.07, 0.03}) {
    const auto map = map_of(test::five_bar(), resolution);
    EXPECT_EQ(map->proved_count(), 10U) << "resolution " << resolution;
    EXPECT_EQ(map->count_at_most().value_or(0), 10U) << "resolution " << resolution;
    EXPECT_EQ(counts(*map), expected_counts) << "resolution " << resolution;
    EXPECT_LE(map->resolution(), resolution);
  }
}

// In mode and sign (+,-|+) Table 1 of the paper prints one aspect and in its reflection (-,+|-) two, or the
// other way round. A reflection in the base line y = 0 maps aspects onto aspects and flips B11, B22 and det A
// alike, so both columns must hold the same number; two of its columns appear swapped.
TEST(FiveBarMap, ReflectionInTheBaseLineFlipsAllSigns) {
  const auto map = map_of(test::five_bar(), 0.1, false);
  for (const Aspect& aspect : map->aspects()) {
    Pose mirrored = aspect.deepest;
    mirrored.position.y() *= -1.0;
    WorkingMode flipped = aspect.mode;
    for (std::size_t j = 0; j < 2; ++j) flipped.set_sign(j, -aspect.mode.sign(j));
    const Location location = map->locate(mirrored, flipped);
    ASSERT_EQ(location.status, LocationStatus::inside) << key(aspect);
    const Aspect& image = map->aspects()[static_cast<std::size_t>(location.aspect - 1)];
    EXPECT_EQ(image.determinant_sign, -aspect.determinant_sign);
    EXPECT_NEAR(image.measure, aspect.measure, 0.01 * aspect.measure);
  }
  std::map<std::string, int> reflected;
  for (const Aspect& aspect : map->aspects()) {
    std::string flipped = key(aspect);
    for (char& c : flipped) c = c == '+' ? '-' : c == '-' ? '+' : c;
    ++reflected[flipped];
  }
  EXPECT_EQ(reflected, counts(*map));
}

TEST(FiveBarMap, DoesNotDependOnTheNumberOfThreads) {
  MapOptions one, two;
  one.threads = 1;
  two.threads = 2;
  const auto a = compute_aspect_map(test::five_bar(), one).map,
             b = compute_aspect_map(test::five_bar(), two).map;
  ASSERT_EQ(a->aspects().size(), b->aspects().size());
  for (std::size_t i = 0; i < a->aspects().size(); ++i) {
    EXPECT_EQ(a->aspects()[i].measure, b->aspects()[i].measure);
    EXPECT_EQ(a->aspects()[i].inside_leaves, b->aspects()[i].inside_leaves);
  }
}

// 2-RPR: det A = 0 exactly on the base line; with q in [2,6] x [4,9] the two aspects mirror each other.
TEST(BipodMap, HasTwoAspectsThatMirrorEachOther) {
  const auto map = map_of(test::bipod(), 0.02, false);
  ASSERT_EQ(map->aspects().size(), 2U);
  EXPECT_EQ(map->proved_count(), 2U);
  EXPECT_EQ(map->working_modes().size(), 1U);
  EXPECT_NEAR(map->aspects()[0].measure, map->aspects()[1].measure, 1e-2);
  EXPECT_GT(map->aspects()[0].measure, 1.0);
}

TEST(AspectMap, RefusesBadOptionsWithASentence) {
  const auto refuses = [](const MapOptions& options) {
    const MapResult result = compute_aspect_map(test::five_bar(), options);
    return result.status == MapStatus::refused && !result.message.empty() && !result.map;
  };
  for (const double resolution : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e-12}) {
    MapOptions options;
    options.resolution = resolution;
    EXPECT_TRUE(refuses(options)) << resolution;
  }
  MapOptions levels;
  levels.extra_levels = 21;
  EXPECT_TRUE(refuses(levels));
  MapOptions region;
  region.region = Box{2, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  EXPECT_TRUE(refuses(region));
}

TEST(AspectMap, RefusesWhatWouldTakeAllMemory) {
  if (test::is_sanitized) GTEST_SKIP() << "takes half a minute under the sanitizers";
  MapOptions options;
  options.resolution = 2e-6;
  const MapResult result = compute_aspect_map(test::five_bar(), options);
  EXPECT_EQ(result.status, MapStatus::refused);
  EXPECT_NE(result.message.find("million boxes"), std::string::npos) << result.message;
}

TEST(AspectMap, CanBeCancelled) {
  std::atomic<bool> cancelled{false};
  MapControl control;
  control.cancelled = &cancelled;
  control.progress = [&cancelled](double share) { cancelled = share > 0.3; };
  MapOptions options;
  options.resolution = 0.01;
  const MapResult result = compute_aspect_map(test::five_bar(), options, control);
  EXPECT_EQ(result.status, MapStatus::cancelled);
  EXPECT_FALSE(result.map);
}

/// A thread's processor time [s].
double processor_time(clockid_t clock) {
  timespec time;
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor time [s] from when a map is cancelled, after so much work [s], until it is given up; 0 if it was
/// complete before.
double time_to_give_up(const std::shared_ptr<const Manipulator>& robot, double resolution, double work) {
  clockid_t clock;
  pthread_getcpuclockid(pthread_self(), &clock);
  std::atomic<bool> cancelled{false}, ended{false};
  double when = 0.0;
  const double start = processor_time(clock);
  std::thread user([&] {
    while (!ended && processor_time(clock) < start + work)
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    when = processor_time(clock);
    cancelled = true;
  });
  MapControl control;
  control.cancelled = &cancelled;
  MapOptions options;
  options.resolution = resolution;
  options.threads = 1;
  const MapResult result = compute_aspect_map(robot, options, control);
  const double end = processor_time(clock);
  ended = true;
  user.join();
  return result.status == MapStatus::cancelled ? end - when : 0.0;
}

// Counted in processor time, which others on the machine do not change.
TEST(AspectMap, GivesUpWithinATenthOfASecondInEveryPhase) {
  if (test::is_sanitized) GTEST_SKIP() << "slower by a factor of its own";
  clockid_t clock;
  pthread_getcpuclockid(pthread_self(), &clock);
  const auto robot = test::three_rpr();
  MapOptions options;
  options.resolution = 1.0;
  options.threads = 1;
  const double start = processor_time(clock);
  ASSERT_TRUE(compute_aspect_map(robot, options));
  const double all = processor_time(clock) - start;
  for (int i = 1; i < 8; ++i)
    EXPECT_LT(time_to_give_up(robot, *options.resolution, all * i / 8.0), 0.1)
        << i << " eighths of " << all << " s";
}

TEST(AspectMap, ProgressRisesToOne) {
  double last = 0.0;
  MapControl control;
  control.progress = [&last](double share) {
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1.0);
    last = share;
  };
  compute_aspect_map(test::five_bar(), {}, control);
  EXPECT_EQ(last, 1.0);
}

TEST(AspectMap, LocatesPosesOfUnknownModesAndPlaces) {
  const auto map = map_of(test::five_bar(), 0.2);
  Pose far;
  far.position << 1000.0, 0.0, 0.0;
  EXPECT_EQ(map->locate(far, map->working_modes()[0]).status, LocationStatus::not_mapped);
  far.position << std::nan(""), 0.0, 0.0;
  EXPECT_EQ(map->locate(far, map->working_modes()[0]).status, LocationStatus::not_mapped);
  EXPECT_EQ(map->locate(Pose(), WorkingMode(5)).status, LocationStatus::not_mapped);
  Pose unreachable;
  unreachable.position << 0.0, 0.5, 0.0;
  EXPECT_EQ(map->locate(unreachable, map->working_modes()[0]).status, LocationStatus::outside);
}

}  // namespace
}  // namespace parallel_aspects
