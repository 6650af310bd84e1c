// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_CHOICE_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_CHOICE_REPORT_H

#include "parallel_aspects/ask/choose.h"
#include "tools/report/report.h"

namespace parallel_aspects::tools {

/// `aspects choose`: in which working modes a path or a region can be done, the best first.
Report report_choice(const Manipulator& robot, const ask::ChooseAnswer& answer);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_CHOICE_REPORT_H
