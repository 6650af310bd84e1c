// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_SLICE_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_SLICE_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A pose coordinate with the value that it is held at [m or rad].
struct HeldCoordinate {
  std::string name;    ///< as in `make_slice`
  double value = 0.0;  ///< [m or rad]
};

/// A line, plane or volume of poses: some of the pose moves, and the rest is held. A map of a slice is one of
/// the connected components within the slice; two of them may be joined outside of it.
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

/// Why there is no map of this slice of the manipulator's poses; empty where there is one.
std::string find_slice_problem(const Manipulator& manipulator, const MapSlice& slice);

/// Names of the free coordinates, in the order of the boxes of its map: positions, then the angle; none for
/// orientations that are free, which have no box.
std::vector<std::string> coordinate_names(const MapSlice& slice);

/// Unit of its volumes: "m", "m^2", "m^3", "rad", "m rad", "m^2 rad" or "rad^3".
std::string measure_unit(const MapSlice& slice);

/// "z = 1.3 m, roll = 0 rad" and so on, for people.
std::string to_string(const MapSlice& slice);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_SLICE_H
