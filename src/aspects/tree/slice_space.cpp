// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/slice_space.h"

#include "model/angles.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double rounding =
    1e-9;  // of poses that are meant to lie in the slice [rad, or of 1 m + the position]

bool is_close(double a, double b) { return std::abs(a - b) <= rounding * (1.0 + std::abs(b)); }

bool holds_positions(const MapSlice& slice, const Pose& pose) {
  for (Eigen::Index i = 0; i < 3; ++i)
    if (!slice.moves[static_cast<std::size_t>(i)] && !is_close(pose.position[i], slice.held.position[i]))
      return false;
  return true;
}

MapPosition nowhere() {
  MapPosition result;
  result.point.fill(std::numeric_limits<double>::quiet_NaN());
  return result;
}

bool turns(const MapSlice& slice) { return slice.rotation == MapSlice::Rotation::about_axis; }

Box with_angle(const MapSlice& slice, Box box) {
  if (!turns(slice)) return box;
  box.lower[box.dimension] = -1.0;
  box.upper[box.dimension] = 1.0;
  ++box.dimension;
  return box;
}

std::vector<Gluing> ends_of_angle(const MapSlice& slice) {
  if (!turns(slice)) return {};
  const auto axis = static_cast<std::uint8_t>(slice.free_positions());
  Gluing gluing{{0, axis, true}, {0, axis, false}, {}, {}};
  for (std::uint8_t i = 0; i < max_map_dimension; ++i) gluing.axis_of[i] = i;
  return {gluing};
}

/// Positions, and perhaps an angle about one axis.
class Slice final : public PoseSpace {
 public:
  Slice(const MapSlice& slice, const Box& positions, double characteristic_length)
      : PoseSpace(with_angle(slice, positions), 1, ends_of_angle(slice)),
        slice_(slice),
        axis_(slice.axis.normalized()),
        length_(characteristic_length) {}

  MapPosition position(const Pose& pose) const noexcept override {
    const Eigen::Quaterniond turn = pose.orientation * slice_.held.orientation.conjugate();
    const double along = turns(slice_) ? turn.vec().dot(axis_) : 0.0;
    if (!holds_positions(slice_, pose) || !((turn.vec() - along * axis_).norm() <= rounding))
      return nowhere();
    MapPosition result;
    std::size_t next = 0;
    for (std::size_t i = 0; i < 3; ++i)
      if (slice_.moves[i]) result.point[next++] = pose.position[static_cast<Eigen::Index>(i)];
    if (turns(slice_)) result.point[next] = std::remainder(2.0 * std::atan2(along, turn.w()), full_turn) / pi;
    return result;
  }

  Pose pose(const MapPosition& position) const noexcept override {
    Pose result = slice_.held;
    std::size_t next = 0;
    for (std::size_t i = 0; i < 3; ++i)
      if (slice_.moves[i]) result.position[static_cast<Eigen::Index>(i)] = position.point[next++];
    if (turns(slice_))
      result.orientation = Eigen::AngleAxisd(pi * position.point[next], axis_) * slice_.held.orientation;
    return result;
  }

  Box shown(const Box& box) const noexcept override { return turns(slice_) ? in_radians(box, angle()) : box; }

  double measure(const Box& box) const noexcept override {
    return turns(slice_) ? pi * box.measure() : box.measure();
  }

  double longest_edge(const Box& box) const noexcept override {
    double longest = 0.0;
    for (std::size_t i = 0; i < dimension(); ++i)
      longest = std::max(longest, is_periodic(i) ? pi * box.width(i) : box.width(i));
    return longest;
  }

  bool is_periodic(std::size_t i) const noexcept override { return turns(slice_) && i == angle(); }

  MapPoint weights() const noexcept override {
    MapPoint result{1.0, 1.0, 1.0};
    if (turns(slice_)) result[angle()] = slice_.free_positions() == 0 ? pi : pi * length_;
    return result;
  }

 private:
  std::size_t angle() const noexcept { return dimension() - 1; }

  MapSlice slice_;
  Eigen::Vector3d axis_;
  double length_;
};

/// Every orientation at one position: SO3, moved there.
class HeldPosition final : public PoseSpace {
 public:
  HeldPosition(const MapSlice& slice, const std::shared_ptr<const PoseSpace>& rotations)
      : PoseSpace(rotations->region(), rotations->root_count(), rotations->gluings()),
        slice_(slice),
        rotations_(rotations) {}

  MapPosition position(const Pose& pose) const noexcept override {
    return holds_positions(slice_, pose) ? rotations_->position(pose) : nowhere();
  }

  Pose pose(const MapPosition& position) const noexcept override {
    Pose result = rotations_->pose(position);
    result.position = slice_.held.position;
    return result;
  }

  Box shown(const Box& box) const noexcept override { return rotations_->shown(box); }
  double measure(const Box& box) const noexcept override { return rotations_->measure(box); }
  double longest_edge(const Box& box) const noexcept override { return rotations_->longest_edge(box); }
  double proved_radius(const MapPoint& center, double radius) const noexcept override {
    return rotations_->proved_radius(center, radius);
  }

 private:
  MapSlice slice_;
  std::shared_ptr<const PoseSpace> rotations_;
};

}  // namespace

std::shared_ptr<const PoseSpace> make_slice_space(const MapSlice& slice, const Box& positions,
                                                  double characteristic_length) {
  if (slice.rotation == MapSlice::Rotation::freely)
    return std::make_shared<const HeldPosition>(slice, make_pose_space(TaskSpace::SO3, Box{}, 1.0));
  return std::make_shared<const Slice>(slice, positions, characteristic_length);
}

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

  Box shown(const Box& box) const noexcept override { return in_radians(box, 0); }

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
