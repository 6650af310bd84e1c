// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_computation.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <utility>

namespace parallel_aspects {

MapResult compute_complete_map(std::shared_ptr<const Manipulator> manipulator, const MapOptions& options,
                               const MapControl& control) {
  ComponentPolicy policy;
  policy.completes = true;
  return compute_aspect_map(std::move(manipulator), options, control, policy);
}

}  // namespace parallel_aspects
