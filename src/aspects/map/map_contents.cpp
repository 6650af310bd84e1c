// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_contents.h"

#include "aspects/boxes/segment_proof.h"
#include "aspects/tree/near_leaves.h"
#include "interval/interval.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace parallel_aspects {
namespace {

// In an undecided leaf: the aspect that a proved segment joins the point to.
Location locate_by_proof(const AspectMap::Contents& map, std::size_t mode, const MapPosition& position,
                         std::optional<int> known_sign, const InsideMarks* marks) noexcept {
  const RoundingUpward rounding;
  const std::size_t dimension = map.tree.dimension();
  const int sign = known_sign ? *known_sign : proved_sign(*map.classifier, dimension, mode, position);
  if (sign == 0) return {LocationStatus::undecided, 0};
  const NearLeaves near = near_inside_leaves(map.tree, mode, sign, position, marks);
  for (std::size_t i = 0; i < near.count; ++i) {
    const NodeIndex leaf = near.items[i].leaf;
    const MapPoint target = map.tree.box(leaf).nearest(position.point);
    if (segment_is_free(*map.classifier, dimension, mode, sign, position, target))
      return {LocationStatus::inside, map.leaf_aspect(leaf, mode)};
  }
  return {LocationStatus::undecided, 0};
}

Location locate_with(const AspectMap::Contents& map, std::size_t mode, const MapPosition& position,
                     std::optional<int> known_sign, const InsideMarks* marks) noexcept {
  const auto leaf = map.tree.leaf_at(position, mode);
  if (!leaf) return {LocationStatus::not_mapped, 0};
  const LeafState state = map.tree.state(*leaf, mode);
  if (state.is_inside()) return {LocationStatus::inside, map.leaf_aspect(*leaf, mode)};
  if (!state.is_undecided()) return {LocationStatus::outside, 0};
  return locate_by_proof(map, mode, position, known_sign, marks);
}

}  // namespace

std::optional<std::size_t> mode_index(const AspectMap::Contents& map, const WorkingMode& mode) noexcept {
  const auto found = std::find(map.modes.begin(), map.modes.end(), mode);
  if (found == map.modes.end()) return std::nullopt;
  return static_cast<std::size_t>(found - map.modes.begin());
}

Location locate(const AspectMap::Contents& map, std::size_t mode, const MapPosition& position) noexcept {
  return locate_with(map, mode, position, std::nullopt, nullptr);
}

Location locate(const AspectMap::Contents& map, std::size_t mode, const MapPosition& position,
                int proved_sign) noexcept {
  return locate_with(map, mode, position, proved_sign, nullptr);
}

Location locate(const MarkedMap& map, std::size_t mode, const MapPosition& position,
                std::optional<int> proved_sign) noexcept {
  return locate_with(map.map, mode, position, proved_sign, &map.marks);
}

bool may_be_one(const AspectMap& map, int first, int second) {
  const std::vector<int>& unresolved = map.aspects()[static_cast<std::size_t>(first - 1)].unresolved_with;
  return first == second || std::find(unresolved.begin(), unresolved.end(), second) != unresolved.end();
}

}  // namespace parallel_aspects
