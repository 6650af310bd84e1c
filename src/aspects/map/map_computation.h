// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_MAP_COMPUTATION_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_MAP_COMPUTATION_H

#include "aspects/components/component_policy.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <memory>

namespace parallel_aspects {

/// The same as the public one, by a policy of one's own: for measuring what each part of it is good for.
MapResult compute_aspect_map(std::shared_ptr<const Manipulator> manipulator, const MapOptions& options,
                             const MapControl& control, const ComponentPolicy& policy);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_MAP_COMPUTATION_H
