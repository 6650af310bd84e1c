// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/name_words.h"

#include "urdf/corrections/edit.h"
#include "urdf/description/messages.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using Strings = std::vector<std::string>;

TEST(NameWords, AreSplitWhereReadersSplitThem) {
  EXPECT_EQ(words_of("rod_2-leftTip"), (Strings{"rod", "2", "left", "tip"}));
  EXPECT_EQ(words_of("legBEnd"), (Strings{"leg", "b", "end"}));
  EXPECT_EQ(words_of("TCP"), Strings{"tcp"});
  EXPECT_EQ(words_of(""), Strings{});
  EXPECT_EQ(role_of("crank_2_joint"), role_of("crank_13_joint"));
  EXPECT_GT(operational_point_likeness("platform"), operational_point_likeness("platform_2"));
  EXPECT_EQ(operational_point_likeness("rod_2_tip"), 0);
}

// What is but rounding is no number to type.
TEST(Coordinates, AreWithoutNoise) {
  EXPECT_EQ(placed_name("rod", {0.4, 1.2246e-16, -0.0}), "rod@0.4:0:0");
  EXPECT_EQ(coordinate_text(-6.1e-17), "0");
  EXPECT_EQ(coordinate_text(0.1 + 0.2), "0.3");
  EXPECT_EQ(as_list({-2.8e-11, 1.7e-11, -0.057}), "[0, 0, -0.057]");
  EXPECT_EQ(as_attribute({1e-9, 2e-9, 0.0}), "1e-09 2e-09 0");
}

}  // namespace
}  // namespace parallel_aspects
