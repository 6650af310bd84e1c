// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/aspect_map.h"
#include "urdf/corrections/faulty_robots.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include "support/loops.h"
#include "support/round_trip.h"
#include "support/texts.h"
#include <algorithm>

// Platforms that hang on chains without an actuated joint, as a URDF, which is a tree, asks for.
namespace parallel_aspects {
namespace {

using test::Description;
using test::fixed_joint;
using test::moving_joint;
using test::shipped_text;

Description chain_text(const std::string& name) {
  const std::string start = "test/data/chains/" + name;
  return {test::source_file(start + ".urdf"), test::source_file(start + ".yaml")};
}

std::string slide(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& axis, const std::string& limits = "") {
  return "<link name=\"" + child + "\"/><joint name=\"" + name + "\" type=\"prismatic\"><parent link=\"" +
         parent + "\"/><child link=\"" + child + "\"/><axis xyz=\"" + axis + "\"/>" + limits + "</joint>";
}

std::string range(double lower, double upper) {
  return "<limit lower=\"" + std::to_string(lower) + "\" upper=\"" + std::to_string(upper) + "\"/>";
}

// With more links and joints, and one more closure, the first of the list.
Description extended(Description text, const std::string& links, const std::string& closure) {
  text.change_urdf("</robot>", links + "</robot>");
  text.change_config("  closures:\n", "  closures:\n    - " + closure + "\n");
  return text;
}

bool any_note(const Mechanism& mechanism, const std::string& part) {
  const auto& notes = mechanism.notes();
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

const std::string takes_nothing = "it takes nothing from what the legs leave the platform.";

// Of two robots, to the last digit.
void expect_same_legs(const Mechanism& one, const Mechanism& other, double tolerance = 0.0) {
  const auto &a = one.manipulator()->legs(), &b = other.manipulator()->legs();
  EXPECT_EQ(one.manipulator()->task_space(), other.manipulator()->task_space());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t j = 0; j < a.size(); ++j) {
    EXPECT_NEAR((a[j].anchor - b[j].anchor).norm(), 0.0, tolerance);
    EXPECT_NEAR(a[j].rod_length, b[j].rod_length, tolerance);
    for (const double q : {-0.3, 0.0, 1.2})
      EXPECT_NEAR((a[j].proximal_point(q) - b[j].proximal_point(q)).norm(), 0.0, tolerance);
  }
}

void expect_round_trips(const Mechanism& mechanism, double spread) {
  const test::RoundTrips trips =
      test::round_trips(*mechanism.manipulator(), mechanism.assembled().pose, spread, 100, 11);
  EXPECT_EQ(trips.made, 100);
  EXPECT_EQ(trips.missed, 0) << trips.first_miss;
}

// Where the map of a robot is the same as that of another, in numbers and sizes.
void expect_same_maps(const Mechanism& one, const Mechanism& other) {
  MapOptions options;
  options.resolution = one.manipulator()->size() / 100.0;
  const MapResult a = compute_aspect_map(one.manipulator(), options);
  const MapResult b = compute_aspect_map(other.manipulator(), options);
  ASSERT_TRUE(a.map && b.map);
  ASSERT_EQ(a.map->aspects().size(), b.map->aspects().size());
  for (std::size_t k = 0; k < a.map->aspects().size(); ++k)
    EXPECT_EQ(a.map->aspects()[k].measure, b.map->aspects()[k].measure);
}

// The names of joints and where they are.
double joint(const Mechanism& mechanism, const Eigen::VectorXd& positions, const std::string& name) {
  const auto& names = mechanism.joint_names();
  return positions[std::find(names.begin(), names.end(), name) - names.begin()];
}

TEST(PassiveChain, HoldsTheOrientationOfADeltaWithSingleRods) {
  const auto mechanism = test::load(chain_text("delta_on_slides"));
  EXPECT_EQ(mechanism->mobility(), 3);
  expect_same_legs(*mechanism, *test::shipped("delta"), 1e-15);
  EXPECT_EQ(test::open_loops(*mechanism, 0.1), 0);
  expect_round_trips(*mechanism, 0.2);
  EXPECT_TRUE(any_note(*mechanism,
                       "No joint is actuated in the chain of 'slide_x', 'slide_y', 'slide_z' between base "
                       "and platform; it is part of what holds the platform in T3."));
}

// Slide z hangs half a metre down and grows downwards.
TEST(PassiveChain, IsCompletedWithThePose) {
  const auto mechanism = test::load(chain_text("delta_on_slides"));
  Pose pose;
  pose.position << 0.1, -0.05, -0.8;
  const InverseSolution solution =
      inverse(*mechanism->manipulator(), pose, working_modes(*mechanism->manipulator()).front());
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism->joint_names().size()));
  ASSERT_TRUE(mechanism->complete(pose, solution.q, positions));
  EXPECT_NEAR(joint(*mechanism, positions, "slide_x"), 0.1, 1e-12);
  EXPECT_NEAR(joint(*mechanism, positions, "slide_y"), -0.05, 1e-12);
  EXPECT_NEAR(joint(*mechanism, positions, "slide_z"), 0.3, 1e-12);
}

