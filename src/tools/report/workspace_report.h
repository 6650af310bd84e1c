// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_WORKSPACE_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_WORKSPACE_REPORT_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/regular_workspace.h"
#include "tools/report/report.h"

#include <vector>

namespace parallel_aspects::tools {

/// The largest of them that is proved; null where none is larger than 0.
const RegularWorkspace* best_of(const std::vector<RegularWorkspace>& workspaces);

/// `aspects workspace`: the largest regular shape in each aspect, and the best.
Report report_workspaces(const AspectMap& map, const WorkspaceQuestion& question,
                         const std::vector<RegularWorkspace>& workspaces, double gap);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_WORKSPACE_REPORT_H
