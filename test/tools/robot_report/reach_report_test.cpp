// SPDX-License-Identifier: BSD-3-Clause
#include "tools/robot_report/reach_report.h"

#include "tools/report/answer_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/command_run.h"
#include "support/descriptions.h"
#include "support/texts.h"
#include <string>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

ask::RobotDescription described(const std::string& name) {
  const std::shared_ptr<const Mechanism> mechanism =
      test::load(test::source_file("test/data/described/" + name + ".urdf"),
                 test::source_file("test/data/described/" + name + ".yaml"));
  ask::Session session(mechanism->manipulator());
  session.know(mechanism);
  return answer(session, ask::DescribeQuestion()).answer;
}

json workspace_of(const std::string& name) {
  const ask::RobotDescription description = described(name);
  return answer_json(*description.mechanism->manipulator(), description).at("workspace");
}

// Struts of 93 to 107 mm between hexagons of 200 and 120 mm: random poses all over miss what is reached.
TEST(Reach, IsFoundAboutTheStart) {
  const json reach = workspace_of("short_strokes");
  EXPECT_GT(reach.at("reached_poses"), 100);
  for (const char* axis : {"x", "y"}) {
    EXPECT_NEAR(double{reach.at("alone").at(axis).at("lower")}, -0.007, 0.002) << axis;
    EXPECT_NEAR(double{reach.at("alone").at(axis).at("upper")}, 0.007, 0.002) << axis;
    EXPECT_LE(reach.at("lower").at(axis), reach.at("alone").at(axis).at("lower"));
    EXPECT_GE(reach.at("upper").at(axis), reach.at("alone").at(axis).at("upper"));
  }
  EXPECT_GT(reach.at("alone").at("yaw").at("upper"), 0.01);
  EXPECT_LT(reach.at("upper").at("z"), 0.11);
}

TEST(Reach, IsReportedInDegrees) {
  const std::string text = reach_text(described("short_strokes"));
  EXPECT_TRUE(test::begins(text, "workspace: x from -0.0"));
  EXPECT_TRUE(test::has(text, "one coordinate alone"));
  EXPECT_TRUE(test::has(text, " degrees, about\n"));
}

// A ring: |r1 - r2| to r1 + r2 about each of two motors.
TEST(Reach, HoldsWhatAFiveBarReaches) {
  const json reach = workspace_of("mirrored_five_bar");
  EXPECT_NEAR(double{reach.at("lower").at("x")}, 0.3 - 0.45, 0.01);
  EXPECT_NEAR(double{reach.at("upper").at("x")}, 0.45, 0.01);
  EXPECT_NEAR(double{reach.at("upper").at("y")}, 0.4243, 0.01);
  EXPECT_TRUE(reach.at("alone").empty());
}

// The pose that `describe` offers is solved as it is typed.
TEST(Home, IsSolvedAsItIsTyped) {
  for (const char* name : {"open_hexapod", "half_open_hexapod", "hexapod_at_limits"}) {
    const std::string folder = std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/test/data/described/";
    const std::string urdf = folder + name + ".urdf", config = folder + "hexapod.yaml";
    const std::string told =
        test::run({"describe", "--urdf", urdf.c_str(), "--config", config.c_str()}).output;
    const std::size_t at = told.find("--pose \"") + 8;
    const std::string pose = told.substr(at, told.find('"', at) - at);
    const json answer =
        test::run_json({"ik", "--urdf", urdf.c_str(), "--config", config.c_str(), "--pose", pose.c_str()});
    EXPECT_EQ(answer.at("solutions").at(0).at("status"), "solved") << name;
    EXPECT_TRUE(answer.at("solutions").at(0).at("joint_outside_limits").is_null()) << name;
  }
}

}  // namespace
}  // namespace parallel_aspects::tools