TEST(PassiveChain, OfAPlanarPlatformTakesNothing) {
  const auto mechanism = test::load(chain_text("three_rrr_on_slides"));
  expect_same_legs(*mechanism, *test::shipped("three_rrr"));
  EXPECT_EQ(test::open_loops(*mechanism, 0.1), 0);
  EXPECT_TRUE(any_note(*mechanism, takes_nothing)) << mechanism->notes().back();
  Pose pose;
  pose.position << -5.0, -4.0, 0.0;
  pose.orientation = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ());
  const InverseSolution solution =
      inverse(*mechanism->manipulator(), pose, working_modes(*mechanism->manipulator()).front());
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism->joint_names().size()));
  ASSERT_TRUE(mechanism->complete(pose, solution.q, positions));
  EXPECT_NEAR(joint(*mechanism, positions, "world_x"), -5.0, 1e-12);
  EXPECT_NEAR(joint(*mechanism, positions, "world_yaw"), 0.3, 1e-12);
}

// Rods of 0.6 m that run 0.05 m out of their planes.
// At zero two of its struts are as short as they can be, and it can stand elsewhere.
TEST(PassiveChain, DoesNotKeepTheHomePoseOnALimit) {
  const auto robot = test::load(chain_text("hung_three_rpr"));
  const AssembledConfiguration home = robot->assembled();
  for (std::size_t k = 0; k < robot->manipulator()->leg_count(); ++k) {
    const JointLimits& limits = robot->manipulator()->leg(k).limits;
    EXPECT_GT(home.q[static_cast<Eigen::Index>(k)], limits.lower + 1e-3) << k;
    EXPECT_LT(home.q[static_cast<Eigen::Index>(k)], limits.upper - 1e-3) << k;
  }
}

TEST(PassiveChain, OfTwoSlidesMakesAPlane) {
  const auto mechanism = test::load(chain_text("y_z_slides"));
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::T2);
  for (const Leg& leg : mechanism->manipulator()->legs())
    EXPECT_NEAR(leg.rod_length, std::sqrt(0.36 - 0.0025), 1e-12);
  EXPECT_EQ(test::open_loops(*mechanism, 0.1), 0);
  expect_round_trips(*mechanism, 0.2);
}

TEST(PassiveChain, OfABallJointMakesASphericalRobot) {
  const auto mechanism = test::load(chain_text("tilting_platform"));
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::SO3);
  for (const Leg& leg : mechanism->manipulator()->legs()) {
    EXPECT_TRUE(std::holds_alternative<StrutActuation>(leg.actuation));
    EXPECT_NEAR(leg.anchor.norm(), std::hypot(0.4, 0.1), 1e-9);
  }
  EXPECT_EQ(test::open_loops(*mechanism, 0.1), 0);
  expect_round_trips(*mechanism, 1.0);
}

