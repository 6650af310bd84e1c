// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_SERIAL_MARGIN_H
#define PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_SERIAL_MARGIN_H

#include "parallel_aspects/model/manipulator.h"

namespace parallel_aspects {

/// Every gate of B_jj = 0 violates it.
inline bool has_serial_margin(const Manipulator& robot) { return robot.constraints().margins.serial > 0.0; }

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_SERIAL_MARGIN_H
