// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_CONES_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_CONES_REPORT_H

#include "parallel_aspects/model/manipulator.h"
#include "tools/report/report.h"

namespace parallel_aspects::tools {

/// The cones that the rods of a manipulator must stay in, those of universal joints among them: a list, and
/// a line each, or where it is not `verbose` one for all of the same angle.
Report report_cones(const Manipulator& manipulator, bool verbose);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_CONES_REPORT_H
