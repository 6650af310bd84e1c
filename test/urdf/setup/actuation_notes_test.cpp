// SPDX-License-Identifier: BSD-3-Clause
// What a URDF says of actuated joints and setup does not follow is said, with the reason.
#include "urdf/setup/setup_texts.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include "support/robots/shipped.h"
#include "support/texts.h"
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::actuated_joints;
using test::listed;
using test::set_up_text;
using test::Strings;

std::string five_bar_with(const std::string& elements) {
  return test::replaced(test::source_file("urdf/five_bar.urdf"), "</robot>", elements + "</robot>");
}

std::string transmissions(const Strings& joints) {
  std::string text;
  for (const std::string& joint : joints)
    text += "<transmission name=\"of_" + joint + "\"><joint name=\"" + joint + "\"/></transmission>";
  return text;
}

std::string commands(const Strings& joints) {
  std::string text = "<ros2_control name=\"drives\" type=\"system\">";
  for (const std::string& joint : joints)
    text += "<joint name=\"" + joint + "\"><command_interface name=\"position\"/></joint>";
  return text + "</ros2_control>";
}

const Strings cranks{"crank_1_joint", "crank_2_joint"};

TEST(StatedDrives, AreSaidWhereOthersAreTaken) {
  const Strings stated{"crank_1_joint", "elbow_1_joint"};
  for (const auto& [elements, kind] : {std::pair{transmissions(stated), "<transmission>"},
                                       {commands(stated), "command interface of <ros2_control>"}}) {
    const SetupResult result = set_up_text(five_bar_with(elements));
    ASSERT_TRUE(result.mechanism) << listed(result.problems);
    EXPECT_EQ(actuated_joints(*result.mechanism), cranks);
    const std::string note =
        "robot.urdf has a " + std::string(kind) +
        " of joints that are not taken as actuated: of 'elbow_1_joint', whose leg has one actuated joint and "
        "'crank_1_joint' is taken; taken without one: 'crank_2_joint'.";
    EXPECT_EQ(result.notes, Strings{note});
    EXPECT_TRUE(test::has(result.config, "of joints that are not taken as actuated"));
  }
}

TEST(StatedDrives, AreNotSaidWhereTheyAreTaken) {
  for (const std::string& elements : {transmissions(cranks), commands(cranks)})
    EXPECT_EQ(set_up_text(five_bar_with(elements)).notes, Strings{});
}

TEST(StatedDrives, AreSaidWhereOthersAreAskedFor) {
  SetupAnswers answers;
  answers.actuated_joints = {"crank_1_joint", "elbow_2_joint"};
  const SetupResult result = set_up_text(five_bar_with(transmissions(cranks)), answers);
  ASSERT_TRUE(result.mechanism) << listed(result.problems);
  ASSERT_EQ(result.notes.size(), 1U) << testing::PrintToString(result.notes);
  EXPECT_TRUE(test::has(result.notes.front(),
                        "of 'crank_2_joint', whose leg has one actuated joint and 'elbow_2_joint' is taken"))
      << testing::PrintToString(result.notes);
}

// The remedy followed to the letter: the joints that are meant, without a word.
TEST(Mimic, IsSaidToDecideWhichJointsAreActuated) {
  const std::string mimic = "<mimic joint=\"crank_1_joint\"/>";
  const std::string joint = "<joint name=\"crank_2_joint\" type=\"continuous\">";
  for (const bool is_stated : {false, true}) {
    const std::string five_bar = five_bar_with(is_stated ? transmissions(cranks) : "");
    const SetupResult result = set_up_text(test::replaced(five_bar, joint, joint + mimic));
    ASSERT_TRUE(result.mechanism || result.question) << listed(result.problems);
    std::string said;
    for (const std::string& note : result.notes) said += note + '\n';
    EXPECT_TRUE(test::has(said,
                          "robot.urdf lets joints mimic others, 'crank_2_joint', which are not taken as "
                          "actuated for that alone; if 'crank_1_joint', 'crank_2_joint' are the actuated "
                          "joints, take out the <mimic> of these."));
    EXPECT_FALSE(test::has(said, "where it is a wrist"));
    EXPECT_EQ(is_stated, said.find("of 'crank_2_joint', which mimics another joint") != std::string::npos)
        << said;
    const SetupResult without = set_up_text(five_bar);
    ASSERT_TRUE(without.mechanism);
    EXPECT_EQ(actuated_joints(*without.mechanism), cranks);
    EXPECT_EQ(without.notes, Strings{});
  }
}

}  // namespace
}  // namespace parallel_aspects
