// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_BASINS_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_BASINS_REPORT_H

#include "parallel_aspects/aspects/connectivity.h"
#include "tools/report/report.h"

#include <string>

namespace parallel_aspects::tools {

/// "0.93 to 0.95", or one number where the two are shown alike.
std::string shown_range(const IndexRange& range);

/// "parallel index" or "|det A|".
std::string index_name(ParallelIndex index);

/// The pairs that could be one of which something is known, and how many others there are.
std::string pairs_text(const AspectMap& map, const MapBasins& basins);

/// `aspects map --persistence`: the basins of each aspect, as a table with bars.
std::string persistence_text(const AspectMap& map, const MapBasins& basins);

/// `aspects connect`: the largest index that a path can keep.
std::string bottleneck_text(ParallelIndex index, const Bottleneck& bottleneck);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_BASINS_REPORT_H
