// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_SLICE_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_SLICE_REPORT_H

#include "parallel_aspects/aspects/map_slice.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace parallel_aspects::tools {

/// {"held", "axis", "free"}: what is held and what is free; null where there is no slice.
nlohmann::json json_slice(const std::optional<MapSlice>& slice);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_SLICE_REPORT_H
