// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_UNIQUENESS_JSON_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_UNIQUENESS_JSON_H

#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/model/manipulator.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>

namespace parallel_aspects::tools {

bool has_modes(const Manipulator& robot);

/// Whether basic components are of several working modes at once.
bool are_of_all_modes(const Uniqueness& uniqueness);

/// Index of the basic component that a basic region lies over; nothing where that is not proved, or where
/// basic components are of several working modes at once and a region lies over more than one.
std::optional<std::size_t> component_below(const Uniqueness& uniqueness, const BasicRegion& region);

nlohmann::json json_cusp(const Manipulator& robot, const Cusp& cusp);
nlohmann::json json_numbers_of_solutions(const Manipulator& robot, const SolutionNumbers& numbers);

/// All but the constraints.
nlohmann::json json_uniqueness(const Uniqueness& uniqueness);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_UNIQUENESS_JSON_H
