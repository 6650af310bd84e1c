// SPDX-License-Identifier: BSD-3-Clause
//
// The table of aspects, made of messages.
#include "rviz/panel/aspect_rows.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

AspectSummary aspect(std::uint32_t id, const std::vector<std::int8_t>& mode, int sign, double measure) {
  AspectSummary result;
  result.id = id;
  result.working_mode = mode;
  result.determinant_sign = static_cast<std::int8_t>(sign);
  result.measure = measure;
  result.unit = "m^2";
  result.deepest_clearance = 1.23456;
  result.deepest_pose.orientation.w = 1.0;
  return result;
}

NodeView view_with(const ListAspects::Response& list) {
  NodeView view;
  view.node = "/aspect_node";
  view.connected = true;
  view.state.emplace();
  view.state->working_mode = {1, -1};
  view.state->determinant_sign = 1;
  view.state->aspect = 3;
  view.aspects = std::make_shared<const ListAspects::Response>(list);
  return view;
}

NodeView view_of_three() {
  ListAspects::Response list;
  list.aspects = {aspect(1, {1, 1}, 1, 193.6244), aspect(2, {1, 1}, -1, 12.0), aspect(3, {1, -1}, 1, 0.5)};
  list.aspects[1].unresolved_with = {1};
  list.proved_count = 2;
  list.count_at_most = -1;
  return view_with(list);
}

TEST(AspectRows, AreGroupedByWorkingMode) {
  const auto modes = rows_of(view_of_three());
  ASSERT_EQ(modes.size(), 2U);
  EXPECT_EQ(modes[0].mode, "(+,+)");
  ASSERT_EQ(modes[0].aspects.size(), 2U);
  EXPECT_EQ(modes[0].aspects[0].name, "1");
  EXPECT_EQ(modes[0].aspects[0].size, "194");
  EXPECT_EQ(unit_of(view_of_three()), "m\u00B2");
  EXPECT_EQ(modes[0].aspects[0].clearance, "1.2");
  EXPECT_EQ(modes[0].aspects[0].sign, "> 0");
  EXPECT_EQ(modes[0].aspects[1].sign, "< 0");
  EXPECT_EQ(modes[0].aspects[1].name, "2 ?");
  EXPECT_NE(modes[0].aspects[1].tip.find("May be the same aspect as 1."), std::string::npos);
  EXPECT_EQ(ids_of(view_of_three()), (std::set<std::uint32_t>{1, 2, 3}));
}

TEST(AspectRows, MarkThePresentOne) {
  NodeView view = view_of_three();
  auto modes = rows_of(view);
  EXPECT_FALSE(modes[0].present || modes[0].aspects[0].present);
  EXPECT_TRUE(modes[1].present && modes[1].aspects[0].present);
  view.state->status.code = 3;  // not followed
  modes = rows_of(view);
  EXPECT_FALSE(modes[1].present || modes[1].aspects[0].present);
}

TEST(AspectRows, HaveIndicesWhereTheseAreKnown) {
  NodeView view = view_of_three();
  view.deepest_index =
      std::make_shared<const std::map<std::uint32_t, double>>(std::map<std::uint32_t, double>{{3, 0.87654}});
  const auto modes = rows_of(view);
  EXPECT_EQ(modes[1].aspects[0].index, "0.88");
  EXPECT_EQ(modes[0].aspects[0].index, "");
}

TEST(AspectRows, AreComponentsOfTheRoadmapWhereThereIsNoMap) {
  ListAspects::Response list;
  list.roadmap.resize(1);
  list.roadmap[0].working_mode = {1, -1};
  list.roadmap[0].determinant_sign = 1;
  list.roadmap[0].component_sizes = {812};
  list.proved_count = 1;
  NodeView view = view_with(list);
  view.state->aspect = 0;
  const auto modes = rows_of(view);
  ASSERT_EQ(modes.size(), 1U);
  ASSERT_EQ(modes[0].aspects.size(), 1U);
  EXPECT_EQ(modes[0].aspects[0].name, "component 1");
  EXPECT_EQ(modes[0].aspects[0].size, "812 samples");
  EXPECT_TRUE(modes[0].aspects[0].present);
  EXPECT_TRUE(ids_of(view).empty());
}

TEST(AspectRows, SayHowManyAreProved) {
  EXPECT_EQ(count_text(view_of_three()), "3 aspects found; at least 2, proved.");
  ListAspects::Response list = *view_of_three().aspects;
  list.proved_count = 3;
  list.count_at_most = 3;
  EXPECT_EQ(count_text(view_with(list)), "Exactly 3 aspects, proved.");
  ListAspects::Response none;
  none.status.message = "The map is 3 % done.";
  EXPECT_EQ(count_text(view_with(none)), "The map is 3 % done.");
  EXPECT_NE(count_text(NodeView()).find("Waits"), std::string::npos);
}

}  // namespace
}  // namespace parallel_aspects
