// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/reading/description_file.h"

#include <gtest/gtest.h>

#include "support/same_legs.h"

namespace parallel_aspects {
namespace {

TEST(DescriptionFile, XacroIsRefusedWithTheCommandThatExpandsIt) {
  const std::string text = test::source_file("urdf/five_bar.urdf");
  EXPECT_EQ(test::refusal_of_file("arm.urdf.xacro", text).front().substr(0, 55),
            "arm.urdf.xacro is a xacro file, which is expanded first");
  EXPECT_EQ(xacro_command("robots/arm.urdf.xacro"), "'xacro robots/arm.urdf.xacro > arm.urdf'");
  EXPECT_EQ(xacro_command("arm.xacro"), "'xacro arm.xacro > arm.urdf'");
  EXPECT_EQ(xacro_command("arm.urdf"), "'xacro arm.urdf > arm.expanded.urdf'");
}

TEST(DescriptionFile, RecognisesFormatsByTheirFirstElement) {
  const std::string folder = std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/test/data/";
  EXPECT_TRUE(is_urdf_file(folder + "prrp.urdf"));
  EXPECT_FALSE(is_urdf_file(folder + "mjcf/five_bar.xml"));
  EXPECT_FALSE(is_urdf_file(folder + "sdf/five_bar.sdf"));
}

}  // namespace
}  // namespace parallel_aspects
