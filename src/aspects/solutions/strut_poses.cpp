// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/strut_poses.h"

#include "model/angles.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/leg.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr double pose_box_half_width = 0x1p-32;  // [half turns]

}  // namespace

Pose StrutPoses::pose(const Box& box, const Lengths& lengths) const {
  return circle(lengths[2] * lengths[2]).pose(pi * box.center(0), pi * box.center(1));
}

// Where the anchor of the first strut, or of that which is held, moves while its length stays the same.
AnchorCircle StrutPoses::circle(double squared_length) const {
  if (!is_family_) return circle_of_anchor(manipulator_, {legs_[2], held_, false});
  const Leg& leg = manipulator_.leg(legs_[2]);
  const Eigen::Vector3d center = leg.base_point();
  const double height = leg.anchor.z() - center.z();
  return {center.head<2>(), std::sqrt(std::max(0.0, squared_length - height * height)), leg.anchor.head<2>()};
}

Box box_about(const AnchorCircle& circle, const Pose& pose) {
  const Eigen::Vector2d rod = circle.rod(pose);
  const double phi = 2.0 * std::atan2(pose.orientation.z(), pose.orientation.w());
  const std::array<double, 2> at{std::atan2(rod.y(), rod.x()) / pi, std::remainder(phi, full_turn) / pi};
  Box box{2, {}, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    box.lower[i] = at[i] - pose_box_half_width;
    box.upper[i] = at[i] + pose_box_half_width;
  }
  return box;
}

Box StrutPoses::box_about(const Pose& pose) const { return parallel_aspects::box_about(circle(0.0), pose); }

Lengths StrutPoses::lengths(const JointVector& actuated) const {
  Lengths result{};
  const bool is_known = static_cast<std::size_t>(actuated.size()) == manipulator_.leg_count();
  for (std::size_t i = 0; i < (is_family_ ? 3U : 2U); ++i) {
    const Leg& leg = manipulator_.leg(legs_[i]);
    const double q = is_known ? actuated[static_cast<Eigen::Index>(legs_[i])] : std::nan("");
    result[i] = std::isfinite(q) && leg.can_have(q) ? std::sqrt(leg.squared_distance(q)) : -1.0;
  }
  return result;
}

JointVector StrutPoses::actuated(const Pose& pose) const {
  JointVector q = inverse(manipulator_, pose, working_modes(manipulator_).front()).q;
  if (!is_family_ && q.size() > 0) q[static_cast<Eigen::Index>(legs_[2])] = held_;
  return q;
}

}  // namespace parallel_aspects
