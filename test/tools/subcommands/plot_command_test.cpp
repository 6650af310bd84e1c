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
#include <vector>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;
using test::run_json;

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

class PlotCommand : public test::CommandTest {
 protected:
  const std::string svg = testing::TempDir() + "plot_command_test.svg";
  const std::string png = testing::TempDir() + "plot_command_test.png";
};

TEST_F(PlotCommand, DrawsTheFiveBar) {
  const json report = run_json({"plot", "five_bar", "-o", svg.c_str()});
  EXPECT_EQ(report.at("picture"), svg);
  EXPECT_EQ(report.at("working_modes").size(), 4U);
  const std::string text = test::contents_of(svg);
  EXPECT_TRUE(test::begins(text, "<svg"));
  EXPECT_EQ(count(text, "<title>aspect "), 20U) << "in the workspace and in joint space";
  EXPECT_EQ(count(text, "<title>parallel"), 12U);
  EXPECT_LT(text.size(), 300000U);
}

TEST_F(PlotCommand, TheEndingSaysWhichFormat) {
  EXPECT_EQ(run({"plot", "bipod", "-o", png.c_str()}).code, exit_code::ok);
  EXPECT_TRUE(test::begins(test::contents_of(png), "\x89PNG"));
  const Outcome other = run({"plot", "bipod", "-o", "a.jpg"});
  EXPECT_EQ(other.code, exit_code::bad_input);
  EXPECT_EQ(other.messages,
            "-o is 'a.jpg', which ends neither with .svg nor with .png; give a name that does.\n");
}

TEST_F(PlotCommand, SectionsOfThreeCoordinates) {
  const Outcome cut =
      run({"plot", "three_prr", "-o", svg.c_str(), "--resolution", "0.1", "--section", "phi=0"});
  EXPECT_EQ(cut.code, exit_code::ok) << cut.messages;
  EXPECT_TRUE(test::has(test::contents_of(svg), "Section phi = 0 rad"));
}

TEST_F(PlotCommand, SaysWhatToDoInstead) {
  const auto message = [&](std::vector<const char*> words) {
    words.insert(words.begin(), "plot");
    words.insert(words.end(), {"-o", svg.c_str()});
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.code, exit_code::bad_input);
    return outcome.messages;
  };
  EXPECT_EQ(message({"stewart"}),
            "'stewart' has six degrees of freedom, and a picture shows three at most; give a slice, such as "
            "--slice \"z=1 roll=0 pitch=0 yaw=0\".\n");
  EXPECT_EQ(
      message({"three_rrr", "--leaves"}),
      "--leaves shows the boxes of maps of two coordinates; give a slice, such as --slice \"phi=0\".\n");
  EXPECT_EQ(message({"five_bar", "--section", "x=1"}),
            "--section cuts maps of three coordinates, but this one has two; leave it out.\n");
  EXPECT_EQ(message({"delta", "--index", "parallel"}),
            "--index and --each-aspect are for two coordinates; give a section too, such as --section "
            "\"z=-0.78\".\n");
  EXPECT_EQ(message({"five_bar", "--index", "depth"}),
            "--index is 'depth'; give parallel or conditioning.\n");
  EXPECT_EQ(message({"agile_eye", "--section", "z=1"}),
            "--section is 'z=1', but orientations are cut at a torsion; give \"torsion=0\".\n");
  EXPECT_EQ(run({"plot", "five_bar"}).code, exit_code::bad_usage) << "without -o";
  EXPECT_EQ(run({"plot", "five_bar", "-o", "/nowhere/a.svg"}).code, exit_code::bad_input);
}

TEST_F(PlotCommand, NeverWritesOverItsInput) {
  const std::string urdf = testing::TempDir() + "plot_command_input.svg";
  const std::string config = PARALLEL_ASPECTS_SOURCE_DIR "/config/robots/five_bar.yaml";
  const std::string shipped = test::contents_of(PARALLEL_ASPECTS_SOURCE_DIR "/urdf/five_bar.urdf");
  std::ofstream(urdf) << shipped;
  const Outcome outcome =
      run({"plot", "--urdf", urdf.c_str(), "--config", config.c_str(), "-o", urdf.c_str()});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(outcome.messages, "would be overwritten"));
  EXPECT_EQ(test::contents_of(urdf), shipped);
}

TEST_F(PlotCommand, CtrlCLeavesNoPicture) {
  const std::string file = testing::TempDir() + "plot_command_interrupted.svg";
  const std::atomic<bool> interrupted{true};
  EXPECT_EQ(run({"plot", "five_bar", "-o", file.c_str()}, &interrupted).code, exit_code::interrupted);
  EXPECT_EQ(test::contents_of(file), "");
}

}  // namespace
}  // namespace parallel_aspects::tools
