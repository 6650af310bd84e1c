// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/node_options.h"

#include "ros/parameters/load_options.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "support/robots/constrained_robots.h"
#include "support/robots/robots.h"
#include <limits>

namespace parallel_aspects {
namespace {

using XmlRpc::XmlRpcValue;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

bool mention(const Problems& problems, const std::string& words) {
  for (const std::string& problem : problems)
    if (problem.find(words) != std::string::npos) return true;
  return false;
}

TEST(OptionsFrom, EmptyParametersGiveTheDefaults) {
  Problems problems;
  const NodeOptions options = options_from(XmlRpcValue(), "/node/", problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(options.joint_states_timeout, NodeOptions{}.joint_states_timeout);
  EXPECT_FALSE(options.map.resolution);
  EXPECT_FALSE(options.start.pose);
  EXPECT_EQ(options.tracking.samples.longest_interval, options.joint_states_timeout);
}

TEST(OptionsFrom, TheLongestIntervalIsTheTimeoutUnlessItIsStated) {
  XmlRpcValue parameters;
  parameters["joint_states_timeout"] = 2.0;
  Problems problems;
  EXPECT_EQ(options_from(parameters, "/node/", problems).tracking.samples.longest_interval, 2.0);
  parameters["tracking"]["longest_interval"] = infinity;
  parameters["tracking"]["interval_ratio"] = 10;
  const NodeOptions options = options_from(parameters, "/node/", problems);
  EXPECT_EQ(options.tracking.samples.longest_interval, infinity);
  EXPECT_EQ(options.tracking.samples.interval_ratio, 10.0);
  EXPECT_TRUE(problems.empty());
  EXPECT_TRUE(problems_of(options, *test::five_bar(), "/node/").empty());
}

TEST(OptionsFrom, AGuardNeedsItsDecelerations) {
  XmlRpcValue parameters;
  parameters["guard"]["enabled"] = true;
  parameters["guard"]["latency"] = 0.03;
  Problems problems;
  NodeOptions options = options_from(parameters, "/node/", problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(options.guard.latency, 0.03);
  EXPECT_TRUE(mention(problems_of(options, *test::five_bar(), "/node/"), "/node/guard/linear_deceleration"));
  EXPECT_FALSE(mention(problems_of(options, *test::five_bar(), "/node/"), "angular_deceleration"));
  EXPECT_TRUE(
      mention(problems_of(options, *test::agile_eye(), "/node/"), "/node/guard/angular_deceleration"));
  EXPECT_FALSE(mention(problems_of(options, *test::agile_eye(), "/node/"), "linear_deceleration"));
  options.guard.linear_deceleration = 2.0;
  EXPECT_TRUE(problems_of(options, *test::five_bar(), "/node/").empty());
  options.guard.command_timeout = not_a_number;
  options.guard.reference_point = {0.0, 1.0};
  EXPECT_EQ(problems_of(options, *test::five_bar(), "/node/").size(), 2U);
  options = NodeOptions();
  EXPECT_TRUE(problems_of(options, *test::agile_eye(), "/node/").empty());
}

TEST(OptionsFrom, ReadsEveryParameter) {
  XmlRpcValue parameters;
  parameters["map"]["resolution"] = 0.25;
  parameters["map"]["threads"] = 2;
  parameters["map"]["extra_levels"] = 3;
  parameters["map"]["complete"] = true;
  parameters["map"]["region"]["lower"][0] = -1;
  parameters["map"]["region"]["lower"][1] = -2.0;
  parameters["map"]["region"]["upper"][0] = 1.5;
  parameters["map"]["region"]["upper"][1] = 2;
  parameters["start"]["pose"][0] = 4.5;
  parameters["start"]["pose"][1] = 8;
  parameters["start"]["tolerance"] = 0.5;
  parameters["joint_states_timeout"] = 1;
  parameters["tf_timeout"] = 0.0;
  parameters["frame_prefix"] = "left/five_bar";
  parameters["display"]["gallery"] = false;
  parameters["display"]["gallery_scale"] = 2.0;
  parameters["display"]["rate"] = 5.0;
  Problems problems;
  const NodeOptions options = options_from(parameters, "/node/", problems);
  EXPECT_TRUE(problems.empty()) << problems.front();
  EXPECT_EQ(options.map.resolution, 0.25);
  EXPECT_EQ(options.map.threads, 2U);
  EXPECT_EQ(options.map.extra_levels, 3);
  EXPECT_TRUE(options.map.complete);
  ASSERT_TRUE(options.map.region);
  EXPECT_EQ(options.map.region->lower[1], -2.0);
  EXPECT_EQ(options.map.region->upper[0], 1.5);
  EXPECT_EQ(options.start.pose, (std::vector<double>{4.5, 8.0}));
  EXPECT_EQ(options.start.tolerance, 0.5);
  EXPECT_EQ(options.joint_states_timeout, 1.0);
  EXPECT_EQ(options.tf_timeout, 0.0);
  EXPECT_EQ(options.frame_prefix, "left/five_bar");
  EXPECT_FALSE(options.display.gallery);
  EXPECT_EQ(options.display.gallery_scale, 2.0);
  EXPECT_EQ(options.display.rate, 5.0);
  EXPECT_TRUE(problems_of(options, *test::five_bar(), "/node/").empty());
}

// A node that is killed and starts again, or reloads, finds what it has set itself.
TEST(OptionsFrom, TakesWhatTheNodeSets) {
  XmlRpcValue parameters;
  parameters["distance_unit"] = "rad";
  Problems problems;
  options_from(parameters, "/node/", problems);
  EXPECT_TRUE(problems.empty()) << problems.front();
}

TEST(OptionsFrom, ReportsEveryWrongTypeAndUnknownKeyAtOnce) {
  XmlRpcValue parameters;
  parameters["map"]["resolution"] = "fine";
  parameters["map"]["resolutoin"] = 0.1;
  parameters["map"]["threads"] = -1;
  parameters["start"] = 3;
  parameters["display"]["gallery"] = 1;
  parameters["display"]["rate"][0] = 1.0;
  parameters["frame_prefix"] = true;
  parameters["colour"] = "red";
  Problems problems;
  options_from(parameters, "/node/", problems);
  for (const char* words :
       {"/node/map/resolution must be a number", "/node/map/resolutoin is not known",
        "/node/map/threads must be", "/node/start must hold parameters of its own",
        "/node/display/gallery must be true or false", "/node/display/rate must be a number",
        "/node/frame_prefix must be text", "/node/colour is not known; correct its name",
        "/node/map/resolutoin is not known; did you mean 'resolution'?"})
    EXPECT_TRUE(mention(problems, words)) << words;
  EXPECT_EQ(problems.size(), 8U);
}

// What roslaunch makes of `resolution: 1e-3`, in which nobody sees quotes.
TEST(OptionsFrom, SaysHowNumbersWithExponentsAreWritten) {
  XmlRpcValue parameters;
  parameters["map"]["resolution"] = "1e-3";
  Problems problems;
  options_from(parameters, "/node/", problems);
  EXPECT_TRUE(mention(problems, "where it has an exponent with a dot and a sign, as 1.0e-3 or 1.0e+3"));
}

TEST(ProblemsOf, NamesEveryValueOutOfRangeAtOnce) {
  NodeOptions options;
  options.map.resolution = not_a_number;
  options.map.extra_levels = 21;
  options.map.region = Box{2, {0.0, 1.0}, {1.0, 1.0}};
  options.start.pose = std::vector<double>{1.0};
  options.start.determinant_sign = 0;
  options.start.tolerance = -1.0;
  options.joint_states_timeout = infinity;
  options.tracking.samples.longest_interval = 0.0;
  options.tracking.samples.interval_ratio = 0.5;
  options.tf_timeout = -0.1;
  options.display.gallery_scale = not_a_number;
  options.display.radius = -0.2;
  options.display.rate = 0.0;
  options.frame_prefix = "/five bar";
  const Problems problems = problems_of(options, *test::five_bar(), "/node/");
  for (const char* words :
       {"/node/map/resolution", "/node/map/extra_levels", "/node/map/region", "/node/start has both",
        "/node/start/pose must be a list of finite numbers [x, y]", "/node/start/determinant_sign",
        "/node/start/tolerance", "/node/tracking/longest_interval", "/node/tracking/interval_ratio",
        "/node/joint_states_timeout", "/node/tf_timeout", "/node/display/gallery_scale",
        "/node/display/radius", "/node/display/rate", "/node/frame_prefix"})
    EXPECT_TRUE(mention(problems, words)) << words;
  EXPECT_EQ(problems.size(), 15U);
}

TEST(ProblemsOf, AnUpperBoundOfTheCountIsForMaps) {
  NodeOptions options;
  options.map.complete = true;
  EXPECT_TRUE(problems_of(options, *test::delta(), "/node/").empty());
  const Problems problems = problems_of(options, *test::stewart(), "/node/");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_TRUE(mention(problems, "/node/map/complete is for maps"));
}

TEST(ProblemsOf, ATimeoutThatMakesNoSenseIsTheOnlyCause) {
  for (const double timeout : {0.0, -1.0, not_a_number}) {
    XmlRpcValue parameters;
    parameters["joint_states_timeout"] = timeout;
    Problems problems;
    const NodeOptions options = options_from(parameters, "/node/", problems);
    problems = problems_of(options, *test::five_bar(), "/node/");
    ASSERT_EQ(problems.size(), 1U) << timeout;
    EXPECT_TRUE(mention(problems, "/node/joint_states_timeout must be")) << problems.front();
  }
}

TEST(ProblemsOf, AResolutionThatIsTooFineIsRefusedWithItsLimit) {
  NodeOptions options;
  options.map.resolution = 1e-9;
  const Problems problems = problems_of(options, *test::five_bar(), "/node/");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_TRUE(mention(problems, "/node/map/resolution gives no map: The resolution is too fine"));
  EXPECT_TRUE(mention(problems, "no box has edges below 9.69e-08")) << problems.front();
  options.map.resolution = 0.01;
  EXPECT_TRUE(problems_of(options, *test::five_bar(), "/node/").empty());
}

TEST(ProblemsOf, ARegionOrAWorkspaceThatNothingReachesIsRefused) {
  NodeOptions options;
  options.map.region = Box{2, {40.0, 40.0}, {50.0, 50.0}};
  Problems problems = problems_of(options, *test::five_bar(), "/node/");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_TRUE(mention(problems,
                      "/node/map/region gives no map: The region lies outside of what the legs can reach, "
                      "which is within x from -4 to 13 m and y from -13 to 13 m;"))
      << problems.front();
  Constraints constraints;
  constraints.workspace = WorkspaceBox{{40.0, 40.0, 0.0}, {50.0, 50.0, 0.0}};
  problems = problems_of(NodeOptions{}, *test::with(test::five_bar(), constraints), "/node/");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_TRUE(mention(problems, "/node/constraints/workspace gives no map: The workspace that"))
      << problems.front();
}

TEST(ProblemsOf, AStartPoseBeyondReachIsRefused) {
  NodeOptions options;
  options.start.pose = std::vector<double>{40.0, 8.0};
  const Problems problems = problems_of(options, *test::five_bar(), "/node/");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_TRUE(mention(problems, "/node/start/pose cannot be reached")) << problems.front();
  EXPECT_TRUE(mention(problems, "leg")) << problems.front();
  options.start.tolerance = 100.0;
  EXPECT_TRUE(problems_of(options, *test::five_bar(), "/node/").empty()) << "the robot may be elsewhere";
  options.start.tolerance.reset();
  options.start.pose = std::vector<double>{4.5, -8.0};
  EXPECT_TRUE(problems_of(options, *test::five_bar(), "/node/").empty());
}

// Each value that is beyond its range by far, and what the message says of the range.
TEST(ProblemsOf, NamesTheLimitThatANumberIsBeyond) {
  NodeOptions options;
  options.thresholds.parallel_warn = options.thresholds.parallel_stop = 1e300;
  options.guard.enabled = true;
  options.guard.linear_deceleration = 1e300;
  options.guard.reference_point = {1e300, 0.0, 0.0};
  const Problems problems = problems_of(options, *test::five_bar(), "/node/");
  EXPECT_EQ(problems.size(), 4U);
  for (const std::string& problem : problems)
    EXPECT_NE(problem.find("to 1000000"), std::string::npos) << problem;
}

TEST(ProblemsOf, RefusesARegionOfTheWrongDimension) {
  NodeOptions options;
  options.map.region = Box{3, {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
  EXPECT_TRUE(
      mention(problems_of(options, *test::five_bar(), "/node/"), "/node/map/region must have 2 numbers"));
}

TEST(YamlText, KeepsTypesAndTextThatLooksLikeANumber) {
  XmlRpcValue value;
  value["name"] = "1.50";
  value["tilde"] = "~";
  value["count"] = 3;
  value["third"] = 1.0 / 3.0;
  value["on"] = true;
  value["list"][0] = "a: b";
  value["list"][1]["type"] = "revolute";
  const YAML::Node node = YAML::Load(yaml_text(value));
  EXPECT_EQ(node["name"].as<std::string>(), "1.50");
  EXPECT_EQ(node["tilde"].as<std::string>(), "~");
  EXPECT_EQ(node["count"].as<int>(), 3);
  EXPECT_EQ(node["third"].as<double>(), 1.0 / 3.0);
  EXPECT_TRUE(node["on"].as<bool>());
  EXPECT_EQ(node["list"][0].as<std::string>(), "a: b");
  EXPECT_EQ(node["list"][1]["type"].as<std::string>(), "revolute");
}

}  // namespace
}  // namespace parallel_aspects
