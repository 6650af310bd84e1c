// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_SLICE_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_SLICE_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Maps are trees over at most three pose coordinates.
inline constexpr std::size_t max_map_dimension = 3;

/// A point of the space of poses that a map is made over, in the order of `coordinate_names` [m or rad].
using MapPoint = std::array<double, max_map_dimension>;

/// A closed box of pose coordinates, in the order of `coordinate_names` [m or rad].
struct Box {
  std::size_t dimension = 0;  ///< how many coordinates count, 0 to `max_map_dimension`
  MapPoint lower{};           ///< lower ends [m or rad]
  MapPoint upper{};           ///< upper ends, not below the lower [m or rad]

  /// Middle of its range of coordinate i [m or rad].
  double center(std::size_t i) const noexcept { return 0.5 * (lower[i] + upper[i]); }

  /// Length of its range of coordinate i [m or rad].
  double width(std::size_t i) const noexcept { return upper[i] - lower[i]; }

  /// Its center.
  MapPoint middle() const noexcept {
    MapPoint result{};
    for (std::size_t i = 0; i < dimension; ++i) result[i] = center(i);
    return result;
  }

  /// Its volume, in the product of the units of its coordinates; 1 in no dimension.
  double measure() const noexcept {
    double product = 1.0;
    for (std::size_t i = 0; i < dimension; ++i) product *= width(i);
    return product;
  }

  /// Whether the point lies in it or on its faces.
  bool contains(const MapPoint& point) const noexcept {
    for (std::size_t i = 0; i < dimension; ++i)
      if (!(lower[i] <= point[i] && point[i] <= upper[i])) return false;
    return true;
  }

  /// The point of the box that is nearest to `point`.
  MapPoint nearest(const MapPoint& point) const noexcept {
    MapPoint result{};
    for (std::size_t i = 0; i < dimension; ++i) result[i] = std::clamp(point[i], lower[i], upper[i]);
    return result;
  }

  /// Squared distance of `point` from the box, with differences multiplied by `weights`.
  double squared_distance(const MapPoint& point, const MapPoint& weights) const noexcept {
    const MapPoint closest = nearest(point);
    double sum = 0.0;
    for (std::size_t i = 0; i < dimension; ++i) {
      const double difference = weights[i] * (point[i] - closest[i]);
      sum += difference * difference;
    }
    return sum;
  }

  /// Rank of the half, quarter or eighth that holds `point`: bit i is set in the upper half along coordinate
  /// i.
  std::uint32_t rank_of(const MapPoint& point) const noexcept {
    std::uint32_t rank = 0;
    for (std::size_t i = 0; i < dimension; ++i)
      if (point[i] >= center(i)) rank |= 1U << i;
    return rank;
  }
};

/// Hooks into a long computation. Both may be left empty.
struct MapControl {
  std::function<void(double)> progress;  ///< called with the share done, 0 to 1, from the calling thread
  const std::atomic<bool>* cancelled = nullptr;  ///< polled; the computation ends soon after it turns true
};

/// Whether the computation is to end.
inline bool is_cancelled(const MapControl& control) noexcept {
  return control.cancelled != nullptr && control.cancelled->load(std::memory_order_relaxed);
}

/// The control of a part of the work, from one share of the whole to another.
inline MapControl part_of(const MapControl& control, double from, double to) {
  MapControl part = control;
  if (control.progress)
    part.progress = [whole = control.progress, from, to](double share) { whole(from + (to - from) * share); };
  return part;
}

/// How a computation ended.
enum class MapStatus { complete, cancelled, refused };

/// What is held, with its value [m or rad]: a pose coordinate or an actuated joint.
struct HeldCoordinate {
  std::string name;    ///< as in `make_slice`
  double value = 0.0;  ///< [m or rad]
};

/// An actuated joint with the value that it is held at.
struct HeldJoint {
  std::size_t leg = 0;    ///< whose joint it is, from 0
  double value = 0.0;     ///< [m or rad]
  bool is_angle = false;  ///< of the joint value: rad, not m
};

