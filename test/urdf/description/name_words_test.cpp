// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/name_words.h"

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

}  // namespace
}  // namespace parallel_aspects
