// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_UNIQUENESS_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_UNIQUENESS_REPORT_H

#include "parallel_aspects/aspects/uniqueness.h"
#include "tools/report/report.h"

namespace parallel_aspects::tools {

/// `aspects uniqueness`: aspects, cusps and uniqueness domains.
Report report_uniqueness(const Uniqueness& uniqueness);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_UNIQUENESS_REPORT_H
