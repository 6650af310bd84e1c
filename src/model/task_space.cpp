// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/task_space.h"

#include <algorithm>
#include <array>

namespace parallel_aspects {
namespace {

struct Traits {
  TaskSpace space;
  std::string_view name;
  std::size_t degrees_of_freedom;
  bool translation;
  bool rotation;
  std::string_view measure_unit;
};

constexpr std::array<Traits, 6> all_traits{{{TaskSpace::T1, "T1", 1, true, false, "m"},
                                            {TaskSpace::T2, "T2", 2, true, false, "m^2"},
                                            {TaskSpace::SE2, "SE2", 3, true, true, "m^2 rad"},
                                            {TaskSpace::T3, "T3", 3, true, false, "m^3"},
                                            {TaskSpace::SO3, "SO3", 3, false, true, "rad^3"},
                                            {TaskSpace::SE3, "SE3", 6, true, true, "m^3 rad^3"}}};

constexpr const Traits& traits(TaskSpace space) noexcept {
  return all_traits[static_cast<std::size_t>(space)];
}

}  // namespace

std::size_t degrees_of_freedom(TaskSpace space) noexcept { return traits(space).degrees_of_freedom; }

std::string_view name(TaskSpace space) noexcept { return traits(space).name; }

std::optional<TaskSpace> task_space_named(std::string_view text) noexcept {
  const auto found = std::find_if(all_traits.begin(), all_traits.end(),
                                  [text](const Traits& each) { return each.name == text; });
  return found == all_traits.end() ? std::nullopt : std::optional<TaskSpace>(found->space);
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

std::size_t rotational_degrees_of_freedom(TaskSpace space) noexcept {
  if (!has_rotation(space)) return 0;
  return space == TaskSpace::SE2 ? 1 : 3;
}

bool has_rotation(TaskSpace space) noexcept { return traits(space).rotation; }

bool has_translation(TaskSpace space) noexcept { return traits(space).translation; }

std::string_view measure_unit(TaskSpace space) noexcept { return traits(space).measure_unit; }

}  // namespace parallel_aspects
