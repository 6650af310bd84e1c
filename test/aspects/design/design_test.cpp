// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/design.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

DesignParameter named(const Manipulator& robot, const std::string& name) {
  for (const DesignParameter& each : design_parameters(robot))
    if (each.name == name) return each;
  ADD_FAILURE() << "no parameter " << name;
  return {};
}

TEST(Design, ParametersAreTheNumbersOfTheLegs) {
  const auto robot = test::five_bar();
  std::vector<std::string> names;
  for (const DesignParameter& each : design_parameters(*robot)) names.push_back(each.name);
  EXPECT_EQ(names, (std::vector<std::string>{"crank_1", "rod_1", "base_1_x", "base_1_y", "anchor_1_x",
                                             "anchor_1_y", "crank_2", "rod_2", "base_2_x", "base_2_y",
                                             "anchor_2_x", "anchor_2_y"}));
  EXPECT_EQ(named(*robot, "crank_1").value, 8.0);
  EXPECT_EQ(named(*robot, "base_2_x").value, 9.0);
  EXPECT_EQ(named(*robot, "crank_1").tied, std::vector<std::string>()) << "the legs differ";
}

TEST(Design, ValuesAreSet) {
  const auto design = with_design(*test::five_bar(), {{"rod_2", 7.5}, {"base_2_x", 8.5}});
  EXPECT_EQ(design->leg(1).rod_length, 7.5);
  EXPECT_EQ(design->leg(1).base_point().x(), 8.5);
  EXPECT_EQ(design->leg(0).rod_length, 5.0);
  const auto all = with_design(*test::five_bar(), {{"crank", 6.0}});
  EXPECT_EQ(all->leg(0).crank()->radius, 6.0);
  EXPECT_EQ(all->leg(1).crank()->radius, 6.0);
}

// Legs that (-x, y) takes to each other.
std::shared_ptr<const Manipulator> mirrored() {
  return test::manipulator("mirrored", TaskSpace::T2,
                           {test::planar_revolute_leg(0, {-2.0, 1.0}, 3.0, 4.0, {-0.5, 0.0}),
                            test::planar_revolute_leg(1, {2.0, 1.0}, 3.0, 4.0, {0.5, 0.0})});
}

TEST(Design, WhatIsSymmetricStaysSo) {
  const auto robot = mirrored();
  EXPECT_EQ(named(*robot, "crank_1").tied, std::vector<std::string>{"crank_2"});
  EXPECT_EQ(named(*robot, "base_2_x").tied, std::vector<std::string>{"base_1_x"});
  const auto design = with_design(*robot, {{"crank_2", 2.5}, {"base_1_x", -1.5}, {"anchor_1_x", -0.25}});
  EXPECT_EQ(design->leg(0).crank()->radius, 2.5);
  EXPECT_EQ(design->leg(1).base_point().x(), 1.5);
  EXPECT_EQ(design->leg(1).anchor.x(), 0.25);
  const auto untied = with_design(*robot, {{"crank_2", 2.5}}, false);
  EXPECT_EQ(untied->leg(0).crank()->radius, 3.0);
}

TEST(Design, NamesThatDoNotGoTogetherAreRefused) {
  const auto robot = mirrored();
  EXPECT_EQ(problems_of(*robot, {"crank_1", "rod_1"}), Problems{});
  EXPECT_EQ(problems_of(*robot, {"crank_1", "crank_2"}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {"crank_1", "crank_2"}, false), Problems{});
  EXPECT_EQ(problems_of(*robot, {"crank", "crank_2"}, false).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {"wheel_1"}),
            Problems{"There is no parameter 'wheel_1'; the first leg has crank_1, rod_1, base_1_x, base_1_y, "
                     "anchor_1_x, anchor_1_y."});
}

TEST(Design, FiguresAreThoseOfTheMap) {
  const auto robot = test::five_bar();
  DesignQuestion question;
  question.measures = question.clearance = true;
  question.workspace.emplace().shape = RegularShape::disc;
  const DesignFigures figures = figures_of(robot, question);
  ASSERT_EQ(figures.status, DesignStatus::mapped) << figures.message;
  const std::vector<std::string> names = figure_names(question);
  ASSERT_EQ(figures.values.size(), names.size());
  const auto value = [&](const std::string& name) {
    return *figures.values[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) -
                                                    names.begin())];
  };
  const MapResult map = compute_aspect_map(robot, {});
  ASSERT_TRUE(map.map);
  double sum = 0.0;
  for (const Aspect& aspect : map.map->aspects()) sum += aspect.measure_lower;
  EXPECT_EQ(value("aspects_at_least"), 10.0);
  EXPECT_EQ(value("measure_lower"), sum);
  EXPECT_NEAR(value("workspace_lower"), 4.6, 0.25);
  EXPECT_GT(value("clearance"), 4.0);
}

TEST(Design, WhatCannotBeIsReported) {
  const auto robot = test::five_bar();
  EXPECT_THROW(with_design(*robot, {{"rod_1", -1.0}}), InvalidDescription);
  EXPECT_THROW(with_design(*robot, {{"rod_1", std::numeric_limits<double>::quiet_NaN()}}),
               InvalidDescription);
  const auto apart = with_design(*robot, {{"base_2_x", 100.0}});
  EXPECT_EQ(figures_of(apart, {}).status, DesignStatus::unassembled);
  DesignQuestion fine;
  fine.map.resolution = 1e-30;
  EXPECT_EQ(figures_of(robot, fine).status, DesignStatus::not_mapped);
  const std::atomic<bool> cancelled{true};
  EXPECT_EQ(figures_of(robot, {}, {nullptr, &cancelled}).status, DesignStatus::cancelled);
}

}  // namespace
}  // namespace parallel_aspects
