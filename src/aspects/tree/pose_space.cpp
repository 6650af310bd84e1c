// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/pose_space.h"

#include "model/angles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

class Positions final : public PoseSpace {
 public:
  explicit Positions(const Box& region) : PoseSpace(region, 1, {}) {}

  MapPosition position(const Pose& pose) const noexcept override {
    MapPosition result;
    for (std::size_t i = 0; i < dimension(); ++i)
      result.point[i] = pose.position[static_cast<Eigen::Index>(i)];
    return result;
  }

  Pose pose(const MapPosition& position) const noexcept override {
    Pose result;
    for (std::size_t i = 0; i < dimension(); ++i)
      result.position[static_cast<Eigen::Index>(i)] = position.point[i];
    return result;
  }

  double measure(const Box& box) const noexcept override { return box.measure(); }

  double longest_edge(const Box& box) const noexcept override {
    double longest = 0.0;
    for (std::size_t i = 0; i < dimension(); ++i) longest = std::max(longest, box.width(i));
    return longest;
  }
};

Box with_half_turns(Box positions) {
  positions.dimension = 3;
  positions.lower[2] = -1.0;
  positions.upper[2] = 1.0;
  return positions;
}

class PlanarMotions final : public PoseSpace {
 public:
  PlanarMotions(const Box& positions, double characteristic_length)
      : PoseSpace(with_half_turns(positions), 1, {{{0, 2, true}, {0, 2, false}, {0, 1, 2}, {}}}),
        length_(characteristic_length) {}

  MapPosition position(const Pose& pose) const noexcept override {
    const double half_angle = std::atan2(pose.orientation.z(), pose.orientation.w());
    return {0, {pose.position.x(), pose.position.y(), std::remainder(2.0 * half_angle, full_turn) / pi}};
  }

  Pose pose(const MapPosition& position) const noexcept override {
    Pose result;
    result.position.head<2>() << position.point[0], position.point[1];
    result.orientation = Eigen::AngleAxisd(pi * position.point[2], Eigen::Vector3d::UnitZ());
    return result;
  }

  Box shown(const Box& box) const noexcept override { return in_radians(box, 2); }

  double measure(const Box& box) const noexcept override { return pi * box.measure(); }

  double longest_edge(const Box& box) const noexcept override {
    return std::max({box.width(0), box.width(1), pi * box.width(2)});
  }

  bool is_periodic(std::size_t i) const noexcept override { return i == 2; }

  MapPoint weights() const noexcept override { return {1.0, 1.0, pi * length_}; }

 private:
  double length_;
};

constexpr std::size_t quaternion_components = 4;

// Coordinate i of the cube of component `largest` is this component of the quaternion (x, y, z, w).
std::uint8_t component_of(RootIndex largest, std::size_t i) {
  return static_cast<std::uint8_t>(i < largest ? i : i + 1);
}

std::uint8_t coordinate_of(RootIndex largest, std::size_t component) {
  return static_cast<std::uint8_t>(component < largest ? component : component - 1);
}

// On the face of cube a where component b is s times component a, dividing by b instead of a multiplies all
// by s.
Gluing quaternion_gluing(RootIndex a, RootIndex b, bool upper) {
  Gluing gluing;
  gluing.first = {a, coordinate_of(a, b), upper};
  gluing.second = {b, coordinate_of(b, a), upper};
  for (std::uint8_t i = 0; i < max_map_dimension; ++i) {
    if (i == gluing.first.axis) continue;
    gluing.axis_of[i] = coordinate_of(b, component_of(a, i));
    gluing.flipped[i] = !upper;
  }
  gluing.axis_of[gluing.first.axis] = gluing.second.axis;
  return gluing;
}

std::vector<Gluing> quaternion_gluings() {
  std::vector<Gluing> gluings;
  for (RootIndex a = 0; a < quaternion_components; ++a)
    for (RootIndex b = a + 1; b < quaternion_components; ++b)
      for (const bool upper : {false, true}) gluings.push_back(quaternion_gluing(a, b, upper));
  return gluings;
}