// The same as a closure.
TEST(PassiveChain, MayEndInAClosure) {
  Description text = chain_text("tilting_platform");
  text.change_urdf("<joint name=\"roll\"",
                   "<link name=\"hub\"/><joint name=\"hub_joint\" type=\"fixed\"><parent "
                   "link=\"base\"/><child link=\"hub\"/></joint><joint name=\"roll\"");
  text.change_urdf("<joint name=\"roll\" type=\"continuous\">\n    <parent link=\"base\"/>",
                   "<joint name=\"roll\" type=\"continuous\">\n    <parent link=\"piston_1\"/>");
  text.change_urdf("<child link=\"platform\"/>", "<child link=\"ball_3\"/>");
  text.change_urdf("</robot>",
                   "<link name=\"ball_3\"/>" +
                       fixed_joint("ball_3", "platform", "xyz=\"-0.351033024756 -0.191770215442 -0.1\"") +
                       "</robot>");
  text.change_config(
      "{frames: [{link: platform, xyz: [0.351033024756, 0.191770215442, 0.1]}, piston_1], type: point}",
      "{frames: [platform, hub], type: point}");
  const auto mechanism = test::load(text);
  expect_same_legs(*mechanism, *test::load(chain_text("tilting_platform")), 1e-9);
  EXPECT_EQ(test::open_loops(*mechanism, 0.1), 0);
}

// Six joints that let a platform go where it will, as for a floating base in a tree.
TEST(PassiveChain, OfSixJointsTakesNothingFromAHexapod) {
  const std::string base = "base_link";
  const Description text =
      extended(shipped_text("stewart"),
               slide("free_x", base, "free_1", "1 0 0") + slide("free_y", "free_1", "free_2", "0 1 0") +
                   slide("free_z", "free_2", "free_3", "0 0 1") +
                   "<link name=\"free_4\"/><link name=\"free_5\"/><link name=\"free_6\"/>" +
                   moving_joint("free_roll", "free_3", "free_4", "1 0 0") +
                   moving_joint("free_pitch", "free_4", "free_5", "0 1 0") +
                   moving_joint("free_yaw", "free_5", "free_6", "0 0 1"),
               "{frames: [platform, free_6], type: fixed}");
  const auto mechanism = test::load(text);
  expect_same_legs(*mechanism, *test::shipped("stewart"), 1e-12);
  EXPECT_TRUE(any_note(*mechanism, takes_nothing)) << mechanism->notes().back();
  EXPECT_EQ(test::open_loops(*mechanism, 0.05), 0);
}

Description five_bar_on_slides(const std::string& x_limits, const std::string& y_limits) {
  return extended(shipped_text("five_bar"),
                  slide("free_x", "base_link", "free_1", "1 0 0", x_limits) +
                      slide("free_y", "free_1", "free_2", "0 1 0", y_limits),
                  "{frames: [tool, free_2], type: point}");
}

TEST(PassiveChain, LeavesTheMapAsItIs) {
  const auto mechanism = test::load(five_bar_on_slides("", ""));
  EXPECT_TRUE(any_note(*mechanism, takes_nothing));
  EXPECT_FALSE(mechanism->manipulator()->constraints().workspace);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
  expect_same_maps(*mechanism, *test::shipped("five_bar"));
}

// Each slide's limits are two walls, which are certified as those of the YAML are.
TEST(PassiveChain, BoundsThePositionByItsLimits) {
  const auto mechanism = test::load(five_bar_on_slides(range(2.0, 7.0), range(1.0, 9.0)));
  ASSERT_TRUE(mechanism->manipulator()->constraints().workspace);
  EXPECT_TRUE(mechanism->manipulator()->constraints().missing_joints.empty());
  Description text = shipped_text("five_bar");
  text.config += "\nconstraints: {workspace: {lower: [2, 1], upper: [7, 9]}}\n";
  expect_same_maps(*mechanism, *test::load(text));
  EXPECT_TRUE(any_note(*mechanism,
                       "The limits of 'free_x', 'free_y' keep the operational point between [2, 1] and [7, "
                       "9] m of the task frame, as constraints.workspace does."));
}

