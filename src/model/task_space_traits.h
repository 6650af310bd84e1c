// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_TASK_SPACE_TRAITS_H
#define PARALLEL_ASPECTS_MODEL_TASK_SPACE_TRAITS_H

#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace parallel_aspects {

/// What differs by task space and is a number, a name or a unit.
struct TaskSpaceTraits {
  std::string_view name;
  std::size_t translations;  ///< degrees of freedom along x, then y, then z
  std::size_t
      rotations;  ///< 1: about z; 2: of two hinges; 3: all. They come first in twists and columns of A.
  bool planar;    ///< whether legs and platform stay in the x-y plane
  double resolution_parts;  ///< of the robot's size in the default resolution; 0 where that is an angle
  std::string_view measure_unit, determinant_unit;

  constexpr std::size_t degrees_of_freedom() const noexcept { return translations + rotations; }
};

inline constexpr std::array<TaskSpaceTraits, 8> all_task_space_traits{
    {{"T1", 1, 0, true, 200.0, "m", "m"},
     {"T2", 2, 0, true, 200.0, "m^2", "m^2"},
     {"SE2", 2, 1, true, 50.0, "m^2 rad", "m^4"},
     {"T3", 3, 0, false, 50.0, "m^3", "m^3"},
     {"SO3", 0, 3, false, 0.0, "rad^3", "m^6"},
     {"SE3", 3, 3, false, 0.0, "m^3 rad^3", "m^9"},
     {"R1", 0, 1, false, 0.0, "rad", "m^2"},
     {"R2", 0, 2, false, 0.0, "rad^2", "m^4"}}};

constexpr const TaskSpaceTraits& traits(TaskSpace space) noexcept {
  return all_task_space_traits[static_cast<std::size_t>(space)];
}

/// See `has_hinges`.
constexpr bool is_of_hinges(TaskSpace space) noexcept {
  return space == TaskSpace::R1 || space == TaskSpace::R2;
}

/// A task space as a type, whose `value` is known at compile time.
template <TaskSpace space>
using TaskSpaceConstant = std::integral_constant<TaskSpace, space>;

/// Calls a function with the TaskSpaceConstant of this task space.
template <class Function>
decltype(auto) with_task_space(TaskSpace space, const Function& function) {
  switch (space) {
    case TaskSpace::T1:
      return function(TaskSpaceConstant<TaskSpace::T1>());
    case TaskSpace::T2:
      return function(TaskSpaceConstant<TaskSpace::T2>());
    case TaskSpace::SE2:
      return function(TaskSpaceConstant<TaskSpace::SE2>());
    case TaskSpace::T3:
      return function(TaskSpaceConstant<TaskSpace::T3>());
    case TaskSpace::SO3:
      return function(TaskSpaceConstant<TaskSpace::SO3>());
    case TaskSpace::R1:
      return function(TaskSpaceConstant<TaskSpace::R1>());
    case TaskSpace::R2:
      return function(TaskSpaceConstant<TaskSpace::R2>());
    case TaskSpace::SE3:
      break;
  }
  return function(TaskSpaceConstant<TaskSpace::SE3>());
}

/// Where an anchor is, as far as a row of A asks: b, from the operational point; and in R2, which alone reads
/// them, the anchor itself and the axis of the second hinge (the z axis of the platform), in the task frame.
template <class Vector>
struct Lever {
  Vector arm, point, axis;
};

template <class Vector>
const Vector& arm_of(const Vector& b) {
  return b;
}

template <class Vector>
const Vector& arm_of(const Lever<Vector>& lever) {
  return lever.arm;
}

/// Writes the row of A of a leg: the moment b x u, as far as the platform turns, then u, as far as it moves
/// away. In R2 the moments are those about the axes of both hinges, and b has to be a `Lever`. b is not read
/// where the platform does not turn. The row is linear in u = p - c: give a multiple of u, or one part of a
/// sum. Entries: numbers or enclosures.
template <TaskSpace space, class Arm, class Link, class Row>
void write_row(const Arm& b, const Link& u, Row& row) {
  constexpr TaskSpaceTraits of = traits(space);
  [[maybe_unused]] const auto moment = [&u](const auto& of_arm, std::size_t i, std::size_t k) {
    return of_arm[i] * u[k] - of_arm[k] * u[i];
  };
  if constexpr (space == TaskSpace::R2) {
    row[0] = moment(b.point, 0, 1);
    row[1] =
        b.axis[0] * moment(b.arm, 1, 2) + b.axis[1] * moment(b.arm, 2, 0) + b.axis[2] * moment(b.arm, 0, 1);
  } else {
    if constexpr (of.rotations == 3) {
      row[0] = moment(arm_of(b), 1, 2);
      row[1] = moment(arm_of(b), 2, 0);
    }
    if constexpr (of.rotations > 0) row[of.rotations - 1] = moment(arm_of(b), 0, 1);
    for (std::size_t i = 0; i < of.translations; ++i) row[of.rotations + i] = u[i];
  }
}

/// The same; the row must hold as many entries as the task space has degrees of freedom.
template <class Vector, class Link, class Row>
void write_row(TaskSpace space, const Lever<Vector>& b, const Link& u, Row& row) {
  with_task_space(space, [&](auto constant) { write_row<decltype(constant)::value>(b, u, row); });
}

/// Of a point of the platform that is at `arm` from the operational point of this pose.
inline Lever<Eigen::Vector3d> lever_at(const Pose& pose, const Eigen::Vector3d& arm) {
  return {arm, pose.position + arm, pose.orientation * Eigen::Vector3d::UnitZ()};
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_TASK_SPACE_TRAITS_H
