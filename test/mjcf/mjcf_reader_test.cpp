// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/aspect_map.h"

#include <gtest/gtest.h>

#include "support/same_legs.h"

namespace parallel_aspects {
namespace {

using test::loaded_from;

const std::string five_bar_text = test::source_file("test/data/mjcf/five_bar.xml");

Problems refusal(const std::string& old, const std::string& by) {
  return test::refusal_of_file("five_bar.xml", test::replaced(five_bar_text, old, by));
}

TEST(MjcfReader, ReadsTheFiveBarClosedBySites) {
  const auto mechanism = loaded_from("mjcf", "five_bar.xml", "five_bar.yaml");
  test::expect_same_legs(*mechanism, *models::five_bar());
  EXPECT_EQ(mechanism->joint_names(),
            (std::vector<std::string>{"crank_1_joint", "elbow_1_joint", "crank_2_joint", "elbow_2_joint"}));
  ASSERT_EQ(mechanism->notes().size(), 2U);
  EXPECT_EQ(mechanism->notes()[0], "The closures are those that <equality> describes, 1 in all.");
}

TEST(MjcfReader, ReadsTheFiveBarClosedByAnAnchor) {
  const auto mechanism = loaded_from("mjcf", "closed_five_bar.xml", "five_bar.yaml");
  test::expect_same_legs(*mechanism, *models::five_bar());
  EXPECT_LT(mechanism->home().q.norm(), 1e-9) << "joints are zero where the robot is drawn";
}

TEST(MjcfReader, FiveBarsHaveTheTenAspectsOfThePaper) {
  const auto expected = compute_aspect_map(models::five_bar()->manipulator()).map;
  for (const char* file : {"five_bar.xml", "closed_five_bar.xml"}) {
    const auto map = compute_aspect_map(loaded_from("mjcf", file, "five_bar.yaml")->manipulator()).map;
    EXPECT_EQ(map->aspects().size(), expected->aspects().size()) << file;
    EXPECT_EQ(map->proved_count(), expected->proved_count()) << file;
    EXPECT_EQ(map->count_at_most(), expected->count_at_most()) << file;
  }
}

TEST(MjcfReader, ReadsA3RRRWhosePlatformIsAFreeBody) {
  test::expect_same_legs(*loaded_from("mjcf", "three_rrr.xml", "three_rrr.yaml"), *models::three_rrr());
}

TEST(MjcfReader, ReadsADeltaWithConnectsAtTheEndsOfItsRods) {
  const auto mechanism = loaded_from("mjcf", "delta.xml", "delta.yaml");
  test::expect_same_legs(*mechanism, *models::delta());
  EXPECT_EQ(mechanism->idle_degrees_of_freedom(), 6) << "all rods spin";
}

// Joint values are those of MuJoCo, which are `ref` where the robot is drawn.
TEST(MjcfReader, KeepsTheZeroOfJoints) {
  const auto mechanism = loaded_from("mjcf", "delta.xml", "delta.yaml");
  const auto solutions = inverse_in_all_modes(*mechanism->manipulator(), models::delta()->home().pose);
  int found = 0;
  for (const InverseSolution& solution : solutions)
    if (solution.status == InverseStatus::solved &&
        (solution.q - JointVector::Constant(3, 0.39980783526751285)).norm() < 1e-9)
      ++found;
  EXPECT_EQ(found, 1);
}

// The manual of MuJoCo calls two anchors of the same bodies a hinge.
TEST(MjcfReader, TakesTwoConnectsOfTwoBodiesAsAHinge) {
  const std::string hinge =
      "<connect body1=\"rod_1\" body2=\"rod_2\" anchor=\"5 0 0\"/><connect body1=\"rod_1\" body2=\"rod_2\" "
      "anchor=\"5 0 0.1\"/>";
  std::string text = test::source_file("test/data/mjcf/closed_five_bar.xml");
  text = test::replaced(text, "<connect name=\"loop\" body1=\"rod_1\" body2=\"rod_2\" anchor=\"5 0 0\"/>",
                        hinge);
  text = test::replaced(text, "<include file=\"five_bar_defaults.xml\"/>",
                        "<compiler angle=\"degree\"/><default><default class=\"planar\"><joint axis=\"0 0 "
                        "1\"/></default></default>");
  EXPECT_EQ(test::refusal_of_file("robot.xml", text), Problems());
  const std::string across = test::replaced(text, "anchor=\"5 0 0.1\"", "anchor=\"5.1 0 0\"");
  EXPECT_NE(test::refusal_of_file("robot.xml", across), Problems()) << "no hinge about z";
}

TEST(MjcfReader, RefusalsNameElementAndLine) {
  EXPECT_EQ(refusal("joint=\"crank_1_joint\"/>\n    <position", "joint=\"crank_9_joint\"/>\n    <position"),
            Problems{"five_bar.xml has no joint 'crank_9_joint', which <motor> 'motor_1' drives; correct its "
                     "name, or add it."});
  EXPECT_EQ(refusal("site2=\"closing\"", "site2=\"closed\""),
            Problems{"five_bar.xml has <connect> 'loop' with the site 'closed', which does not exist; "
                     "correct its name, or add it."});
  EXPECT_EQ(refusal("site1=\"tool\" site2=\"closing\"", "body1=\"rod_1\" body2=\"rod_9\" anchor=\"5 0 0\""),
            Problems{"five_bar.xml is refused by MuJoCo: unknown element 'rod_9' in equality constraint 0, "
                     "named 'loop', line 32 of five_bar.xml; correct it there."});
  EXPECT_EQ(refusal("childclass=\"rod\">\n        <joint name=\"elbow_1_joint\"",
                    "childclass=\"arm\">\n        <joint name=\"elbow_1_joint\""),
            Problems{"five_bar.xml is refused by MuJoCo: unknown default childclass, Element 'body', line 18 "
                     "of five_bar.xml; correct it there."});
  EXPECT_EQ(refusal("<connect name=\"loop\" site1=\"tool\" site2=\"closing\"/>", "<tendon tendon1=\"t\"/>"),
            Problems{"five_bar.xml has <tendon> in line 32, which is no <connect>, <weld> or <joint>; leave "
                     "it out, or set active=\"false\"."});
  EXPECT_EQ(refusal("<light pos=\"0 0 20\"/>", "<replicate count=\"2\"><body/></replicate>"),
            Problems{"five_bar.xml has <replicate> in line 13, which is not read; let MuJoCo write the file "
                     "anew with what that stands for (mj_saveLastXML), and give that."});
  EXPECT_EQ(refusal("<light pos=\"0 0 20\"/>", "<include file=\"legs.xml\"/>"),
            Problems{"five_bar.xml includes 'legs.xml', which cannot be read; put that file there."});
  EXPECT_EQ(refusal("</worldbody>", ""), Problems{"five_bar.xml is not well-formed XML near line 12 "
                                                  "(XML_ERROR_MISMATCHED_ELEMENT); correct it there."});
  const Problems circle =
      refusal("<option><flag contact=\"disable\"/></option>", "<include file=\"five_bar.xml\"/>");
  ASSERT_EQ(circle.size(), 1U);
  EXPECT_NE(circle.front().find("leave out files that include themselves"), std::string::npos)
      << circle.front();
}

// What no tree can say is refused, never left out in silence.
TEST(MjcfReader, RefusesWhatItCannotHold) {
  const std::string loop = "<connect name=\"loop\" site1=\"tool\" site2=\"closing\"/>";
  EXPECT_EQ(
      refusal(loop, loop + "<joint joint1=\"elbow_1_joint\"/>"),
      Problems{
          "five_bar.xml has <joint> in line 32, which holds a joint where it is; leave out that joint."});
  EXPECT_EQ(refusal(loop, "<connect body1=\"rod_1\" body2=\"rod_1\" anchor=\"0 0 0\"/>").size(), 1U);
}

}  // namespace
}  // namespace parallel_aspects
