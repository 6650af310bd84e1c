// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_CHECK_DRAWING_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_CHECK_DRAWING_H

#include "tools/motion_report/check_table.h"

#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// The samples of a check over time as SVG: the indices, the distances where there are any, and lines at the
/// crossings.
std::string draw_check(const Manipulator& manipulator, const TrajectoryCheck& check,
                       const std::vector<SampleDistances>& distances);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_CHECK_DRAWING_H
