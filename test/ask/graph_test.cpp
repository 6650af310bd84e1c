// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/map.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/texts.h"
#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects::ask {
namespace {

// The sets are what gates join, found by joining them here again.
void expect_joined_by_gates(const GraphAnswer& found) {
  std::vector<int> joined(found.aspects.size() + 1);
  std::iota(joined.begin(), joined.end(), 0);
  for (std::size_t round = 0; round < joined.size(); ++round)
    for (const Neighbours& gate : found.graph->gates) {
      if (!gate.proved || gate.crossing != Crossing::serial) continue;
      int &first = joined.at(static_cast<std::size_t>(gate.first)),
          &second = joined.at(static_cast<std::size_t>(gate.second));
      first = second = std::min(first, second);
    }
  std::map<int, std::set<int>> sets;
  for (const GraphNode& each : found.aspects)
    sets[joined.at(static_cast<std::size_t>(each.id))].insert(each.set);
  EXPECT_EQ(sets.size(), found.sets.size());
  for (const auto& [id, numbers] : sets) EXPECT_EQ(numbers.size(), 1U) << "of aspect " << id;
}

TEST(Graph, SetsAreWhatGatesJoin) {
  Session session(test::five_bar());
  GraphQuestion question;
  question.map.resolution = 0.5;
  const auto outcome = answer(session, question);
  ASSERT_TRUE(outcome);
  const GraphAnswer& found = outcome.answer;
  ASSERT_EQ(found.aspects.size(), found.map->aspects().size());
  expect_joined_by_gates(found);
  for (const JoinedAspects& set : found.sets) EXPECT_GT(set.workspace_lower.value(), 0.0);
  EXPECT_TRUE(test::has(found.reason, "joined through serial gates"));
}

TEST(Graph, WithSixDegreesOfFreedomIsOverARoadmap) {
  Session session(test::shipped("stewart")->mapped_manipulator());
  GraphQuestion question;
  question.roadmap.samples.emplace().value = 20;
  const auto outcome = answer(session, question);
  ASSERT_TRUE(outcome);
  expect_joined_by_gates(outcome.answer);
  for (const JoinedAspects& set : outcome.answer.sets) EXPECT_FALSE(set.workspace_lower);
  question.map.load = "some.map";
  const auto refused = answer(session, question);
  ASSERT_EQ(refused.problems.size(), 1U);
  EXPECT_EQ(refused.problems.front().field, "resolution");
}

}  // namespace
}  // namespace parallel_aspects::ask