/// A line, plane or volume of poses: some of the pose moves, and the rest is held. A map of a slice is one of
/// the connected components within the slice; two of them may be joined outside of it.
///
/// In place of pose coordinates an actuated joint of SE2 may be held. Then the free coordinates are the
/// direction of the rod of its leg, about the proximal point (of a strut about its base point), and phi.
struct MapSlice {
  /// How the platform turns within the slice.
  enum class Rotation {
    none,        ///< the platform keeps its orientation
    about_axis,  ///< by an angle in [-pi, pi] about `axis`
    freely,      ///< every orientation, as in SO3
  };

  Pose held;                                        ///< a pose of the slice, at zero of all that moves
  std::array<bool, 3> moves{};                      ///< whether x, y and z are free
  Rotation rotation = Rotation::none;               ///< of the platform
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< in the task frame; need not be of unit length
  std::string angle_name = "phi";                   ///< of the angle about it
  std::optional<HeldJoint> joint{};                 ///< held in place of pose coordinates; SE2 only
  std::vector<HeldCoordinate> held_coordinates{};   ///< as it was asked for; for people only

  std::size_t free_positions() const noexcept;  ///< how many of x, y and z are free: 0 to 3

  /// 1, 2 or 3, unless it is refused.
  std::size_t dimension() const noexcept;
};

/// The slice of a task space that holds these coordinates and leaves the others free. They are named x, y, z
/// [m], phi (SE2), roll, pitch and yaw (SO3, SE3) [rad], as the task space has them; an orientation is that
/// of URDF, Rz(yaw) Ry(pitch) Rx(roll). Of roll, pitch and yaw none or one may be free, or all three where x,
/// y and z are held. Messages that say what is wrong are added to `problems`; then the slice is of no
/// meaning.
MapSlice make_slice(TaskSpace space, const std::vector<HeldCoordinate>& held, Problems& problems);

/// The same for this manipulator, of which an actuated joint may be held in SE2, by its name, in place of
/// pose coordinates. Coordinates go before joints of the same name.
MapSlice make_slice(const Manipulator& manipulator, const std::vector<HeldCoordinate>& held,
                    Problems& problems);

/// Why there is no map of this slice of the manipulator's poses; empty where there is one.
std::string find_slice_problem(const Manipulator& manipulator, const MapSlice& slice);

/// Names of the free coordinates, in the order of the boxes of its map: positions, then the angle;
/// "direction" and "phi" where a joint is held; none for orientations that are free, which have no box.
std::vector<std::string> coordinate_names(const MapSlice& slice);

/// Unit of its volumes: "m", "m^2", "m^3", "rad", "m rad", "m^2 rad", "rad^2" or "rad^3".
std::string measure_unit(const MapSlice& slice);

/// "z = 1.3 m, roll = 0 rad" and so on, for people.
std::string to_string(const MapSlice& slice);

/// A pose counts as one of a slice with a joint held if the rod of its leg has its length to within this [m].
inline constexpr double held_joint_tolerance = 1e-6;

/// Where the anchor of a leg of SE2 moves while the actuated joint of the leg is held: on a circle in the
/// plane, about the proximal point.
struct AnchorCircle {
  Eigen::Vector2d center;  ///< c(q), in the task frame [m]
  double radius = 0.0;     ///< length of the rod, seen in the plane [m]
  Eigen::Vector2d anchor;  ///< in the platform frame [m]

  /// From the center to the anchor.
  Eigen::Vector2d rod(const Pose& pose) const noexcept;

  /// Of the anchor from the circle [m]; negative inside.
  double distance(const Pose& pose) const noexcept;

  /// With the rod in this direction, and the platform at this angle [rad].
  Pose pose(double direction, double phi) const noexcept;

  /// The pose of the circle with the rod in the same direction and the platform at the same angle.
  Pose nearest(const Pose& pose) const noexcept;
};

/// The leg whose actuated joint has this name.
std::optional<std::size_t> leg_of_joint(const Manipulator& manipulator, const std::string& joint);

/// Of the leg whose joint is held.
AnchorCircle circle_of_anchor(const Manipulator& manipulator, const HeldJoint& joint) noexcept;

/// Why a map can not hold the joint there; empty where it can.
std::string find_held_joint_problem(const Manipulator& manipulator, const HeldJoint& joint);

/// Why the joint of a leg of SE2 or SO3 can not be held there; empty where it can. `holder` begins the
/// message.
std::string find_held_value_problem(const Manipulator& manipulator, const HeldJoint& joint,
                                    const std::string& holder = "The slice");

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_SLICE_H