class Rotations final : public PoseSpace {
 public:
  Rotations()
      : PoseSpace(Box{3, {-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}, quaternion_components, quaternion_gluings()) {}

  MapPosition position(const Pose& pose) const noexcept override {
    const Eigen::Vector4d quaternion = pose.orientation.coeffs();
    Eigen::Index largest = 0;
    quaternion.cwiseAbs().maxCoeff(&largest);
    MapPosition result{static_cast<RootIndex>(largest), {}};
    for (std::size_t i = 0; i < 3; ++i)
      result.point[i] = quaternion[component_of(result.root, i)] / quaternion[largest];
    return result;
  }

  Pose pose(const MapPosition& position) const noexcept override {
    Eigen::Vector4d quaternion;
    quaternion[position.root] = 1.0;
    for (std::size_t i = 0; i < 3; ++i) quaternion[component_of(position.root, i)] = position.point[i];
    Pose result;
    result.orientation = Eigen::Quaterniond(Eigen::Vector4d(quaternion.normalized()));
    return result;
  }

  Box shown(const Box&) const noexcept override { return {}; }

  // The unit 3-sphere has the density 1 / (1 + |a|^2)^2 over these coordinates, rotations 8 times that: the
  // volume of all rotations is 8 pi^2 rad^3.
  double measure(const Box& box) const noexcept override {
    double squared_norm = 1.0;
    for (std::size_t i = 0; i < 3; ++i) squared_norm += box.center(i) * box.center(i);
    return 8.0 * box.measure() / (squared_norm * squared_norm);
  }

  // A coordinate changes the rotation by at most 2 rad a unit.
  double longest_edge(const Box& box) const noexcept override {
    return 2.0 * std::max({box.width(0), box.width(1), box.width(2)});
  }

  // |d rotation| >= 2 |da| / (1 + |a|^2), and |a| is at most the distance of the far side of the ball.
  double proved_radius(const MapPoint& center, double radius) const noexcept override {
    const double farthest = std::hypot(center[0], center[1], center[2]) + radius;
    return 2.0 * radius / (1.0 + farthest * farthest);
  }
};

Box whole_turns(std::size_t count) {
  Box box{count, {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    box.lower[i] = -1.0;
    box.upper[i] = 1.0;
  }
  return box;
}

std::vector<Gluing> ends_of_turns(std::size_t count) {
  std::vector<Gluing> gluings;
  for (std::uint8_t i = 0; i < count; ++i) gluings.push_back({{0, i, true}, {0, i, false}, {0, 1, 2}, {}});
  return gluings;
}

class HingeAngles final : public PoseSpace {
 public:
  explicit HingeAngles(const Motions& motions)
      : PoseSpace(whole_turns(degrees_of_freedom(motions.space)), 1,
                  ends_of_turns(degrees_of_freedom(motions.space))),
        motions_(motions) {}

  MapPosition position(const Pose& pose) const noexcept override {
    const PoseCoordinates angles = pose_coordinates(motions_.space, pose);
    MapPosition result;
    for (std::size_t i = 0; i < dimension(); ++i) result.point[i] = angles[static_cast<Eigen::Index>(i)] / pi;
    return result;
  }

  Pose pose(const MapPosition& position) const noexcept override {
    PoseCoordinates angles(static_cast<Eigen::Index>(dimension()));
    for (std::size_t i = 0; i < dimension(); ++i)
      angles[static_cast<Eigen::Index>(i)] = pi * position.point[i];
    return pose_from_coordinates(motions_, angles).value_or(Pose{});
  }

  Box shown(const Box& box) const noexcept override { return in_radians(box, 0); }

  double measure(const Box& box) const noexcept override {
    return dimension() == 1 ? pi * box.measure() : pi * pi * box.measure();
  }

  double longest_edge(const Box& box) const noexcept override {
    return pi * (dimension() == 1 ? box.width(0) : std::max(box.width(0), box.width(1)));
  }

  bool is_periodic(std::size_t) const noexcept override { return true; }

  MapPoint weights() const noexcept override { return {pi, pi, 1.0}; }

 private:
  Motions motions_;
};

}  // namespace

Box in_radians(Box box, std::size_t first) noexcept {
  for (std::size_t i = first; i < box.dimension; ++i) {
    box.lower[i] *= pi;
    box.upper[i] *= pi;
  }
  return box;
}

MapPosition PoseSpace::across(const MapPosition& position, std::size_t axis) const noexcept {
  const bool upper = position.point[axis] == region_.upper[axis];
  const RootFace face{position.root, static_cast<std::uint8_t>(axis), upper};
  for (const Gluing& gluing : gluings_)
    if (gluing.first == face || gluing.second == face) return image(gluing, position, gluing.first == face);
  return position;
}

std::optional<MapPosition> PoseSpace::beyond(const MapPosition& position, std::size_t axis,
                                             double depth) const noexcept {
  const bool upper = position.point[axis] == region_.upper[axis];
  const RootFace face{position.root, static_cast<std::uint8_t>(axis), upper};
  for (const Gluing& gluing : gluings_) {
    if (!(gluing.first == face) && !(gluing.second == face)) continue;
    const bool from_first = gluing.first == face;
    const RootFace& to = from_first ? gluing.second : gluing.first;
    MapPosition result = image(gluing, position, from_first);
    result.point[to.axis] += to.upper ? -depth : depth;
    return result;
  }
  return std::nullopt;
}

// Ranges of flipped coordinates are symmetric, so that changing the sign is exact.
MapPosition PoseSpace::image(const Gluing& gluing, const MapPosition& position,
                             bool from_first) const noexcept {
  const RootFace& to = from_first ? gluing.second : gluing.first;
  MapPosition result{to.root, {}};
  for (std::size_t i = 0; i < dimension(); ++i) {
    const std::size_t from = from_first ? i : gluing.axis_of[i], there = from_first ? gluing.axis_of[i] : i;
    result.point[there] = gluing.flipped[i] ? -position.point[from] : position.point[from];
  }
  result.point[to.axis] = to.upper ? region_.upper[to.axis] : region_.lower[to.axis];
  return result;
}

std::shared_ptr<const PoseSpace> make_pose_space(const Motions& motions, const Box& positions,
                                                 double characteristic_length) {
  const TaskSpace space = motions.space;
  if (has_hinges(space)) return std::make_shared<const HingeAngles>(motions);
  if (!has_rotation(space)) return std::make_shared<const Positions>(positions);
  if (!has_translation(space)) return std::make_shared<const Rotations>();
  if (space == TaskSpace::SE2) return std::make_shared<const PlanarMotions>(positions, characteristic_length);
  return nullptr;
}

}  // namespace parallel_aspects
