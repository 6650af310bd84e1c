// SPDX-License-Identifier: BSD-3-Clause
// Robots that CAD has rounded: nearly symmetric, and made so.
#include "aspects/map/map_plan.h"
#include "aspects/symmetry/robot_symmetry.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include "support/texts.h"
#include <algorithm>
#include <iomanip>
#include <random>
#include <regex>
#include <set>
#include <sstream>

namespace parallel_aspects {
namespace {

using test::Description;
using test::replaced;
using test::shipped_text;

// Every number of an origin moved by up to so much.
std::string perturbed(const std::string& urdf, double most, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> error(-most, most);
  std::string result;
  std::size_t from = 0;
  for (std::size_t joint = urdf.find("<joint"); joint != std::string::npos;
       joint = urdf.find("<joint", from)) {
    const std::size_t end = urdf.find("</joint>", joint);
    const std::size_t origin = urdf.find("xyz=\"", urdf.find("<origin", joint));
    result += urdf.substr(from, (origin < end ? origin + 5 : end) - from);
    from = origin < end ? origin + 5 : end;
    if (origin > end) continue;
    std::istringstream numbers(urdf.substr(from, urdf.find('"', from) - from));
    std::ostringstream text;
    text << std::setprecision(17);
    for (double number = 0.0; numbers >> number;) text << number + error(random) << " ";
    result += text.str();
    from = urdf.find('"', from);
  }
  return result + urdf.substr(from);
}

Description with_tolerance(Description robot, const std::string& tolerance) {
  robot.change_config("mechanism:\n", "mechanism:\n  symmetrize: " + tolerance + "\n");
  return robot;
}

std::shared_ptr<const AspectMap> map_of(const Mechanism& mechanism, double resolution) {
  MapOptions options;
  options.resolution = resolution;
  options.extra_levels = 2;
  const MapResult result = compute_aspect_map(mechanism.mapped_manipulator(), options);
  EXPECT_EQ(result.status, MapStatus::complete) << result.message;
  return result.map;
}

bool any_note(const Mechanism& mechanism, const std::string& text) {
  return std::any_of(mechanism.notes().begin(), mechanism.notes().end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

std::size_t motions_of(const AspectMap& map) {
  return map.symmetry_use() ? map.symmetry_use()->motions.size() : 0;
}

struct Case {
  const char* robot;
  double resolution;
};

class Symmetrized : public ::testing::TestWithParam<Case> {};

TEST_P(Symmetrized, HasTheSymmetriesAndCountsOfTheIdealRobot) {
  const auto ideal = map_of(*test::load(shipped_text(GetParam().robot)), GetParam().resolution);
  ASSERT_GT(motions_of(*ideal), 0U);
  for (const unsigned seed : {1U, 2U, 3U}) {
    Description robot = shipped_text(GetParam().robot);
    robot.urdf = perturbed(robot.urdf, 1e-5, seed);
    const auto raw = test::load(robot);
    const auto symmetric = test::load(with_tolerance(robot, "1.0e-4"));
    EXPECT_EQ(motions_of(*map_of(*raw, GetParam().resolution)), 0U);
    const auto map = map_of(*symmetric, GetParam().resolution);
    EXPECT_EQ(motions_of(*map), motions_of(*ideal)) << "seed " << seed;
    EXPECT_EQ(map->aspects().size(), ideal->aspects().size()) << "seed " << seed;
    ASSERT_FALSE(symmetric->notes().empty());
    EXPECT_TRUE(test::has(symmetric->notes().front(), "is made symmetric under"));
    for (std::size_t j = 0; j < raw->manipulator()->leg_count(); ++j)
      EXPECT_LT((raw->manipulator()->leg(j).anchor - symmetric->manipulator()->leg(j).anchor).norm(), 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Symmetrized,
                         ::testing::Values(Case{"five_bar", 0.5}, Case{"bipod", 0.5}, Case{"delta", 0.2}),
                         [](const auto& given) { return given.param.robot; });

TEST(Symmetrize, IsOffByDefaultAndSaidToBeThere) {
  Description robot = shipped_text("five_bar");
  EXPECT_FALSE(any_note(*test::load(robot), "is symmetric under"));
  robot.urdf = perturbed(robot.urdf, 1e-5, 1);
  const auto mechanism = test::load(robot);
  EXPECT_TRUE(any_note(*mechanism, "robot.urdf is symmetric under ") &&
              any_note(*mechanism,
                       "mechanism: {symmetrize: 1.0e-4} in robot.yaml takes the symmetric robot nearest"));
  EXPECT_EQ(motions_of(*map_of(*mechanism, 0.5)), 0U);
  robot.urdf = perturbed(robot.urdf, 1e-2, 1);
  EXPECT_FALSE(any_note(*test::load(robot), "is symmetric under"));
}

TEST(Symmetrize, LeavesARobotAsItIsThatIsBeyondTheTolerance) {
  Description robot = shipped_text("five_bar");
  robot.urdf = perturbed(robot.urdf, 1e-4, 1);
  const auto raw = test::load(robot), same = test::load(with_tolerance(robot, "1.0e-6"));
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_EQ(raw->manipulator()->leg(j).anchor, same->manipulator()->leg(j).anchor);
    EXPECT_EQ(raw->manipulator()->leg(j).rod_length, same->manipulator()->leg(j).rod_length);
  }
  ASSERT_FALSE(same->notes().empty());
  EXPECT_EQ(same->notes().front(),
            "No motion that permutes the axes of coordinates takes the robot of robot.urdf onto itself "
            "within mechanism.symmetrize: 1e-06 of robot.yaml; its numbers are taken as they are.");
}

TEST(Symmetrize, IsASmallPositiveNumber) {
  for (const std::string tolerance : {"0", "-1.0e-4", "0.01"})
    EXPECT_EQ(test::refusal(shipped_text("five_bar").urdf,
                            with_tolerance(shipped_text("five_bar"), tolerance).config),
              Problems{"robot.yaml has a mechanism.symmetrize that is not above 0 and at most 0.001; give "
                       "1.0e-4, or leave it out."});
}

// The five-bar with stops at its elbows, walls and a post, beside the symmetry about the x axis by `off`.
Description bounded_five_bar(const std::string& off) {
  Description robot = with_tolerance(shipped_text("five_bar"), "1.0e-4");
  robot.urdf = perturbed(robot.urdf, 1e-5, 1);
  for (const std::string joint : {"elbow_1_joint", "elbow_2_joint"})
    robot.change_urdf(
        "<joint name=\"" + joint + "\" type=\"continuous\">",
        "<joint name=\"" + joint + "\" type=\"revolute\"><limit lower=\"-2.5\" upper=\"2.5" + off + "\"/>");
  robot.config += "\nconstraints:\n  workspace: {lower: [-3.0, -9.0], upper: [12.0, 9.0" + off +
                  "]}\n  obstacles: [{name: post, center: [4.5, 0.0" + off + "], radius: 0.2}]\n";
  return robot;
}

TEST(Symmetrize, ReachesConstraints) {
  const auto mechanism = test::load(bounded_five_bar("0002"));
  EXPECT_TRUE(any_note(*mechanism, "the limits of passive joints are made symmetric, too"));
  EXPECT_FALSE(any_note(*mechanism, "Maps make no use of the symmetry"));
  EXPECT_GT(motions_of(*map_of(*mechanism, 0.5)), 0U);
}

TEST(Symmetrize, NamesWhatIsBeyondTheTolerance) {
  const auto mechanism = test::load(bounded_five_bar("2"));
  EXPECT_TRUE(any_note(*mechanism,
                       "Maps make no use of the symmetry of robot.urdf while these are not symmetric: "
                       "constraints.workspace and constraints.obstacles and the limits of passive joints."));
  EXPECT_EQ(motions_of(*map_of(*mechanism, 0.5)), 0U);
}

TEST(Symmetrize, SaysNothingOfMovesThatAreNotKept) {
  Description robot = with_tolerance(shipped_text("five_bar"), "1.0e-4");
  robot.config +=
      "\nconstraints:\n  obstacles: [{name: post, center: [4.5, 0.0002], radius: 0.2}, {name: wall, center: "
      "[4.5, 3.0], radius: 0.2}]\n";
  const auto mechanism = test::load(robot);
  EXPECT_TRUE(any_note(*mechanism, "while these are not symmetric: constraints.obstacles."));
  EXPECT_FALSE(any_note(*mechanism, "are made symmetric, too"));
}

// A motor that is mounted turned has another zero, which bounds no map.
TEST(Symmetrize, PassesOverLimitsThatLeaveAFullTurn) {
  Description robot = with_tolerance(shipped_text("five_bar"), "1.0e-4");
  robot.urdf = perturbed(robot.urdf, 1e-5, 1);
  robot.urdf =
      std::regex_replace(robot.urdf, std::regex("(<joint name=\"crank_._joint\" type=)\"continuous\">"),
                         "$1\"revolute\"><limit lower=\"-3.14\" upper=\"3.14\"/>");
  robot.urdf = std::regex_replace(robot.urdf, std::regex("(<joint name=\"crank_2_joint\"[^]*?<origin )"),
                                  "$1rpy=\"0 0 0.3\" ");
  const auto mechanism = test::load(robot);
  EXPECT_GT(motions_of(*map_of(*mechanism, 0.5)), 0U);
  EXPECT_NEAR(mechanism->manipulator()->leg(1).limits.upper, 3.14, 1e-12);
  robot.config += "\nconstraints: {strict_limits: true}\n";
  EXPECT_EQ(motions_of(*map_of(*test::load(robot), 0.5)), 0U);
}

// Delta on slides, with limits of its universal joints, which are cones in its cranks.
TEST(Symmetrize, ReachesCones) {
  Description robot{perturbed(test::source_file("test/data/chains/delta_on_slides.urdf"), 3e-6, 1),
                    test::source_file("test/data/chains/delta_on_slides.yaml")};
  robot.urdf = std::regex_replace(robot.urdf,
                                  std::regex("(<joint name=\"rod_._)(pitch|roll)(\" type=)\"continuous\">"),
                                  "$1$2$3\"revolute\"><limit lower=\"-1.2\" upper=\"1.2\"/>");
  const auto raw = test::load(robot), symmetric = test::load(with_tolerance(robot, "1.0e-4"));
  EXPECT_TRUE(any_note(*symmetric, "the limits of passive joints are made symmetric, too"));
  EXPECT_TRUE(
      any_note(*symmetric, "Maps make no use of symmetry (x, y, -z); (x, -y, -z) of robot.urdf while"));
  EXPECT_EQ(motions_of(*map_of(*raw, 0.8)), 0U);
  EXPECT_GT(motions_of(*map_of(*symmetric, 0.8)), 0U);
  const auto& before = raw->mapped_manipulator()->constraints().passive_cones;
  const auto& after = symmetric->mapped_manipulator()->constraints().passive_cones;
  ASSERT_EQ(before.size(), 12U);
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_NEAR((before[k].cone.axis - after[k].cone.axis).norm(), 0.0, 1e-4);
    EXPECT_NEAR(before[k].cone.angle, after[k].cone.angle, 1e-4);
    EXPECT_NEAR(after[k].cone.axis.norm(), 1.0, 1e-15);
  }
}

std::set<std::string> symmetries_of(const Manipulator& robot) {
  MapPlan plan;
  EXPECT_EQ(make_map_plan(robot, {}, plan), "");
  const Box& region = plan.space->region();
  for (std::size_t i = 0; i < region.dimension; ++i)
    EXPECT_TRUE(has_exact_corners(region.lower[i], region.upper[i]));
  std::set<std::string> result;
  for (const MapSymmetry& symmetry : plan.symmetries) result.insert(symmetry.text);
  return result;
}

// The middle of the base is no whole number of the steps that boxes are cut by.
TEST(SymmetricInDecimals, IsSymmetricInTheMap) {
  for (const std::string distance : {"0.25", "0.5", "0.1", "0.2", "0.3", "0.35", "0.7", "0.123457"}) {
    SCOPED_TRACE(distance);
    const auto mechanism =
        test::load(replaced(test::source_file("test/data/described/mirrored_five_bar.urdf"), "0.3 0 0",
                            distance + " 0 0"),
                   test::source_file("test/data/described/mirrored_five_bar.yaml"));
    const std::set<std::string> expected{"(" + distance + "-x, y)", "(x, -y)", "(" + distance + "-x, -y)"};
    EXPECT_EQ(symmetries_of(*mechanism->mapped_manipulator()), expected);
    EXPECT_NEAR(mechanism->manipulator()->leg(1).base_point().x(), std::stod(distance), 1e-14);
    EXPECT_TRUE(mechanism->notes().empty());
  }
}

TEST(SymmetricInDecimals, HoldsForAWorkspace) {
  const std::string config = test::source_file("test/data/described/mirrored_five_bar.yaml");
  const std::string workspace = "\nconstraints: {workspace: {lower: [-0.1, -0.35], upper: [";
  for (const bool is_symmetric : {true, false}) {
    const auto mechanism = test::load(test::source_file("test/data/described/mirrored_five_bar.urdf"),
                                      config + workspace + (is_symmetric ? "0.4" : "0.41") + ", 0.35]}}\n");
    EXPECT_EQ(symmetries_of(*mechanism->mapped_manipulator()).size(), is_symmetric ? 3U : 1U);
  }
}

TEST(SymmetricInDecimals, CountsAsWithoutSymmetry) {
  const auto mechanism = test::load(test::source_file("test/data/described/mirrored_five_bar.urdf"),
                                    test::source_file("test/data/described/mirrored_five_bar.yaml"));
  MapOptions options;
  options.use_symmetry = false;
  const MapResult all = compute_aspect_map(mechanism->mapped_manipulator(), options);
  const MapResult some = compute_aspect_map(mechanism->mapped_manipulator());
  ASSERT_EQ(all.status, MapStatus::complete);
  ASSERT_EQ(some.status, MapStatus::complete);
  EXPECT_EQ(all.map->region().lower, some.map->region().lower);
  EXPECT_EQ(all.map->aspects().size(), some.map->aspects().size());
}

// A difference in the last digit that is written is none of rounding.
TEST(SymmetricInDecimals, IsNotWhatIsWrittenOtherwise) {
  const auto mechanism = test::load(replaced(test::source_file("test/data/described/mirrored_five_bar.urdf"),
                                             "<child link=\"rod_2\"/><origin xyz=\"0.2 0 0\"",
                                             "<child link=\"rod_2\"/><origin xyz=\"0.2000000001 0 0\""),
                                    test::source_file("test/data/described/mirrored_five_bar.yaml"));
  EXPECT_EQ(symmetries_of(*mechanism->mapped_manipulator()), std::set<std::string>{"(x, -y)"});
}

}  // namespace
}  // namespace parallel_aspects
