// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_DESCRIPTIONS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_DESCRIPTIONS_H

#include <gtest/gtest.h>

#include "support/loops.h"
#include "support/robots/shipped.h"
#include <memory>
#include <string>

namespace parallel_aspects::test {

/// The two texts of a robot. A change replaces every `old`, of which there must be one (`replaced`).
struct Description {
  void change_urdf(const std::string& old, const std::string& by) { urdf = replaced(urdf, old, by); }
  void change_config(const std::string& old, const std::string& by) { config = replaced(config, old, by); }

  std::string urdf, config;
};

inline Description shipped_text(const std::string& robot) {
  return {source_file("urdf/" + robot + ".urdf"), source_file("config/robots/" + robot + ".yaml")};
}

inline std::shared_ptr<const Mechanism> load(const Description& description) {
  return load(description.urdf, description.config);
}

inline Problems refusal(const Description& description) {
  return refusal(description.urdf, description.config);
}

inline void expect_refusal(const Description& description, const std::string& message) {
  EXPECT_EQ(refusal(description), Problems{message});
}

inline std::string fixed_joint(const std::string& parent, const std::string& child,
                               const std::string& origin) {
  return "<joint name=\"" + parent + "_to_" + child + "\" type=\"fixed\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/><origin " + origin + "/></joint>";
}

inline std::string moving_joint(const std::string& name, const std::string& parent, const std::string& child,
                                const std::string& axis, const std::string& origin = "") {
  return "<joint name=\"" + name + "\" type=\"continuous\"><parent link=\"" + parent + "\"/><child link=\"" +
         child + "\"/><origin " + origin + "/><axis xyz=\"" + axis + "\"/></joint>";
}

/// A rod that can swing out of the plane beside the operational point, and a ball joint of three revolute
/// ones there, welded to rod 2: what takes up misalignment in a real five-bar stays still in the model of it.
inline Description five_bar_with_still_joints() {
  Description five_bar = shipped_text("five_bar");
  five_bar.change_urdf(
      "<parent link=\"rod_1\"/>\n    <child link=\"tool\"/>\n    <origin xyz=\"5 0 0\"/>",
      "<parent link=\"swing\"/>\n    <child link=\"tool\"/>\n    <origin xyz=\"1 -0.3 0\"/>");
  five_bar.change_urdf(
      "</robot>",
      "<link name=\"swing\"/><link name=\"ball_1\"/><link name=\"ball_2\"/><link name=\"ball_3\"/>" +
          moving_joint("swing_joint", "rod_1", "swing", "1 0 0", "xyz=\"4 0.3 0\"") +
          moving_joint("ball_1_joint", "tool", "ball_1", "1 0 0") +
          moving_joint("ball_2_joint", "ball_1", "ball_2", "0 1 0") +
          moving_joint("ball_3_joint", "ball_2", "ball_3", "0 0 1") + "</robot>");
  five_bar.change_config("[tool, closing_2], type: revolute", "[ball_3, closing_2], type: fixed");
  return five_bar;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_DESCRIPTIONS_H
