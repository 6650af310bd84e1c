// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/empty_map.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include <cmath>
#include <memory>
#include <string>

namespace parallel_aspects {
namespace {

class EmptyMap : public testing::Test {
 protected:
  static std::string reason(const std::shared_ptr<const Manipulator>& robot, const MapOptions& options) {
    const MapResult result = compute_aspect_map(robot, options);
    return result ? why_empty(*result.map) : "refused: " + result.message;
  }
  static MapOptions region(double left, double right, double low, double high) {
    MapOptions options;
    options.region = Box{2, {left, low}, {right, high}};
    return options;
  }
};

TEST_F(EmptyMap, AMapWithAspectsHasNoReason) { EXPECT_EQ(reason(test::five_bar(), {}), ""); }

TEST_F(EmptyMap, ARegionOutOfReachIsSaidToBe) {
  EXPECT_EQ(reason(test::five_bar(), region(50.0, 60.0, 0.0, 3.0)),
            "The region lies outside of what the legs can reach, which is within x from -4 to 13 m and y "
            "from -13 to 13 m; give another region, or leave it out.");
  EXPECT_EQ(reason(test::five_bar(), region(12.0, 13.0, 12.0, 13.0)),
            "No pose of the region is within reach of all legs and away from singularities; give another "
            "region, or check the lengths of the legs.");
}

/// A five-bar of 0.22 m, that far from the origin along x.
std::shared_ptr<const Manipulator> small_five_bar(double away) {
  return test::manipulator("small", TaskSpace::T2,
                           {test::planar_revolute_leg(0, {away, 0.0}, 0.08, 0.05),
                            test::planar_revolute_leg(1, {away + 0.09, 0.0}, 0.05, 0.08)});
}

TEST_F(EmptyMap, OfARobotTooFarFromItsBaseFrameSaysHowFarItMayBe) {
  EXPECT_EQ(reason(small_five_bar(1000.0), {}),
            "refused: The region is 0.17 m wide in x and 1000 m from the origin of the frame 'base_link', "
            "which is too far for exact boxes; put the origin of that frame within 85 m of the robot, or "
            "name a link that is so near as base_link.");
  EXPECT_EQ(reason(small_five_bar(85.0), {}), "") << "the remedy works";
}

TEST_F(EmptyMap, RegionsThatAreNoneHaveOneReason) {
  EXPECT_EQ(reason(test::five_bar(), region(5.0, 4.0, 0.0, 1.0)),
            "refused: The region is empty in x; give its lower end first.");
  EXPECT_EQ(reason(test::five_bar(), region(5.0, 6.0, 0.0, HUGE_VAL)),
            "refused: The region is not finite in y; give one that is.");
  EXPECT_EQ(
      reason(test::five_bar(), region(1e5, 1e5 + 1.0, 0.0, 1.0)).find("refused: The region lies outside"),
      0U);
  const auto apart = test::manipulator("apart", TaskSpace::T2,
                                       {test::planar_revolute_leg(0, {0.0, 0.0}, 1.0, 1.0),
                                        test::planar_revolute_leg(1, {9.0, 0.0}, 1.0, 1.0)});
  EXPECT_EQ(reason(apart, {}),
            "refused: The legs of 'apart' reach no common pose; correct their lengths or limits.");
}

TEST_F(EmptyMap, ASliceOutOfReachIsSaidToBe) {
  MapOptions options;
  options.slice = test::slice_of(test::five_bar(), {{"y", 12.9}});
  EXPECT_EQ(
      reason(test::five_bar(), options),
      "No pose of the slice is within reach of all legs and away from singularities; hold other values.");
}

TEST_F(EmptyMap, TheConstraintThatLeavesNothingIsNamed) {
  Margins margins;
  margins.parallel = 0.9999;
  const std::string text = reason(test::five_bar()->with_margins(margins), region(4.0, 5.0, 5.0, 6.0));
  EXPECT_EQ(text.rfind("Constraint margins leaves nothing of what the legs reach in the region; loosen it, "
                       "or leave it out.",
                       0),
            0U)
      << text;
}

// Without either alone the other one still does.
TEST_F(EmptyMap, TwoConstraintsThatLeaveNothingAreNamed) {
  Margins margins;
  margins.parallel = 0.9999;
  const MapOptions options = region(0.2, 0.8, 0.2, 0.8);  // a strut would be shorter than its limit
  const std::string alone = reason(test::bipod(), options);
  EXPECT_NE(alone.find("Constraint actuated_limits leaves nothing"), std::string::npos) << alone;
  const std::string both = reason(test::bipod()->with_margins(margins), options);
  EXPECT_NE(both.find("Constraints actuated_limits and margins together leave nothing"), std::string::npos)
      << both;
}

}  // namespace
}  // namespace parallel_aspects
