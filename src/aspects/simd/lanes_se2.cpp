// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/simd/chart_lanes_code.h"

namespace parallel_aspects {

template struct ChartLanes<SE2Chart>;

}  // namespace parallel_aspects
