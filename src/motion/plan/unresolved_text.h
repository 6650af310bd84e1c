// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_UNRESOLVED_TEXT_H
#define PARALLEL_ASPECTS_MOTION_PLAN_UNRESOLVED_TEXT_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <string>

namespace parallel_aspects {

/// What the map leaves open of two aspects, by their ids, that are not resolved: where they meet, and what is
/// nearly singular there. Sentences that describe; nothing in them is proved.
std::string unresolved_text(const AspectMap& map, int first, int second, const MapControl& control = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_UNRESOLVED_TEXT_H
