// SPDX-License-Identifier: BSD-3-Clause
#include "support/many_joints.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <variant>

namespace parallel_aspects {
namespace {

TEST(HexapodOf200Joints, IsRecognised) {
  const test::HexapodOf200Joints hexapod;
  ASSERT_EQ(hexapod.joints(), 200);
  const auto mechanism = test::load(hexapod.description());
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::SE3);
  EXPECT_EQ(mechanism->mobility(), 12);
  EXPECT_EQ(mechanism->idle_degrees_of_freedom(), 6) << "rods spin between two balls";
  for (const Leg& leg : mechanism->manipulator()->legs()) {
    EXPECT_NEAR(std::get<RevoluteActuation>(leg.actuation).radius, 0.25, 1e-6);
    EXPECT_NEAR(leg.rod_length, 0.6, 1e-6);
    EXPECT_NEAR(leg.anchor.norm(), 0.1, 1e-6);
  }
  EXPECT_EQ(test::open_loops(*mechanism, 0.05), 0);
}

// As many links as make anything quadratic take its time: in a chain, and all on the base.
TEST(ManyLinks, AreLoadedBesideARobot) {
  const int count = test::is_sanitized ? 1000 : 20000;
  for (const bool in_a_chain : {false, true}) {
    std::string extra, parent = "base_link";
    for (int k = 0; k < count; ++k) {
      const std::string child = "extra_" + std::to_string(k);
      extra += "<link name=\"" + child + "\"/>" + test::moving_joint("of_" + child, parent, child, "0 0 1");
      if (in_a_chain) parent = child;
    }
    std::string urdf = test::source_file("urdf/five_bar.urdf");
    urdf.insert(urdf.find("</robot>"), extra);
    const SharedMechanism mechanism =
        load_mechanism(urdf, "robot.urdf", test::source_file("config/robots/five_bar.yaml"), "robot.yaml");
    EXPECT_EQ(mechanism->joint_names().size(), 4U + static_cast<std::size_t>(count));
    EXPECT_EQ(mechanism->determined_joints().size(), 2U);
  }
}

}  // namespace
}  // namespace parallel_aspects
