// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/map.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>

namespace parallel_aspects::ask {
namespace {

MapQuestion coarse() {
  MapQuestion question;
  question.source.resolution = 0.5;
  return question;
}

TEST(MapAnswer, SaysWhatTheMapSays) {
  Session session(test::five_bar());
  MapQuestion question = coarse();
  question.index = ParallelIndex::normalised;
  question.neighbours = true;
  const auto outcome = answer(session, question);
  ASSERT_TRUE(outcome);
  const MapAnswer& found = outcome.answer;
  MapOptions options;
  options.resolution = 0.5;
  const auto map = compute_aspect_map(session.robot(), options).map;
  ASSERT_EQ(found.aspects.size(), map->aspects().size());
  for (const MappedAspect& each : found.aspects) {
    const Aspect& aspect = map->aspects().at(static_cast<std::size_t>(each.aspect.id - 1));
    EXPECT_EQ(each.aspect.measure_lower, aspect.measure_lower);
    EXPECT_EQ(each.bounds.at(1).upper, aspect.bounds.upper[1]);
    EXPECT_LE(each.deepest_index.value().lower, each.deepest_index.value().upper);
  }
  EXPECT_EQ(found.proved_count, static_cast<int>(map->proved_count()));
  EXPECT_EQ(found.neighbours.value().size(), find_neighbours(*map).size());
  EXPECT_EQ(found.no_aspect, "");
}

TEST(MapAnswer, FilesAreNeededWhereThatIsSaid) {
  Session session(test::five_bar());
  MapQuestion question = coarse();
  question.source.save = testing::TempDir() + "asked.map";
  ASSERT_TRUE(answer(session, question));
  question.source.load = question.source.save;
  question.source.save.clear();
  question.source.must_load = true;
  EXPECT_TRUE(answer(session, question).answer.loaded);
  question.source.resolution = 0.25;
  EXPECT_EQ(answer(session, question).problems.size(), 1U);
  std::remove(question.source.load.c_str());
}

TEST(MapAnswer, WithSixDegreesOfFreedomThereIsARoadmap) {
  Session session(test::shipped("stewart")->mapped_manipulator());
  MapQuestion question;
  question.roadmap.samples.emplace().value = 40;
  const auto outcome = answer(session, question);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome.answer.map, nullptr);
  const SampledAspects& found = outcome.answer.sampled.value();
  ASSERT_EQ(found.sides.size(), found.roadmap->proved_count());
  for (std::size_t i = 0; i < found.sides.size(); ++i) {
    const SampledSide& side = found.sides[i];
    ASSERT_EQ(side.samples, found.roadmap->sides()[i].poses.size());
    double largest = 0.0;
    for (const std::uint32_t pose : found.roadmap->sides()[i].poses) {
      const Pose& sample = found.roadmap->poses()[pose];
      const JointVector q = inverse(*session.robot(), sample, side.mode).q;
      largest = std::max(largest, parallel_index(*session.robot(), sample, q));
    }
    EXPECT_EQ(*std::max_element(side.largest_indices.begin(), side.largest_indices.end()), largest);
  }
  question.source.resolution = 0.1;
  question.neighbours = true;
  const auto refused = answer(session, question);
  ASSERT_EQ(refused.problems.size(), 1U);
  EXPECT_EQ(text_of(refused.problems[0], plain_name),
            "resolution and neighbours are for maps of boxes, and in SE3 only slices have these; give slice, "
            "or leave them out.");
}

TEST(MapAnswer, FieldsThatExcludeEachOtherAreNamed) {
  Session planar(test::shipped("three_rpr")->mapped_manipulator());
  MapQuestion question;
  Problems none;
  question.source.hold = make_slice(*planar.robot(), {{"phi", 0.0}}, none);
  question.complete = true;
  question.region = {{"x", 0.0, 1.0}};
  const auto refused = answer(planar, question);
  ASSERT_EQ(refused.problems.size(), 2U);
  EXPECT_EQ(refused.problems[0].field, "complete");
  EXPECT_EQ(refused.problems[1].field, "region");
}

}  // namespace
}  // namespace parallel_aspects::ask