// A wall that is not there is put where nothing reaches.
TEST(PassiveChain, BoundsOneDirectionAlone) {
  const auto mechanism = test::load(five_bar_on_slides("", range(1.0, 9.0)));
  const auto& workspace = mechanism->manipulator()->constraints().workspace;
  ASSERT_TRUE(workspace);
  EXPECT_EQ(workspace->lower.y(), 1.0);
  EXPECT_EQ(workspace->upper.y(), 9.0);
  for (const Leg& leg : mechanism->manipulator()->legs())
    if (&leg == &mechanism->manipulator()->legs().front()) {
      EXPECT_LT(workspace->lower.x(), leg.base_point().x() - leg.longest_reach());
      EXPECT_GT(workspace->upper.x(), leg.base_point().x() + leg.longest_reach());
    }
}

TEST(PassiveChain, BoundsBesideAWorkspaceOfTheYaml) {
  Description text = five_bar_on_slides(range(2.0, 7.0), range(1.0, 9.0));
  const std::string config = text.config;
  text.config = config + "\nconstraints: {workspace: {lower: [3, 0], upper: [20, 8]}}\n";
  const auto mechanism = test::load(text);
  EXPECT_EQ(mechanism->manipulator()->constraints().workspace->lower.head<2>(), Eigen::Vector2d(3, 1));
  EXPECT_EQ(mechanism->manipulator()->constraints().workspace->upper.head<2>(), Eigen::Vector2d(7, 8));
  text.config = config + "\nconstraints: {workspace: {lower: [8, 0], upper: [20, 8]}}\n";
  test::expect_refusal(text,
                       "robot.yaml has a constraints.workspace that the limits of the passive slides in "
                       "robot.urdf leave no room in; widen one of them.");
  text.config = config + "\nconstraints: {passive_limits: false}\n";
  EXPECT_FALSE(test::load(text)->manipulator()->constraints().workspace);
}

