// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command.h"

#include <gtest/gtest.h>

#include "support/command_run.h"
#include "support/texts.h"
#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using test::Outcome;
using test::run;

using MisspeltNames = test::CommandTest;

TEST_F(MisspeltNames, AreAnsweredWithTheOneThatIsMeant) {
  struct Misspelt {
    std::vector<const char*> arguments;
    std::string begin;
  };
  const std::vector<Misspelt> all{
      {{"describe", "fiv_bar"}, "There is no shipped robot 'fiv_bar'; did you mean five_bar?\n"},
      {{"map", "Linear-Delta"}, "There is no shipped robot 'Linear-Delta'; did you mean linear_delta?\n"},
      {{"map", "three_rpr", "--hold", "phi=0"}, "--hold: there is no such option; did you mean --slice?"},
      {{"plan", "three_rpr", "--hold", "phi=0"}, "--hold: there is no such option; did you mean --slice?"},
      {{"map", "five_bar", "--map", "a.map"}, "--map: there is no such option; did you mean --load?"},
      {{"distance", "five_bar", "--load", "a.map"}, "--load: there is no such option; did you mean --map?"},
      {{"plot", "five_bar", "--picture", "a.svg"},
       "--picture: there is no such option; did you mean --output?"},
      {{"map", "five_bar", "-o", "a.svg"}, "-o: there is no such option; did you mean --picture?"},
      {{"check", "five_bar", "--from", "1 2"}, "--from: there is no such option; did you mean --start-pose?"},
      {{"map", "five_bar", "--resolutoin", "1"},
       "--resolutoin: there is no such option; did you mean --resolution?"},
      {{"decsribe", "five_bar"}, "'decsribe': there is no such subcommand; did you mean describe?"}};
  for (const Misspelt& each : all) {
    const Outcome outcome = run(each.arguments);
    EXPECT_TRUE(test::begins(outcome.messages, each.begin));
    EXPECT_NE(outcome.code, exit_code::ok);
  }
}

}  // namespace
}  // namespace parallel_aspects::tools
