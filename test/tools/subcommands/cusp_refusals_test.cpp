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

class CuspRefusals : public test::CommandTest {};

struct Refusal {
  std::vector<const char*> arguments;
  std::string message;
};

void expect_refused(const std::vector<Refusal>& refusals) {
  for (const Refusal& refusal : refusals) {
    const Outcome outcome = run(refusal.arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_input) << refusal.message;
    EXPECT_EQ(outcome.messages, refusal.message + "\n");
    EXPECT_EQ(outcome.output, "");
  }
}

TEST_F(CuspRefusals, NameTheOptionThatBoundsMore) {
  const std::string by_limits =
                        "Cusps and regions of actuated values are bounded by limits of actuated joints alone",
                    exact =
                        "Direct solutions are those of one robot, without tolerances; leave --tolerance out.";
  const char* const pose = "-14.9 1.58 0.245";
  expect_refused(
      {{{"uniqueness", "three_rpr", "--margin", "parallel=0.05"}, by_limits + "; leave --margin out."},
       {{"uniqueness", "three_rpr", "--margin", "parallel=0.05", "--slice", "strut_1_joint=15"},
        by_limits + "; leave --margin out."},
       {{"uniqueness", "three_rpr", "--margin", "parallel=0.05", "--cusps-over", "strut_1_joint"},
        by_limits + "; leave --margin out."},
       {{"plan", "three_rpr", "--margin", "parallel=0.05", "--slice", "strut_1_joint=15", "--from", pose,
         "--around-cusp", "1"},
        by_limits + "; leave --margin out."},
       {{"uniqueness", "three_rpr", "--constraint", "self_collision"},
        by_limits + ", but 'three_rpr' has self_collision; give --no-constraint \"self_collision\"."},
       {{"uniqueness", "three_rpr", "--tolerance", "0.001"}, exact},
       {{"uniqueness", "three_rpr", "--tolerance", "0.001", "--slice", "strut_1_joint=14.98"}, exact},
       {{"uniqueness", "three_rpr", "--tolerance", "0.001", "--cusps-over", "strut_1_joint"}, exact},
       {{"uniqueness", "spherical_3rrr", "--tolerance", "0.001", "--slice", "crank_1_joint=0.3"}, exact},
       {{"uniqueness", "stewart", "--tolerance", "0.001"}, exact},
       {{"plan", "three_rpr", "--tolerance", "0.001", "--slice", "strut_1_joint=15", "--from", pose,
         "--around-cusp", "1"},
        exact}});
}

TEST_F(CuspRefusals, NameWhatASliceHolds) {
  const std::string names =
      "; give one of the actuated joints: slider_1_joint, slider_2_joint, slider_3_joint.";
  expect_refused(
      {{{"uniqueness", "three_prr", "--no-constraint", "all"},
        "All poses of 'three_prr' are examined within limits of its joints, and --no-constraint takes these "
        "out; keep actuated_limits, or give --slice \"slider_1_joint=-0.2\"."},
       {{"uniqueness", "three_prr", "--slice", "slider_2_joint"},
        "--slice has 'slider_2_joint'; give one actuated joint with its value, such as "
        "\"slider_2_joint=-0.2\"."},
       {{"map", "three_prr", "--slice", "slider_2_joint"},
        "--slice has 'slider_2_joint'; give what is held with its value, such as \"slider_2_joint=-0.2\"."},
       {{"map", "three_prr", "--slice", "slider"},
        "--slice has 'slider'; give what is held with its value, such as \"phi=0.5\"."},
       {{"uniqueness", "three_prr", "--slice", "slider_1_join=0.3"}, "--slice names 'slider_1_join'" + names},
       {{"uniqueness", "three_prr", "--slice", "x=3"}, "--slice names 'x'" + names},
       {{"uniqueness", "five_bar", "--margin", "parallel=0.05", "--cusps-over", "crank_1_joint"},
        "In T2 no three direct solutions meet, so that 'five_bar' has no cusps."},
       {{"uniqueness", "five_bar", "--slice", "crank_1_joint=0.3"},
        "In T2 every aspect is a uniqueness domain as a whole; leave --slice out."},
       {{"uniqueness", "three_rpr", "--no-constraint", "all"},
        "All poses of 'three_rpr' are examined within limits of its joints, and --no-constraint takes these "
        "out; keep actuated_limits, or give --slice \"strut_1_joint=19\"."}});
}

