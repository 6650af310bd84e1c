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
  std::size_t rotations;     ///< 1: about z; 3: all. They come first in a twist and in the columns of A.
  bool planar;               ///< whether legs and platform stay in the x-y plane
  double resolution_parts;   ///< of the robot's size in the default resolution; 0 where that is an angle
  std::string_view measure_unit, determinant_unit;

  constexpr std::size_t degrees_of_freedom() const noexcept { return translations + rotations; }
};

inline constexpr std::array<TaskSpaceTraits, 6> all_task_space_traits{
    {{"T1", 1, 0, true, 200.0, "m", "m"},
     {"T2", 2, 0, true, 200.0, "m^2", "m^2"},
     {"SE2", 2, 1, true, 50.0, "m^2 rad", "m^4"},
     {"T3", 3, 0, false, 50.0, "m^3", "m^3"},
     {"SO3", 0, 3, false, 0.0, "rad^3", "m^6"},
     {"SE3", 3, 3, false, 0.0, "m^3 rad^3", "m^9"}}};

constexpr const TaskSpaceTraits& traits(TaskSpace space) noexcept {
  return all_task_space_traits[static_cast<std::size_t>(space)];
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
    case TaskSpace::SE3:
      break;
  }
  return function(TaskSpaceConstant<TaskSpace::SE3>());
}

/// Writes the row of A of a leg: the moment b x u, as far as the platform turns, then u, as far as it moves
/// away. b is the anchor seen from the operational point; it is not read where the platform does not turn.
/// The row is linear in u = p - c: give a multiple of u, or one part of a sum. Entries: numbers or
/// enclosures.
template <TaskSpace space, class Arm, class Link, class Row>
void write_row(const Arm& b, const Link& u, Row& row) {
  constexpr TaskSpaceTraits of = traits(space);
  [[maybe_unused]] const auto moment = [&b, &u](std::size_t i, std::size_t k) {
    return b[i] * u[k] - b[k] * u[i];
  };
  if constexpr (of.rotations == 3) {
    row[0] = moment(1, 2);
    row[1] = moment(2, 0);
  }
  if constexpr (of.rotations > 0) row[of.rotations - 1] = moment(0, 1);
  for (std::size_t i = 0; i < of.translations; ++i) row[of.rotations + i] = u[i];
}

/// The same; the row must hold as many entries as the task space has degrees of freedom.
template <class Arm, class Link, class Row>
void write_row(TaskSpace space, const Arm& b, const Link& u, Row& row) {
  with_task_space(space, [&](auto constant) { write_row<decltype(constant)::value>(b, u, row); });
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_TASK_SPACE_TRAITS_H
