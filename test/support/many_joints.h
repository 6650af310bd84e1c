// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_MANY_JOINTS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_MANY_JOINTS_H

#include "support/descriptions.h"
#include <array>
#include <cmath>
#include <string>

namespace parallel_aspects::test {

/// A hexapod of 200 joints, as a CAD export makes one: on a linear axis and a column, with motors, encoders
/// and sensors as links of their own, balls of three revolute joints at both ends of each rod, which is
/// welded to the platform, and two hands of five fingers on that.
class HexapodOf200Joints {
 public:
  HexapodOf200Joints() {
    add_stand();
    for (std::size_t k = 0; k < 6; ++k) add_leg(k);
    for (const char* side : {"left", "right"}) add_hand(side);
    while (joints_ < 200) frame("platform", "marker_" + std::to_string(joints_), "xyz=\"0.01 0 0.02\"");
    description_.urdf = "<robot name=\"hexapod\"><link name=\"rail\"/>" + text_ + "</robot>";
    description_.config = "mechanism: {base_link: base, operational_point: platform, actuated_joints: [" +
                          joints_to_actuate_ + "], closures: [" + closures_ + "]}";
  }

  const Description& description() const { return description_; }
  int joints() const { return joints_; }

 private:
  static std::string number(double value) { return std::to_string(value); }

  void link(const std::string& name) { text_ += "<link name=\"" + name + "\"/>"; }

  void frame(const std::string& parent, const std::string& child, const std::string& origin) {
    link(child);
    text_ += fixed_joint(parent, child, origin);
    ++joints_;
  }

  void joint(const std::string& name, const std::string& parent, const std::string& child,
             const std::string& axis, const std::string& origin = "") {
    link(child);
    text_ += moving_joint(name, parent, child, axis, origin);
    ++joints_;
  }

  // Three joints that meet in a point.
  std::string ball(const std::string& parent, const std::string& name, const std::string& origin) {
    joint(name + "_x", parent, name + "_1", "1 0 0", origin);
    joint(name + "_y", name + "_1", name + "_2", "0 1 0");
    joint(name + "_z", name + "_2", name + "_3", "0 0 1");
    return name + "_3";
  }

  void add_stand() {
    joint("rail_joint", "rail", "column", "1 0 0");
    frame("column", "base", "xyz=\"0 0 2\"");
    frame("base", "cabinet", "xyz=\"0 0 0.3\"");
  }

  // Pairs of cranks on a circle of 0.3 m, level at zero; corners of the platform on one of 0.1 m.
  void add_leg(std::size_t k) {
    const std::string leg = std::to_string(k + 1);
    const double pair = 2.0 * M_PI / 3.0 * static_cast<double>(k / 2), side = k % 2 == 0 ? -1.0 : 1.0;
    frame("base", "foot_" + leg,
          "xyz=\"" + number(0.3 * std::cos(pair + 0.3 * side)) + " " +
              number(0.3 * std::sin(pair + 0.3 * side)) + " 0\" rpy=\"0 0 " + number(pair) + "\"");
    frame("foot_" + leg, "motor_" + leg, "xyz=\"-0.1 0 0\"");
    joint("crank_" + leg, "foot_" + leg, "arm_" + leg, "0 1 0");
    frame("arm_" + leg, "encoder_" + leg, "");
    frame("arm_" + leg, "tip_" + leg, "xyz=\"0.25 0 0\"");
    const std::string rod = ball("tip_" + leg, "upper_ball_" + leg, "");
    frame(rod, "strain_gauge_" + leg, "xyz=\"0 0 -0.3\"");
    const std::string end = ball(rod, "lower_ball_" + leg, "xyz=\"0 0 -0.6\"");
    const double corner = pair + 0.6 * side;
    add_corner(k, end, 0.1 * std::cos(corner), 0.1 * std::sin(corner));
    joints_to_actuate_ += (k == 0 ? "crank_" : ", crank_") + leg;
  }

  // The platform is attached to leg 1; each other leg is welded to a corner of it.
  void add_corner(std::size_t k, const std::string& end, double x, double y) {
    if (k == 0) {
      frame(end, "platform", "xyz=\"" + number(-x) + " " + number(-y) + " 0\"");
      return;
    }
    const std::string corner = "corner_" + std::to_string(k + 1);
    frame("platform", corner, "xyz=\"" + number(x) + " " + number(y) + " 0\"");
    closures_ += (k == 1 ? "" : ", ") + ("{frames: [" + end + ", " + corner + "], type: fixed}");
  }

  void add_hand(const std::string& side) {
    const std::string palm = ball("platform", side + "_wrist", "xyz=\"0 0 -0.1\"");
    for (int finger = 0; finger < 5; ++finger) {
      std::string parent = palm;
      for (int phalanx = 0; phalanx < 4; ++phalanx) {
        const std::string child = side + "_finger_" + std::to_string(finger) + std::to_string(phalanx);
        joint(child + "_joint", parent, child, phalanx == 0 ? "0 0 1" : "0 1 0", "xyz=\"0 0 -0.03\"");
        parent = child;
      }
      frame(parent, parent + "_tip", "xyz=\"0 0 -0.03\"");
    }
  }

  Description description_;
  std::string text_, joints_to_actuate_, closures_;
  int joints_ = 0;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_MANY_JOINTS_H
