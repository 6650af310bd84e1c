// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_DISTANCE_MAP_H
#define PARALLEL_ASPECTS_DISTANCE_DISTANCE_MAP_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_control.h"

#include <memory>

namespace parallel_aspects {

class SingularLeaves;

/// A map, made ready for `BoundaryDistanceMeter::use`: the parts of it that may hold a parallel singularity,
/// within limits or not, each with the plane that singularities in it lie near. Immutable; any number of
/// meters, of any threads, may use one. docs/distance.md says how long it takes to make and how large it is.
class DistanceMap {
 public:
  /// Looks into every leaf that is not inside an aspect, on all threads of the calling arena. Where `control`
  /// cancels it, it is not asked. Throws `InvalidDescription` for no map, and for that of a slice, which does
  /// not tell what is beside it.
  explicit DistanceMap(std::shared_ptr<const AspectMap> map, const MapControl& control = {});
  ~DistanceMap();
  DistanceMap(const DistanceMap&) = delete;
  DistanceMap& operator=(const DistanceMap&) = delete;

  const std::shared_ptr<const AspectMap>& map() const noexcept { return map_; }  ///< never null
  const SingularLeaves& leaves() const noexcept { return *leaves_; }             ///< what may be singular

 private:
  std::shared_ptr<const AspectMap> map_;
  std::unique_ptr<const SingularLeaves> leaves_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_DISTANCE_MAP_H
