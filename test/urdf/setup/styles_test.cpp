// SPDX-License-Identifier: BSD-3-Clause
// Robots written anew in the styles of those that people publish, as Deltas with a fourth axis, hexapods of
// servos and exports with six digits.
#include "support/styles.h"

#include "support/loops.h"
#include "support/robots/shipped.h"
#include "support/texts.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace parallel_aspects {
namespace {

using test::FoundStyle;
using test::set_up_style;
using test::text_of;
using Strings = std::vector<std::string>;

class FoundInStyle : public ::testing::TestWithParam<FoundStyle> {};

TEST_P(FoundInStyle, IsTheRobotThatWasWritten) { test::expect_found(GetParam()); }

const double servo_rod = 0.1476272;  // from the horn to the platform, as the file has it

INSTANTIATE_TEST_SUITE_P(
    All, FoundInStyle,
    ::testing::Values(
        FoundStyle{
            "all_in_mm.urdf", TaskSpace::T2, "base_link", "link_13", {"joint_11", "joint_21"}, {200.0}},
        FoundStyle{"biglide.urdf", TaskSpace::T2, "base", "strut_L_end", {"axis_L", "axis_R"}, {0.4}},
        FoundStyle{"closed_loop_names.urdf",
                   TaskSpace::SE2,
                   "base_link",
                   "effector",
                   {"mot1", "mot2", "mot3"},
                   {0.24}},
        FoundStyle{"closing_frames_leg.urdf",
                   TaskSpace::T2,
                   "frame_part",
                   "closing_foot_1",
                   {"hip_a", "hip_b"},
                   {0.17}},
        FoundStyle{"exploded_delta.urdf",
                   TaskSpace::T3,
                   "base_link",
                   "effector",
                   {"motor_A", "motor_B", "motor_C"},
                   {0.42}},
        FoundStyle{"fourth_axis_delta.urdf",
                   TaskSpace::T3,
                   "base_link",
                   "tcp",
                   {"motor1_joint", "motor2_joint", "motor3_joint"},
                   {0.6}},
        FoundStyle{
            "kossel.urdf", TaskSpace::T3, "frame", "effector", {"tower_X", "tower_Y", "tower_Z"}, {0.25}},
        FoundStyle{"left_right_five_bar.urdf",
                   TaskSpace::T2,
                   "base_link",
                   "left_forearm_tip",
                   {"left_shoulder", "right_shoulder"},
                   {0.2}},
        FoundStyle{"mimic_delta.urdf",
                   TaskSpace::T3,
                   "base_link",
                   "end_effector",
                   {"active_1", "active_2", "active_3"},
                   {0.5}},
        FoundStyle{"palletizer.urdf",
                   TaskSpace::T2,
                   "turret",
                   "coupler@0.05:0:0.2",
                   {"shoulder", "elbow_drive"},
                   {0.06, std::hypot(0.05, 0.2)}},
        FoundStyle{
            "rails_3prr.urdf", TaskSpace::SE2, "table", "stage", {"slide_1", "slide_2", "slide_3"}, {0.3}},
        FoundStyle{"servo_hexapod.urdf",
                   TaskSpace::SE3,
                   "base_link",
                   "platform",
                   {"servo1", "servo2", "servo3", "servo4", "servo5", "servo6"},
                   {servo_rod}},
        FoundStyle{"wrist_six_digits.urdf",
                   TaskSpace::SO3,
                   "base",
                   "camera_mount",
                   {"drive_1", "drive_2", "drive_3"},
                   {0.5 * EIGEN_PI}}));

// The lengths of links that meshes alone have are asked, at both ends, and with the answer the robot is
// found.
TEST(Styles, AsksForBothEndsOfStruts) {
  const SetupResult asked = set_up_style("hexapod_without_ends.urdf");
  ASSERT_TRUE(asked.question) << text_of(asked);
  EXPECT_TRUE(test::has(asked.question->text, "their rods have none at the far end"));
  const std::array<std::array<double, 2>, 5> corners{{{0.132417, 0.149886},
                                                      {0.0635961, 0.189619},
                                                      {-0.196013, 0.0397339},
                                                      {-0.196013, -0.0397339},
                                                      {0.0635961, -0.189619}}};
  SetupAnswers answers;
  for (std::size_t k = 0; k < 5; ++k) {
    const std::string leg = std::to_string(k + 2);
    EXPECT_EQ(asked.question->example.at(k), "top_plate@X:Y:Z=piston_" + leg + "@X:Y:Z");
    answers.closures.push_back(
        {"top_plate@" + std::to_string(corners[k][0]) + ":" + std::to_string(corners[k][1]) + ":0",
         "piston_" + leg + "@0:0:0.294731"});
  }
  const SetupResult found = set_up_style("hexapod_without_ends.urdf", answers);
  ASSERT_TRUE(found.mechanism) << text_of(found);
  for (const Leg& leg : found.mechanism->manipulator()->legs())
    EXPECT_NEAR(std::sqrt(leg.squared_distance(0.0)), 0.544731, 1e-5) << leg.name;
}

TEST(Styles, AsksWhichOfFourLegsIsMeant) {
  const SetupResult asked = set_up_style("quadruped.urdf");
  ASSERT_TRUE(asked.question) << text_of(asked);
  EXPECT_EQ(asked.question->key, "operational_point");
  Strings feet;
  for (const SetupCandidate& candidate : asked.question->candidates) feet.push_back(candidate.values.front());
  EXPECT_EQ(feet, (Strings{"FL_foot", "FR_foot", "RL_foot", "RR_foot"}));
  for (const std::string& foot : feet) {
    SetupAnswers answers;
    answers.operational_point = foot;
    const SetupResult found = set_up_style("quadruped.urdf", answers);
    ASSERT_TRUE(found.mechanism) << text_of(found);
    EXPECT_EQ(found.mechanism->manipulator()->leg(0).actuated_joint, foot.substr(0, 2) + "_front_hip_joint");
  }
}

// The platform hangs on the shaft of a fourth motor, which follows wherever the platform goes.
TEST(Styles, FollowsThePlatformWithAShaftThatTakesNothing) {
  const SetupResult found = set_up_style("fourth_axis_delta.urdf");
  ASSERT_TRUE(found.mechanism) << text_of(found);
  EXPECT_EQ(test::open_loops(*found.mechanism, 0.1), 0);
  std::string four = found.config;
  four.replace(four.find("motor3_joint]"), 13, "motor3_joint, motor4_joint]");
  const std::string urdf = test::source_file("test/data/styles/fourth_axis_delta.urdf");
  const auto mechanism = load_mechanism(urdf, "robot.urdf", four, "robot.yaml");
  EXPECT_EQ(mechanism->manipulator()->leg_count(), 3U);
  const Strings notes = mechanism->notes();
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.find(
               "move nothing of the platform, so that they are not taken as actuated: 'motor4_joint'.") !=
           std::string::npos;
  })) << four;
}

