// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/empty_map.h"

#include "parallel_aspects/model/problems.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
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
  EXPECT_EQ(
      reason(test::five_bar(), region(50.0, 60.0, 0.0, 3.0)),
      "The region lies outside of what the legs can reach, which is within x from -4 to 13 m and y from "
      "-13 to 13 m; give another region, or leave it out.");
  EXPECT_EQ(reason(test::five_bar(), region(12.0, 13.0, 12.0, 13.0)),
            "No pose of the region is within reach of all legs and away from singularities; give another "
            "region, or check the lengths of the legs.");
}

TEST_F(EmptyMap, ASliceOutOfReachIsSaidToBe) {
  MapOptions options;
  options.slice = test::slice_of(test::five_bar(), {{"y", 12.9}});
  EXPECT_EQ(reason(test::five_bar(), options),
            "No pose of the slice is within reach of all legs and away from singularities; hold other "
            "values.");
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