// Slides that are turned by 45 degrees have walls that no box has: not certified, and said so.
TEST(PassiveChain, HasLimitsThatNoBoxHas) {
  Description text = five_bar_on_slides(range(2.0, 12.0), "");
  text.change_urdf("<child link=\"free_1\"/><axis xyz=\"1 0 0\"/>",
                   "<child link=\"free_1\"/><axis xyz=\"1 1 0\"/>");
  const auto mechanism = test::load(text);
  EXPECT_FALSE(mechanism->manipulator()->constraints().workspace);
  EXPECT_EQ(mechanism->manipulator()->constraints().missing_joints, std::vector<std::string>{"free_x"});
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

// The slide that makes T1 is such a chain too.
TEST(PassiveChain, OfOneSlideBoundsALine) {
  Description text{test::source_file("test/data/prrp.urdf"), test::source_file("test/data/prrp.yaml")};
  text.change_urdf("<axis xyz=\"-1 0 0\"/>", "<axis xyz=\"-1 0 0\"/>" + range(-3.0, -1.5));
  const auto mechanism = test::load(text);
  ASSERT_TRUE(mechanism->manipulator()->constraints().workspace);
  EXPECT_EQ(mechanism->manipulator()->constraints().workspace->lower.x(), 1.5);
  EXPECT_EQ(mechanism->manipulator()->constraints().workspace->upper.x(), 3.0);
  const MapResult result = compute_aspect_map(mechanism->manipulator());
  ASSERT_TRUE(result.map);
  EXPECT_EQ(result.map->aspects().size(), 2U);
  for (const Aspect& aspect : result.map->aspects()) EXPECT_NEAR(aspect.measure, 1.5, 0.1);
}

// A turning slide has limits and directions of its own.
TEST(PassiveChain, IsRefusedWhereItCouplesCoordinates) {
  const Description polar = extended(
      shipped_text("five_bar"),
      "<link name=\"turret\"/>" + moving_joint("turn", "base_link", "turret", "0 0 1", "xyz=\"4 -3 0\"") +
          slide("reach", "turret", "hand", "0 1 0"),
      "{frames: [tool, hand], type: point}");
  test::expect_refusal(polar,
                       "robot.urdf joins the platform to the base by a chain without actuated joint, 'turn', "
                       "'reach', that has the slide 'reach' after a joint that turns it; write it as slides "
                       "along fixed directions first, then revolute joints about different axes, three of "
                       "them orthogonal one to the next, or one ball joint.");
  EXPECT_EQ(test::load(five_bar_on_slides("", ""))->mobility(), 2);
}

// By its rank, or since it is an arm; nothing is offered that would make another robot of it.
void expect_chain_is_named(const Description& robot, const std::string& fault) {
  const Problems problems = test::refusal(robot);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_TRUE(test::begins(problems.front(), "robot.urdf joins the platform to the base by "));
  EXPECT_TRUE(test::has(problems.front(), "'p1'"));
  EXPECT_TRUE(test::has(problems.front(), fault));
  EXPECT_TRUE(test::followed(robot, problems.front()).empty()) << problems.front();
}

constexpr const char* arm = "that turns about the same direction twice";

std::string ways(int chain, int joints) {
  return "which lets it move in " + std::to_string(chain) + (chain == 1 ? " way" : " ways") +
         " only, while " + std::to_string(joints) + " joints are actuated";
}

std::string turning(const std::string& name, const std::string& parent, const std::string& child,
                    const std::string& origin) {
  return "<link name=\"" + child + "\"/>" + moving_joint(name, parent, child, "0 0 1", origin);
}

TEST(PassiveChain, IsAnArmThatTheToolOfAFiveBarHangsOn) {
  Description robot = chain_text("five_bar_on_an_arm");
  for (const char* wrist : {"fixed", "continuous"}) {
    robot.change_urdf("name=\"tool_joint\" type=\"fixed\"",
                      "name=\"tool_joint\" type=\"" + std::string(wrist) + "\"");
    expect_chain_is_named(robot, arm);
  }
}

// The platform of a 3-RRR, whose chain of two slides and a yaw is made another.
Description hung_on(const std::string& joints) {
  Description robot = chain_text("three_rrr_on_slides");
  const std::size_t start = robot.urdf.find("<link name=\"carriage_x\"/>");
  const std::size_t end = robot.urdf.find("</joint>", robot.urdf.find("name=\"world_yaw\"")) + 8;
  EXPECT_LT(start, end);
  EXPECT_LT(end, robot.urdf.size());
  robot.urdf.replace(start, end - start, joints);
  return robot;
}

TEST(PassiveChain, IsAnArmThatAPlatformHangsOn) {
  const std::string first = turning("p1", "base_link", "upper", "");
  expect_chain_is_named(hung_on(first + turning("p2", "upper", "platform", "xyz=\"4 0 0\"")), ways(2, 3));
  expect_chain_is_named(hung_on(first + turning("p2", "upper", "lower", "xyz=\"4 0 0\"") +
                                turning("p3", "lower", "platform", "xyz=\"4 0 0\"")),
                        arm);
  const std::string along = slide("p1", "base_link", "upper", "1 0 0");
  expect_chain_is_named(hung_on(along + slide("p2", "upper", "platform", "0 1 0")), ways(2, 3));
  expect_chain_is_named(hung_on(along + turning("p2", "upper", "platform", "")), ways(2, 3));
  expect_chain_is_named(hung_on(slide("p1", "base_link", "platform", "0 1 0")), ways(1, 3));
  expect_chain_is_named(hung_on(turning("p1", "base_link", "platform", "")), ways(1, 3));
}

// Without its slide along x.
TEST(PassiveChain, IsOfTooFewSlidesForADelta) {
  Description robot = chain_text("delta_on_slides");
  const std::size_t start = robot.urdf.find("<link name=\"carriage_x\"/>");
  const std::size_t end = robot.urdf.find("<link name=\"carriage_y\"/>");
  robot.urdf.erase(start, end - start);
  robot.change_urdf("<parent link=\"carriage_x\"/>", "<parent link=\"base_link\"/>");
  robot.change_urdf("\"slide_y\"", "\"p1\"");
  expect_chain_is_named(robot, ways(2, 3));
}

// A closure that ends on the chain, and not on the platform that the chain carries.
TEST(PassiveChain, IsNotWhereALegEnds) {
  Description robot = chain_text("three_rrr_on_slides");
  const std::string meant = "[{link: platform, xyz: [10, 0, 0]}";
  robot.change_config(meant, "[{link: carriage_y, xyz: [10, 0, 0]}");
  test::expect_refusal(robot,
                       "robot.yaml closes 'carriage_y - rod_2' at link 'carriage_y', which is not on the "
                       "body of operational_point 'platform'; write link 'platform' in the place of "
                       "'carriage_y' in closure 'carriage_y - rod_2', which makes it a robot in SE2.");
}

// Walls where the operational point is on the axis of the yaw, and else said to be none.
TEST(PassiveChain, SaysWhichLimitsOfItsSlidesBoundNothing) {
  const auto notes = [](const std::string& point) {
    Description robot = chain_text("three_rrr_on_slides");
    for (const std::string axis : {"1 0 0", "0 1 0"})
      if (const std::string text = "<axis xyz=\"" + axis + "\"/>"; robot.urdf.find(text) != std::string::npos)
        robot.change_urdf(text, text + range(-5.0, 5.0));
    robot.change_config("operational_point: platform", "operational_point: " + point);
    return test::load(robot)->notes();
  };
  const auto says = [](const std::vector<std::string>& found, const std::string& text) {
    return std::count_if(found.begin(), found.end(),
                         [&](const std::string& note) { return note.find(text) != std::string::npos; });
  };
  const std::string unused = "The limits of 'world_x', 'world_y' bound no aspect";
  EXPECT_EQ(says(notes("platform"), unused), 0);
  EXPECT_EQ(says(notes("{link: platform, xyz: [1, 0, 0]}"), unused), 1);
}

// A telescopic shaft to a tool that a fourth motor turns on the platform of a Delta: a passive chain, which
// follows the platform.
TEST(IdleChain, IsLeftOutWhateverItDrives) {
  const std::string urdf = test::source_file("test/data/chains/delta_with_shaft.urdf");
  const std::string note =
      "robot.urdf has joints that move nothing of the platform, so that they are not taken as actuated: "
      "'motor_4'.";
  const std::string stated = "mechanism:\n  operational_point: platform\n",
                    listed = stated + "  actuated_joints: [motor_1, motor_2, motor_3]\n";
  const std::string without = listed +
                              "  closures: [{frames: [rod_end_1, socket_1]}, {frames: [rod_end_2, "
                              "socket_2]}, {frames: [rod_end_3, socket_3]}]\n";
  const auto right = test::load({urdf, without});
  ASSERT_EQ(right->manipulator()->task_space(), TaskSpace::T3);
  EXPECT_FALSE(any_note(*right, "takes nothing"));
  const std::string follows =
      "No joint is actuated in the chain of 'shaft_top_r_joint', 'shaft_top_p_joint',";
  for (const auto& [config, said] : {std::pair{stated, note}, std::pair{listed, follows}}) {
    const auto found = test::load({urdf, config});
    expect_same_legs(*found, *right, 1e-9);
    EXPECT_TRUE(any_note(*found, said)) << config;
    EXPECT_EQ(test::open_loops(*found, 0.05), 0) << config;
  }
}

}  // namespace
}  // namespace parallel_aspects
