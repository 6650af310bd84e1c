// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_ASSEMBLY_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_ASSEMBLY_REPORT_H

#include "motion/assembly_survey.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "tools/report/report.h"

namespace parallel_aspects::tools {

/// `aspects uniqueness` over a roadmap: which of its poses have the same actuated values as others of their
/// aspect.
Report report_assembly_survey(const PoseRoadmap& roadmap, const AssemblySurvey& survey);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_ASSEMBLY_REPORT_H
