// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_TASK_SPACE_TRAITS_H
#define PARALLEL_ASPECTS_MODEL_TASK_SPACE_TRAITS_H

#include "parallel_aspects/model/task_space.h"

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_TASK_SPACE_TRAITS_H
