// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_MAP_CONTENTS_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_MAP_CONTENTS_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/components/leaf_numbers.h"
#include "aspects/tree/near_leaves.h"
#include "aspects/tree/pose_space.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace parallel_aspects {

struct AspectGraph;

/// Everything that an `AspectMap` shows; written by the computation, then never changed but for the graph.
struct AspectMap::Contents {
  Contents(std::shared_ptr<const Manipulator> robot, std::unique_ptr<const BoxClassifier> box_classifier,
           PoseTree pose_tree, std::vector<WorkingMode> all_modes)
      : manipulator(std::move(robot)),
        classifier(std::move(box_classifier)),
        tree(std::move(pose_tree)),
        modes(std::move(all_modes)) {}

  std::shared_ptr<const Manipulator> manipulator;
  std::unique_ptr<const BoxClassifier> classifier;
  PoseTree tree;
  std::vector<WorkingMode> modes;  ///< of the tree, in its order
  std::optional<MapSlice> slice;
  std::vector<WorkingMode> existing_modes;  ///< those with an inside leaf
  std::vector<NodeNumbers> leaf_aspects;    ///< ids of inside leaves, by mode
  std::vector<Aspect> aspects;
  std::vector<std::vector<Box>>
      aspect_bounds;  ///< of the inside leaves, by id - 1 and root, in map coordinates
  std::vector<std::pair<int, int>> unresolved;
  std::size_t proved_count = 0;
  std::size_t indeterminate_leaves = 0;  ///< see `ModeComponents`, over all modes
  std::size_t bound = 0;  ///< likewise; of the number of aspects, unless there are indeterminate leaves
  double resolution = 0.0;
  std::uint32_t depth = 0;          ///< level of the finest leaves of the base map
  std::uint32_t deepest_level = 0;  ///< that contested leaves may have
  bool complete = false;            ///< see `MapOptions`
  double measure_undecided = 0.0;
  double seconds = 0.0;
  std::optional<SymmetryUse> symmetry_use;  ///< not kept in files

  /// Once it was asked for; it follows from the rest. Only `std::atomic_load` and `std::atomic_store` touch
  /// it, since threads share the map.
  mutable std::shared_ptr<const AspectGraph> graph;

  /// 0 where the leaf is not inside.
  int leaf_aspect(NodeIndex node, std::size_t mode) const noexcept {
    const std::uint32_t id = leaf_aspects[mode][node];
    return id == NodeNumbers::none ? 0 : static_cast<int>(id);
  }
};

/// Where a working mode stands in the map; nothing where it is not mapped.
std::optional<std::size_t> mode_index(const AspectMap::Contents& map, const WorkingMode& mode) noexcept;

/// See AspectMap::locate. Neither allocates nor throws.
Location locate(const AspectMap::Contents& map, std::size_t mode, const MapPosition& position) noexcept;

/// The same where `proved_sign` is known already of the position.
Location locate(const AspectMap::Contents& map, std::size_t mode, const MapPosition& position,
                int proved_sign) noexcept;

/// Whether two aspects, by their ids, are one or not yet proved to be two.
bool may_be_one(const AspectMap& map, int first, int second);

/// A map of which many positions are to be located.
struct MarkedMap {
  const AspectMap::Contents& map;
  InsideMarks marks;

  explicit MarkedMap(const AspectMap::Contents& of) : map(of), marks(of.tree) {}
};

/// As `locate` of the map, sooner; nothing where the sign of det A at the position is not known yet.
Location locate(const MarkedMap& map, std::size_t mode, const MapPosition& position,
                std::optional<int> proved_sign = std::nullopt) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_MAP_CONTENTS_H
