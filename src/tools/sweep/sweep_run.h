// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_RUN_H
#define PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_RUN_H

#include "tools/sweep/sweep_file.h"
#include "tools/sweep/sweep_plan.h"

#include <cstddef>
#include <functional>

namespace parallel_aspects::tools {

/// Reported while rows are written: how many of this shard there are, and how many there will be.
using SweepProgress = std::function<void(std::size_t rows, std::size_t of)>;

/// Computes the rows that the file does not have, one thread a design, and adds each in its turn. Ends soon
/// after it is cancelled, and then leaves those rows out that are not finished.
void run_sweep(const SweepPlan& plan, const Shard& shard, unsigned threads, const MapControl& control,
               const SweepProgress& progress, SweepFile& file);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_RUN_H