TEST_F(CuspRefusals, NameRangesThatAJointHas) {
  expect_refused(
      {{{"uniqueness", "three_rpr", "--cusps-over", "strut_1_joint=10"},
        "--cusps-over has 'strut_1_joint=10'; give the ends of a range, such as \"strut_1_joint=10:32\"."},
       {{"uniqueness", "three_rpr", "--cusps-over", "strut_1_joint=40:50"},
        "The range holds 'strut_1_joint' at 40, outside of its limits, 10 to 32; hold it inside."},
       {{"uniqueness", "three_rpr", "--cusps-over", "strut_1_joint", "--no-constraint", "all"},
        "'strut_1_joint' has no limits on both sides; give the ends of a range, such as "
        "\"strut_1_joint=16:31\"."},
       {{"uniqueness", "five_bar", "--cusps-over", "strut_1_joint"},
        "In T2 no three direct solutions meet, so that 'five_bar' has no cusps."}});
}

TEST_F(CuspRefusals, SayAtOnceWhereThereAreNoCuspsToGoAround) {
  const std::string start = "--around-cusp is of robots that move in SE2, and ";
  expect_refused(
      {{{"plan", "five_bar", "--from", "4 6", "--around-cusp", "1"},
        start + "'five_bar' moves in T2; leave it out."},
       {{"plan", "stewart", "--from", "0 0 1 0 0 0 1", "--around-cusp", "1"},
        start + "'stewart' moves in SE3; leave it out."},
       {{"plan", "three_rpr", "--from", "-14.9 1.58 0.245", "--around-cusp", "1"},
        "--around-cusp needs a slice that holds an actuated joint, where cusps are points; give --slice with "
        "its value at the start, such as \"strut_1_joint=19\"."},
       {{"plan", "three_rpr", "--from", "-14.9 1.58 0.245", "--slice", "phi=0.245", "--around-cusp", "1"},
        "--around-cusp needs a slice that holds an actuated joint, where cusps are points; give --slice with "
        "its value at the start, such as \"strut_1_joint=19\"."},
       {{"plan", "three_rpr", "--from", "-14.9 1.58 0.245", "--slice", "strut_1_joint=15", "--around-cusp",
         "0"},
        "--around-cusp is '0'; give a whole number from 1 to 10000."}});
}

TEST_F(CuspRefusals, NameOneRangeOfCounts) {
  expect_refused({{{"uniqueness", "stewart", "--samples", "0"},
                   "--samples is '0'; give a whole number from 1 to 100000."},
                  {{"uniqueness", "stewart", "--samples", "-5"},
                   "--samples is '-5'; give a whole number from 1 to 100000."},
                  {{"uniqueness", "stewart", "--poses", "0"},
                   "--poses is '0'; give a whole number from 1 to 1000000."}});
}

TEST_F(CuspRefusals, SlicesWithoutComponentsSayWhy) {
  const Outcome outcome =
      run({"uniqueness", "three_rpr", "--slice", "strut_1_joint=1e9", "--no-constraint", "all"});
  EXPECT_EQ(outcome.code, exit_code::ok) << outcome.messages;
  EXPECT_TRUE(test::has(outcome.output, "No pose is proved to lie in one; 39.48 rad^2 are undecided"));
  for (const char* title : {"component ", "connected sets", "basic regions", "uniqueness domains"})
    EXPECT_FALSE(test::has(outcome.output, title)) << title;
}

}  // namespace
}  // namespace parallel_aspects::tools