struct RefusedStyle {
  std::string file, reason;  // of the first line
};

void PrintTo(const RefusedStyle& style, std::ostream* stream) { *stream << style.file; }

class RefusedInStyle : public ::testing::TestWithParam<RefusedStyle> {};

TEST_P(RefusedInStyle, SaysWhyAtOnce) {
  const SetupResult result = set_up_style(GetParam().file);
  EXPECT_FALSE(result.mechanism);
  EXPECT_FALSE(result.question) << result.question->text;
  ASSERT_FALSE(result.problems.empty());
  EXPECT_TRUE(test::has(result.problems.front(), GetParam().reason)) << text_of(result);
  EXPECT_LE(result.problems.size(), 5U);
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedInStyle,
    ::testing::Values(
        RefusedStyle{"arm_with_gripper.urdf",
                     "is a serial arm of 6 joints from link 'base_link' to link 'wrist_3_link'"},
        RefusedStyle{"delta_leg_in_mm.urdf",
                     "write xyz=\"0.22 0 0\" in the origin of joint 'phi_2' and write xyz=\"0 0 -0.5\" in "
                     "the origin of joint 'chi_2', which makes it a robot in T3"},
        RefusedStyle{"one_rod_in_mm.urdf",
                     "write xyz=\"0.2 0 0\" in the origin of joint 'joint_23', which makes it a robot in T2"},
        RefusedStyle{
            "tripod_3rps.urdf",
            "has 3 legs, as that through 'pivot_1', 'ram_joint_1', 'ball_x', 'ball_y', 'ball_z', each of "
            "which has passive joints on one side of its actuated joint whose axes do not meet in a point"},
        RefusedStyle{"tripteron.urdf",
                     "keeps no point of the platform at a fixed distance from a point of its actuated link"},
        RefusedStyle{
            "upright_with_z_axes.urdf",
            "write <axis><xyz expressed_in=\"rod2\">0 1 0</xyz></axis> for 'wrist2', <axis><xyz "
            "expressed_in=\"rod3\">0 1 0</xyz></axis> for 'wrist3', which makes it a robot in SE2"}));

}  // namespace
}  // namespace parallel_aspects
