// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_WORKSPACE_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_WORKSPACE_REPORT_H

#include "parallel_aspects/ask/workspace.h"
#include "tools/report/report.h"

namespace parallel_aspects::tools {

/// `aspects workspace`: the largest regular shape in each aspect, and the best.
Report report_workspaces(const ask::LargestShapeAnswer& answer);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_WORKSPACE_REPORT_H
