// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/descriptions.h"
#include "support/texts.h"

// Frames that are given by a place in a link, so that nobody edits a URDF of others.
namespace parallel_aspects {
namespace {

using test::Description;
using test::shipped_text;

// The shipped five-bar without the links at the ends of its rods.
Description five_bar_without_tips() {
  Description five_bar = shipped_text("five_bar");
  five_bar.change_config("operational_point: tool",
                         "operational_point: {link: rod_1, xyz: [5, 0, 0], rpy: [0, 0, 0], name: tip}");
  five_bar.change_config("[tool, closing_2]",
                         "[{link: rod_1, xyz: [5, 0, 0]}, {link: rod_2, xyz: [8, 0, 0], name: end_2}]");
  return five_bar;
}

TEST(FrameWithOffset, DoesWhatALinkDoes) {
  const auto given = test::load(five_bar_without_tips()), links = test::load(shipped_text("five_bar"));
  EXPECT_EQ(given->manipulator()->task_space(), TaskSpace::T2);
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_EQ(given->manipulator()->leg(j).rod_length, links->manipulator()->leg(j).rod_length);
    EXPECT_EQ(given->manipulator()->leg(j).anchor, links->manipulator()->leg(j).anchor);
  }
  EXPECT_EQ(given->assembled().pose.position, links->assembled().pose.position);
  EXPECT_EQ(test::open_loops(*given), 0);
}

TEST(FrameWithOffset, HasItsNameInTfAndMessages) {
  const auto given = test::load(five_bar_without_tips());
  EXPECT_EQ(given->platform_link(), "tip");
  EXPECT_EQ(given->platform_frame(), "tip");
  EXPECT_EQ(given->link_names().back(), "tip");
  Description apart = five_bar_without_tips();
  apart.change_config("xyz: [8, 0, 0]", "xyz: [800, 0, 0]");
  const Problems problems = test::refusal(apart);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_TRUE(test::has(problems.front(), "the end of closure 'rod_1 - end_2' in link 'rod_2'"));
}

TEST(FrameWithOffset, NeedsNoName) {
  Description five_bar = five_bar_without_tips();
  five_bar.change_config(", name: tip", "");
  const auto given = test::load(five_bar);
  EXPECT_EQ(given->platform_link(), "operational_point");
  EXPECT_EQ(given->platform_frame(), "platform");
}

// The tilt of the frame is that of the platform.
TEST(FrameWithOffset, MayBeTurned) {
  Description stewart = shipped_text("stewart");
  stewart.change_config(
      "operational_point: platform",
      "operational_point: {link: platform, xyz: [0, 0, 0.1], rpy: [0, 0, 1.5707963267948966]}");
  const auto given = test::load(stewart), plain = test::load(shipped_text("stewart"));
  for (std::size_t j = 0; j < 6; ++j) {
    const Eigen::Vector3d before = plain->manipulator()->leg(j).anchor;
    const Eigen::Vector3d expected(before.y(), -before.x(), before.z() - 0.1);
    EXPECT_NEAR((given->manipulator()->leg(j).anchor - expected).norm(), 0.0, 1e-12);
  }
  EXPECT_EQ(test::open_loops(*given, 0.05), 0);
}

TEST(FrameWithOffset, IsRefusedWithEachProblem) {
  const auto refusal = [](const std::string& frame) {
    Description five_bar = five_bar_without_tips();
    five_bar.change_config("{link: rod_1, xyz: [5, 0, 0], rpy: [0, 0, 0], name: tip}", frame);
    return test::refusal(five_bar);
  };
  const std::string key = "robot.yaml has ";
  EXPECT_EQ(refusal("{link: rod_1, xyz: [5, 0]}"),
            Problems{key + "2 numbers in mechanism.operational_point.xyz; give three."});
  EXPECT_EQ(refusal("{link: rod_1, rpy: [5, 0, .nan]}"),
            Problems{key + "a mechanism.operational_point.rpy[2] that is not a finite number; give one."});
  EXPECT_EQ(refusal("{xyz: [5, 0, 0]}"), Problems{"robot.yaml does not say mechanism.operational_point.link; "
                                                  "name the link that the frame is fixed to."});
  EXPECT_EQ(refusal("{link: rod_1, xyz: [5, 0, 0], name: tool}"),
            Problems{"robot.yaml calls the frame of mechanism.operational_point 'tool', but robot.urdf has a "
                     "link of that name; give the frame another name under its key 'name'."});
  EXPECT_EQ(refusal("{link: rod_9, xyz: [5, 0, 0]}"),
            Problems{"robot.yaml names link 'rod_9' in mechanism.operational_point, but robot.urdf has no "
                     "such link; did you mean 'rod_1'?"});
}

// Tolerances are shares of the robot, wherever the frame of its base is.
TEST(BaseFrame, MayBeFarFromTheRobot) {
  for (const char* name : {"five_bar", "three_rpr", "delta", "agile_eye"}) {
    SCOPED_TRACE(name);
    const auto plain = test::load(shipped_text(name));
    const double size = plain->manipulator()->size();
    Description far = shipped_text(name);
    far.change_urdf("</robot>", "<link name=\"far\"/>" +
                                    test::fixed_joint("far", "base_link",
                                                      "xyz=\"" + std::to_string(1000.0 * size) + " " +
                                                          std::to_string(-700.0 * size) + " 0\"") +
                                    "</robot>");
    far.change_config("base_link: base_link", "base_link: far");
    const auto given = test::load(far);
    ASSERT_EQ(given->manipulator()->task_space(), plain->manipulator()->task_space());
    EXPECT_NEAR(given->manipulator()->size(), size, 1e-9 * size);
    for (std::size_t j = 0; j < plain->manipulator()->leg_count(); ++j) {
      const Leg &leg = given->manipulator()->leg(j), &as_drawn = plain->manipulator()->leg(j);
      EXPECT_NEAR(leg.rod_length, as_drawn.rod_length, 1e-9 * size);
      EXPECT_NEAR((leg.anchor - as_drawn.anchor).norm(), 0.0, 1e-9 * size);
    }
    EXPECT_EQ(test::open_loops(*given, 0.05), 0);
  }
}

}  // namespace
}  // namespace parallel_aspects
