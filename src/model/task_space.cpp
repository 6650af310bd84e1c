// SPDX-License-Identifier: BSD-3-Clause
#include "model/task_space_traits.h"

namespace parallel_aspects {

std::size_t degrees_of_freedom(TaskSpace space) noexcept { return traits(space).degrees_of_freedom(); }

std::string_view name(TaskSpace space) noexcept { return traits(space).name; }

std::optional<TaskSpace> task_space_named(std::string_view text) noexcept {
  for (std::size_t i = 0; i < all_task_space_traits.size(); ++i)
    if (all_task_space_traits[i].name == text) return static_cast<TaskSpace>(i);
  return std::nullopt;
}

const std::vector<std::string>& coordinate_names(TaskSpace space) {
  static const std::array<std::vector<std::string>, 6> names{{{"x"},
                                                              {"x", "y"},
                                                              {"x", "y", "phi"},
                                                              {"x", "y", "z"},
                                                              {"qx", "qy", "qz", "qw"},
                                                              {"x", "y", "z", "qx", "qy", "qz", "qw"}}};
  return names[static_cast<std::size_t>(space)];
}

std::size_t rotational_degrees_of_freedom(TaskSpace space) noexcept { return traits(space).rotations; }

bool has_rotation(TaskSpace space) noexcept { return traits(space).rotations > 0; }

bool has_translation(TaskSpace space) noexcept { return traits(space).translations > 0; }

std::string_view measure_unit(TaskSpace space) noexcept { return traits(space).measure_unit; }

}  // namespace parallel_aspects
