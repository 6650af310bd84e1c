// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_CHOICE_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_CHOICE_REPORT_H

#include "parallel_aspects/motion/choose_working_mode.h"
#include "tools/report/report.h"

namespace parallel_aspects::tools {

/// `aspects choose --path`: in which working modes a path can be done, the best first.
Report report_path_choice(const Manipulator& manipulator, const PathChoice& choice, Preference preference);

/// `aspects choose --path --changes`: adds how the path can be done with changes of posture.
void add_changes(const Manipulator& manipulator, const ChangingPath& path, Report& report);

/// `aspects choose --region`: in which working modes a region lies in one aspect.
Report report_region_choice(const Manipulator& manipulator, const RegionQuestion& question,
                            const RegionChoice& choice);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_CHOICE_REPORT_H
