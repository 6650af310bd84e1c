// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/aspect_map.h"

#include <gtest/gtest.h>

#include "support/same_legs.h"
#include <array>
#include <cmath>
#include <variant>

namespace parallel_aspects {
namespace {

using test::loaded_from;

Problems refusal(const std::string& old, const std::string& by) {
  return test::refusal_of_file("five_bar.sdf",
                               test::replaced(test::source_file("test/data/sdf/five_bar.sdf"), old, by));
}

TEST(SdfReader, ReadsTheFiveBar) {
  const auto mechanism = loaded_from("sdf", "five_bar.sdf", "five_bar.yaml");
  test::expect_same_legs(*mechanism, *models::five_bar());
  EXPECT_EQ(mechanism->notes(),
            std::vector<std::string>{"The closures are those that the SDF describes, 1 in all."});
  EXPECT_LT(mechanism->home().q.norm(), 1e-9) << "joints are zero where the robot is drawn";
  const auto map = compute_aspect_map(mechanism->manipulator()).map;
  EXPECT_EQ(map->aspects().size(), 10U);
  EXPECT_EQ(map->proved_count(), 10U);
  EXPECT_EQ(map->count_at_most(), 10U);
}

// In a world, turned and moved there, with a ground beside it; balls join the platform as a parent.
TEST(SdfReader, ReadsAStewartPlatform) {
  const auto mechanism = loaded_from("sdf", "stewart.sdf", "stewart.yaml"), expected = models::stewart();
  const Manipulator &robot = *mechanism->manipulator(), &shipped = *expected->manipulator();
  ASSERT_EQ(robot.task_space(), TaskSpace::SE3);
  ASSERT_EQ(robot.leg_count(), 6U);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
  for (std::size_t k = 0; k < 6; ++k) {
    const Leg &leg = robot.legs()[k], &same = shipped.legs()[k];
    EXPECT_EQ(leg.actuated_joint, "strut_" + std::to_string(k + 1));
    EXPECT_LT((leg.base_point() - same.base_point()).norm(), 1e-9) << k;
    EXPECT_LT((leg.anchor - same.anchor).norm(), 1e-9) << k;
    EXPECT_NEAR(leg.limits.upper - leg.limits.lower, 0.8, 1e-12);
  }
}

TEST(SdfReader, ReadsModelsInModels) {
  const auto mechanism = loaded_from("sdf", "two_legs.sdf", "two_legs.yaml");
  const std::vector<Leg>& legs = mechanism->manipulator()->legs();
  ASSERT_EQ(legs.size(), 2U);
  EXPECT_LT((legs[1].base_point() - Eigen::Vector3d(8.0, 0.0, 0.0)).norm(), 1e-9);
  for (const Leg& leg : legs) EXPECT_NEAR(std::get<RevoluteActuation>(leg.actuation).radius, 3.0, 1e-9);
  EXPECT_NEAR(legs[0].rod_length, std::hypot(2.0, 4.0), 1e-9);
  EXPECT_NEAR(legs[1].rod_length, 4.0, 1e-9);
  EXPECT_EQ(mechanism->joint_names(),
            (std::vector<std::string>{"elbow_joint", "right_elbow_joint", "left_motor", "right_motor"}));
  EXPECT_EQ(mechanism->joint_limits()[2].upper, 1.0);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

TEST(SdfReader, RefusalsNameTheElement) {
  EXPECT_EQ(refusal("<joint name=\"loop\" type=\"revolute\">", "<joint name=\"loop\" type=\"screw\">"),
            Problems{"five_bar.sdf gives joint 'loop' the type 'screw'; use revolute, continuous, prismatic, "
                     "universal, revolute2, ball or fixed."});
  for (const auto& [old, by, name] :
       {std::array<std::string, 3>{"<child>rod_2</child><pose>", "<child>rod_9</child><pose>", "rod_9"},
        {"relative_to=\"crank_1\"", "relative_to=\"crank_9\"", "crank_9"},
        {"attached_to=\"rod_1\"", "attached_to=\"rod_9\"", "rod_9"}}) {
    const Problems problems = refusal(old, by);
    ASSERT_FALSE(problems.empty()) << by;
    EXPECT_LE(problems.size(), 3U);
    EXPECT_EQ(problems.front().find("five_bar.sdf is refused by sdformat: "), 0U) << problems.front();
    EXPECT_NE(problems.front().find(name), std::string::npos) << problems.front();
  }
  EXPECT_NE(refusal("<child>rod_2</child><pose>", "<child>rod_1</child><pose>"), Problems());
  EXPECT_EQ(refusal("</model>", ""), Problems{"five_bar.sdf is not well-formed XML near line 5 "
                                              "(XML_ERROR_MISMATCHED_ELEMENT); correct it there."});
}

TEST(SdfReader, SaysWhereModelsAreSearchedFor) {
  EXPECT_EQ(refusal("<link name=\"base_link\"/>",
                    "<link name=\"base_link\"/><include><uri>model://arm</uri></include>"),
            Problems{"five_bar.sdf is refused by sdformat: Unable to find uri[model://arm] (line 6); put "
                     "that model beside the file, or name its folder in SDF_PATH."});
}

TEST(SdfReader, AsksForOneRobot) {
  const std::string model =
      "<model name='a'><link name='l'/><link name='m'/><joint name='j' "
      "type='ball'><parent>l</parent><child>m</child></joint></model>";
  EXPECT_EQ(test::refusal_of_file("robot.sdf", "<sdf version='1.9'><world name='w'/></sdf>"),
            Problems{"robot.sdf has no model with joints; give the SDF of a robot."});
  EXPECT_EQ(test::refusal_of_file("robot.sdf", "<sdf version='1.9'><world name='w'>" + model +
                                                   test::replaced(model, "'a'", "'b'") + "</world></sdf>"),
            Problems{"robot.sdf has several models with joints, 'a', 'b'; give a file with one of them."});
}

}  // namespace
}  // namespace parallel_aspects
