// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_PART_OF_CONTROL_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_PART_OF_CONTROL_H

#include "parallel_aspects/aspects/map_control.h"

namespace parallel_aspects {

/// Of a part of a computation, which takes it from one share done to another. `control` must outlive it.
inline MapControl part_of(const MapControl& control, double from, double to) {
  MapControl part;
  part.cancelled = control.cancelled;
  if (control.progress)
    part.progress = [&control, from, to](double share) { control.progress(from + share * (to - from)); };
  return part;
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_PART_OF_CONTROL_H
