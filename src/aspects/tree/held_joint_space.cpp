// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/held_joint_space.h"

#include "model/angles.h"
#include "parallel_aspects/aspects/held_joint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

constexpr std::size_t direction = 0, angle = 1;  // coordinates

Gluing ends_of(std::uint8_t axis) { return {{0, axis, true}, {0, axis, false}, {0, 1, 2}, {}}; }

double half_turns(double y, double x) { return std::remainder(std::atan2(y, x), full_turn) / pi; }

class HeldJointSpace final : public PoseSpace {
 public:
  HeldJointSpace(const Manipulator& manipulator, const MapSlice& slice)
      : PoseSpace(Box{2, {-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}}, 1, {ends_of(direction), ends_of(angle)}),
        circle_(circle_of_anchor(manipulator, *slice.joint)),
        length_(manipulator.characteristic_length()) {}

  MapPosition position(const Pose& pose) const noexcept override {
    MapPosition result;
    if (!(std::abs(circle_.distance(pose)) <= held_joint_tolerance)) {
      result.point.fill(std::numeric_limits<double>::quiet_NaN());
      return result;
    }
    const Eigen::Vector2d rod = circle_.rod(pose);
    result.point[direction] = half_turns(rod.y(), rod.x());
    result.point[angle] =
        std::remainder(2.0 * std::atan2(pose.orientation.z(), pose.orientation.w()), full_turn) / pi;
    return result;
  }

  Pose pose(const MapPosition& position) const noexcept override {
    return circle_.pose(pi * position.point[direction], pi * position.point[angle]);
  }

  Box shown(const Box& box) const noexcept override {
    Box result = box;
    for (std::size_t i = 0; i < box.dimension; ++i) {
      result.lower[i] *= pi;
      result.upper[i] *= pi;
    }
    return result;
  }

  double measure(const Box& box) const noexcept override { return pi * pi * box.measure(); }

  double longest_edge(const Box& box) const noexcept override {
    return pi * std::max(box.width(direction), box.width(angle));
  }

  bool is_periodic(std::size_t) const noexcept override { return true; }

  // Along the circle of the anchor, not as the operational point moves.
  MapPoint weights() const noexcept override { return {pi * circle_.radius, pi * length_, 1.0}; }

 private:
  AnchorCircle circle_;
  double length_;
};

}  // namespace

std::shared_ptr<const PoseSpace> make_held_joint_space(const Manipulator& manipulator,
                                                       const MapSlice& slice) {
  return std::make_shared<const HeldJointSpace>(manipulator, slice);
}

}  // namespace parallel_aspects
