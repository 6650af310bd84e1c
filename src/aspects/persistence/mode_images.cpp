// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/persistence/mode_images.h"

#include "aspects/symmetry/map_symmetry.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

/// Compares one mode with what a symmetry makes of another.
class Comparison {
 public:
  Comparison(const AspectMap::Contents& map, const MapSymmetry& symmetry, std::size_t from, std::size_t to)
      : map_(map), symmetry_(symmetry), from_(from), to_(to) {}

  /// Aspects of the second mode by those of the first; nothing where they differ.
  std::optional<std::map<int, int>> aspects() {
    for (RootIndex root = 0; root < map_.tree.root_count(); ++root)
      if (!is_image(root, symmetry_.poses.image(root))) return std::nullopt;
    std::set<int> images;
    for (const auto& [aspect, image] : aspects_)
      if (!images.insert(image).second) return std::nullopt;
    const std::set<std::pair<int, int>> pairs(map_.unresolved.begin(), map_.unresolved.end());
    for (const auto& [a, b] : pairs) {
      if (aspects_.count(a) == 0) continue;
      const auto [low, high] = std::minmax(aspects_.at(a), aspects_.at(b));
      if (pairs.count({low, high}) == 0) return std::nullopt;
    }
    return aspects_;
  }

 private:
  bool is_image(NodeIndex node, NodeIndex image) {
    const PoseTree& tree = map_.tree;
    const LeafState state = tree.state(node, from_);
    if (!(symmetry_.image(state) == tree.state(image, to_))) return false;
    const int aspect = map_.leaf_aspect(node, from_), other = map_.leaf_aspect(image, to_);
    if ((aspect == 0) != (other == 0)) return false;
    if (aspect != 0 && aspects_.try_emplace(aspect, other).first->second != other) return false;
    if (!state.is_divided()) return true;
    for (NodeIndex rank = 0; rank < tree.children_per_node(); ++rank)
      if (!is_image(tree.first_child(node) + rank,
                    tree.first_child(image) + symmetry_.poses.image_rank(tree.place(node).root, rank)))
        return false;
    return true;
  }

  const AspectMap::Contents& map_;
  const MapSymmetry& symmetry_;
  std::size_t from_, to_;
  std::map<int, int> aspects_;
};

}  // namespace

std::vector<ModeImage> find_mode_images(const AspectMap::Contents& map) {
  std::vector<ModeImage> images(map.modes.size());
  for (std::size_t mode = 0; mode < images.size(); ++mode) images[mode].representative = mode;
  if (map.slice) return images;
  const std::vector<MapSymmetry> symmetries =
      find_map_symmetries(*map.manipulator, map.tree.region(), map.modes);
  const std::vector<ModeSource> sources = find_mode_sources(symmetries, images.size());
  for (std::size_t mode = 0; mode < images.size(); ++mode) {
    const auto& [representative, symmetry] = sources[mode];
    if (symmetry == nullptr) continue;
    if (auto aspects = Comparison(map, *symmetry, representative, mode).aspects())
      images[mode] = {representative, std::move(*aspects)};
  }
  return images;
}

}  // namespace parallel_aspects
