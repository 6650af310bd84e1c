// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_UNIQUENESS_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_UNIQUENESS_REPORT_H

#include "parallel_aspects/aspects/uniqueness.h"
#include "tools/report/report.h"

namespace parallel_aspects::tools {

/// `aspects uniqueness`: aspects, cusps and uniqueness domains.
Report report_uniqueness(const Uniqueness& uniqueness);

/// The same of a slice of SO3: cusps, and numbers of direct solutions.
Report report_cusps(const Manipulator& robot, const HeldJoint& held, const CuspList& found,
                    const SolutionNumbers& numbers);

/// `aspects uniqueness --cusps-over`: curves of cusps.
Report report_cusp_curves(const Manipulator& robot, const CuspCurves& found);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_UNIQUENESS_REPORT_H
