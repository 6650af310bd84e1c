// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_MAP_PLAN_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_MAP_PLAN_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/symmetry/map_symmetry.h"
#include "aspects/tree/pose_space.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The `exact_region` of positions; where one about the middle of the legs is next to nothing larger, and
/// more symmetries of the manipulator take it onto itself, that one, whose corners are as exact. Else
/// symmetries about any other point than the origin would hang on how its coordinates are rounded. `exact`:
/// the `exact_region` of `positions`.
Box symmetric_region(const Manipulator& manipulator, const Box& positions, const Box& exact);

/// All that a map follows from: the options with every default filled in, and how boxes are proved.
struct MapPlan {
  std::vector<WorkingMode> modes;
  std::optional<MapSlice> slice;
  std::unique_ptr<const BoxClassifier> classifier;
  std::shared_ptr<const PoseSpace> space;
  std::vector<MapSymmetry> symmetries;  ///< that are used
  double resolution = 0.0;              ///< longest edge of a base leaf [m or rad]
  std::uint32_t depth = 0;              ///< level of the finest leaves of the base map
  std::uint32_t deepest_level = 0;      ///< of contested leaves
  bool complete = false;                ///< see `MapOptions`
};

/// Fills `plan`; the message says why that cannot be, and is empty otherwise.
std::string make_map_plan(const Manipulator& manipulator, const MapOptions& options, MapPlan& plan,
                          const BoxPolicy& policy = {});

/// What of these positions, in the coordinates that a map of all poses or of the slice has, is in the
/// workspace of the constraints; nothing where nothing bounds them.
std::optional<Box> within_workspace(std::optional<Box> positions, const Manipulator& manipulator,
                                    const std::optional<MapSlice>& slice);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_MAP_PLAN_H
