// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/command_run.h"
#include "support/texts.h"
#include <atomic>
#include <fstream>
#include <iterator>
#include <string>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;
using test::run_json;

class WorkspaceCommand : public test::CommandTest {
 protected:
  const std::string svg = testing::TempDir() + "workspace_command_test.svg";
};

TEST_F(WorkspaceCommand, ReportsTheLargestDiscOfEachAspect) {
  const json report = run_json({"workspace", "five_bar", "--shape", "disc"});
  EXPECT_EQ(report.at("shape"), "disc");
  ASSERT_EQ(report.at("workspaces").size(), 10U);
  for (const json& each : report.at("workspaces")) {
    EXPECT_TRUE(each.at("proved"));
    EXPECT_LE(each.at("lower").get<double>(), each.at("upper").get<double>());
    EXPECT_EQ(each.at("lengths").at("radius"), each.at("lower"));
    EXPECT_TRUE(each.at("center").contains("y"));
  }
  const Outcome text = run({"workspace", "five_bar", "--shape", "disc", "--aspect", "8"});
  EXPECT_TRUE(test::has(text.output, "The largest disc lies in aspect 8"));
}

TEST_F(WorkspaceCommand, RatiosCentersAndAspectsAreTaken) {
  const json report = run_json({"workspace", "five_bar", "--shape", "box", "--aspect-ratio", "1:2",
                                "--center", "x=4.5", "--aspect", "1"});
  ASSERT_EQ(report.at("workspaces").size(), 1U);
  const json& found = report.at("workspaces")[0];
  EXPECT_EQ(found.at("center").at("x"), 4.5);
  EXPECT_NEAR(found.at("lengths").at("edge_y"), 2.0 * found.at("lengths").at("edge_x").get<double>(), 1e-12);
}

TEST_F(WorkspaceCommand, DrawsTheShapes) {
  EXPECT_EQ(run({"workspace", "five_bar", "--shape", "square", "--picture", svg.c_str()}).code,
            exit_code::ok);
  std::ifstream stream(svg);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_TRUE(test::has(text, "<title>largest shape</title>"));
}

TEST_F(WorkspaceCommand, WhatDoesNotFitIsRefused) {
  const auto refused = [](std::vector<const char*> arguments) {
    const Outcome outcome = run(std::move(arguments));
    EXPECT_EQ(outcome.code, exit_code::bad_input);
    return outcome.messages;
  };
  EXPECT_EQ(refused({"workspace", "five_bar", "--shape", "ball"}),
            "A ball takes 3 free positions, but 2 are free; choose box, square or disc.\n");
  EXPECT_EQ(refused({"workspace", "five_bar", "--shape", "star"}),
            "--shape is 'star'; give box, square, disc, cylinder or ball.\n");
  EXPECT_EQ(refused({"workspace", "five_bar", "--shape", "disc", "--center", "z=1"}),
            "--center has 'z=1'; give free positions with their values, such as \"x=0.5\".\n");
  EXPECT_EQ(refused({"workspace", "five_bar", "--shape", "disc", "--orientation", "phi=0:1"}),
            "--orientation is of a free angle, but none is free here; leave it out.\n");
  EXPECT_EQ(refused({"workspace", "five_bar", "--shape", "disc", "--aspect", "11"}),
            "--aspect is 11, but the map has 10 aspects, counted from 1; `aspects map` lists them.\n");
  EXPECT_EQ(refused({"workspace", "five_bar", "--shape", "disc", "--gap", "2"}),
            "--gap is a share of the size; give one below 1, such as 0.01.\n");
  EXPECT_EQ(refused({"workspace", "five_bar", "--shape", "box", "--gap", "0", "--center", "z",
                     "--aspect-ratio", "x", "--mode", "+"}),
            "--center has 'z'; give names with their values, such as \"x=1 y=2\".\n"
            "--aspect-ratio has 'x', which is not a finite number; give one.\n"
            "--gap is '0'; give a finite number greater than zero, such as 0.05.\n"
            "--mode is '+'; give the signs of B_jj of each leg, such as \"(-,+)\", for each working mode.\n");
  EXPECT_EQ(refused({"workspace", "five_bar", "--shape", "box", "--center", "z=1", "--aspect-ratio", "3"}),
            "--aspect-ratio has 1 number; give 2, an edge for each free position.\n"
            "--center has 'z=1'; give free positions with their values, such as \"x=0.5\".\n");
  EXPECT_TRUE(test::has(refused({"workspace", "stewart", "--shape", "ball"}), "six degrees of freedom"));
  EXPECT_EQ(run({"workspace", "five_bar"}).code, exit_code::bad_usage);
}

TEST_F(WorkspaceCommand, CtrlCEndsIt) {
  const std::atomic<bool> interrupted{true};
  EXPECT_EQ(run({"workspace", "delta", "--shape", "ball"}, &interrupted).code, exit_code::interrupted);
}

}  // namespace
}  // namespace parallel_aspects::tools
