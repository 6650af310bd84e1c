// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_POSE_SPACE_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_POSE_SPACE_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Index of one of the root boxes that cover a space of poses.
using RootIndex = std::uint32_t;

/// One face of one root box.
struct RootFace {
  RootIndex root;
  std::uint8_t axis;
  bool upper;

  friend bool operator==(const RootFace& a, const RootFace& b) noexcept {
    return a.root == b.root && a.axis == b.axis && a.upper == b.upper;
  }
};

/// `box`, of which coordinates are half turns from this one on, with these in radians.
Box in_radians(Box box, std::size_t first) noexcept;

/// Two faces of root boxes that are the same poses. Along the face, coordinate i of the first is coordinate
/// `axis_of[i]` of the second, running backwards where `flipped[i]`.
struct Gluing {
  RootFace first, second;
  std::array<std::uint8_t, max_map_dimension> axis_of{};
  std::array<bool, max_map_dimension> flipped{};
};

/// A pose as a map has it: a point of a root box.
struct MapPosition {
  RootIndex root = 0;
  MapPoint point{};
};

/// A space of poses laid out as root boxes with glued faces, in coordinates in which boxes can be halved
/// exactly:
///  - T1, T2, T3: one box of positions [m];
///  - SE2: one box of positions [m] and half turns, phi / pi in [-1, 1], whose two ends are glued;
///  - SO3: four cubes [-1, 1]^3, one for each component of the unit quaternion that can be the largest; the
///    coordinates are the other three divided by it. Faces are glued where two components are equally large,
///    and the two quaternions of one rotation fall together;
///  - R1, R2: one box of angles in half turns, each with its two ends glued.
class PoseSpace {
 public:
  virtual ~PoseSpace() = default;

  std::size_t dimension() const noexcept { return region_.dimension; }
  std::size_t root_count() const noexcept { return root_count_; }

  /// The root box, the same for all roots.
  const Box& region() const noexcept { return region_; }

  const std::vector<Gluing>& gluings() const noexcept { return gluings_; }

  /// The same pose on the other side of a glued face that it lies on, exactly; `position` itself where that
  /// face is not glued.
  MapPosition across(const MapPosition& position, std::size_t axis) const noexcept;

  /// A position as far inside as `depth` says, across the glued face that a position lies on; nothing where
  /// that face is not glued.
  std::optional<MapPosition> beyond(const MapPosition& position, std::size_t axis,
                                    double depth) const noexcept;

  /// Where a pose lies; it may be outside the region.
  virtual MapPosition position(const Pose& pose) const noexcept = 0;

  virtual Pose pose(const MapPosition& position) const noexcept = 0;

  /// The box in pose coordinates [m or rad], for people; of dimension 0 for SO3, which has no box of its own.
  virtual Box shown(const Box& box) const noexcept { return box; }

  /// Volume of a box in the unit of `measure_unit`; for SO3 with the density at its center.
  virtual double measure(const Box& box) const noexcept = 0;

  /// Longest edge of a box: m for positions, rad for rotations.
  virtual double longest_edge(const Box& box) const noexcept = 0;

  /// Whether the two ends of a coordinate are glued to each other.
  virtual bool is_periodic(std::size_t) const noexcept { return false; }

  /// What distances between nearby poses multiply differences of coordinates by. Then they are metres, with
  /// rotations of SE2 weighted by the characteristic length; for SO3 they are plain coordinates, and for R1
  /// and R2 they are angles.
  virtual MapPoint weights() const noexcept { return {1.0, 1.0, 1.0}; }

  /// A radius that a ball of this radius in weighted coordinates is sure to hold [m, or rad for SO3, R1 and
  /// R2].
  virtual double proved_radius(const MapPoint&, double radius) const noexcept { return radius; }

 protected:
  PoseSpace(const Box& region, std::size_t root_count, std::vector<Gluing> gluings)
      : region_(region), root_count_(root_count), gluings_(std::move(gluings)) {}

 private:
  MapPosition image(const Gluing& gluing, const MapPosition& position, bool from_first) const noexcept;

  Box region_;
  std::size_t root_count_;
  std::vector<Gluing> gluings_;
};

/// The space of poses of a task space. `positions` bounds the position coordinates (1 for T1, 2 for T2 and
/// SE2, 3 for T3) and is not used for SO3, R1 and R2; `characteristic_length` [m] weights the rotation of
/// SE2. Null for SE3.
std::shared_ptr<const PoseSpace> make_pose_space(const Motions& motions, const Box& positions,
                                                 double characteristic_length);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_POSE_SPACE_H
