// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_contents.h"
#include "distance/singular_leaves.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/model/problems.h"

#include <utility>

namespace parallel_aspects {

DistanceMap::DistanceMap(std::shared_ptr<const AspectMap> map, const MapControl& control)
    : map_(std::move(map)) {
  if (!map_) throw InvalidDescription({"There is no map that distances could ask; compute one first."});
  if (map_->slice())
    throw InvalidDescription(
        {"Distances cannot ask the map of a slice, which does not show what is beside it; measure without a "
         "map, or compute that of all poses."});
  leaves_ = std::make_unique<const SingularLeaves>(map_->contents(), control);
}

DistanceMap::~DistanceMap() = default;

}  // namespace parallel_aspects
