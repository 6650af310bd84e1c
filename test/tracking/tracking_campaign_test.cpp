// SPDX-License-Identifier: BSD-3-Clause
//
// A small ground-truth campaign; scripts/tracking_campaign makes the large one.
#include "support/tracking_campaign.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include <string>

namespace parallel_aspects {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr long steps = 300;
#else
constexpr long steps = 4000;
#endif

class SmallCampaign : public testing::TestWithParam<const char*> {};

TEST_P(SmallCampaign, FindsNoWrongAnswer) {
  const auto mechanism = test::shipped(GetParam());
  const test::CampaignCounts counts = test::TrackingCampaign(*mechanism, 20261121).run(steps);
  EXPECT_EQ(counts.wrong, 0) << counts.first_wrong;
  EXPECT_GE(counts.tracked, counts.steps / 2);
  EXPECT_LE(counts.avoidable, counts.steps / 50);
  EXPECT_EQ(counts.crossings_found, counts.crossings_made);
}

INSTANTIATE_TEST_SUITE_P(ShippedRobots, SmallCampaign, testing::ValuesIn(test::campaign_robots),
                         [](const testing::TestParamInfo<const char*>& tested) {
                           return std::string(tested.param);
                         });

}  // namespace
}  // namespace parallel_aspects
