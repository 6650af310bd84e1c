// SPDX-License-Identifier: BSD-3-Clause
#include "support/many_joints.h"

#include <gtest/gtest.h>

#include <variant>

namespace parallel_aspects {
namespace {

TEST(HexapodOf200Joints, IsRecognised) {
  const test::HexapodOf200Joints hexapod;
  ASSERT_EQ(hexapod.joints(), 200);
  const auto mechanism = test::load(hexapod.description());
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::SE3);
  EXPECT_EQ(mechanism->mobility(), 12);
  EXPECT_EQ(mechanism->idle_freedoms(), 6) << "rods spin between two balls";
  for (const Leg& leg : mechanism->manipulator()->legs()) {
    EXPECT_NEAR(std::get<RevoluteDrive>(leg.drive).radius, 0.25, 1e-6);
    EXPECT_NEAR(leg.rod_length, 0.6, 1e-6);
    EXPECT_NEAR(leg.anchor.norm(), 0.1, 1e-6);
  }
  EXPECT_EQ(test::open_loops(*mechanism, 0.05), 0);
}

}  // namespace
}  // namespace parallel_aspects
