// SPDX-License-Identifier: BSD-3-Clause
//
// A few of the runs that scripts/stopping_campaign makes.
#include "ros/monitor/stopping_campaign.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include <string>

namespace parallel_aspects {
namespace {

class Stopping : public testing::TestWithParam<const char*> {};

TEST_P(Stopping, IsReportedBeforeTheThresholdIsPassedByMoreThanASample) {
  test::StoppingPlan plan;
  plan.speeds = {0.1};
  plan.noises = {0.0, 1e-4};
  plan.runs = 1;
  long runs = 0;
  for (const Hazard hazard : {Hazard::parallel_singularity, Hazard::serial_singularity, Hazard::limit}) {
    const test::StoppingCounts counts =
        test::StoppingCampaign(test::shipped(GetParam()), plan, 1).run(hazard);
    runs += counts.runs;
    EXPECT_EQ(counts.too_near, 0) << name(hazard) << ": " << counts.first_failure;
    EXPECT_EQ(counts.passed, 0) << name(hazard) << ": " << counts.first_failure;
  }
  EXPECT_GT(runs, 0);
}

INSTANTIATE_TEST_SUITE_P(ShippedRobots, Stopping,
                         testing::Values("five_bar", "bipod", "three_rpr", "three_rrr", "three_prr", "delta",
                                         "linear_delta", "agile_eye", "spherical_3rrr", "stewart", "hexa",
                                         "six_pus"),
                         [](const testing::TestParamInfo<const char*>& tested) {
                           return std::string(tested.param);
                         });

}  // namespace
}  // namespace parallel_aspects
