// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/mirrored_modes.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace parallel_aspects {
namespace {

/// A mode and the representative whose image it is.
struct ModePair {
  std::size_t representative, mode;
};

std::vector<ModePair> pairs_of(const MapSymmetry& symmetry, const std::vector<ModeSource>& sources) {
  std::vector<ModePair> pairs;
  for (std::size_t mode = 0; mode < sources.size(); ++mode)
    if (sources[mode].symmetry == &symmetry) pairs.push_back({sources[mode].representative, mode});
  return pairs;
}

/// Writes the states, and returns the image of each node that a representative has states at; `no_node` of
/// others.
std::vector<NodeIndex> mirror_states(PoseTree& tree, const MapSymmetry& symmetry,
                                     const std::vector<ModePair>& pairs) {
  const auto count = static_cast<NodeIndex>(tree.node_count());
  std::vector<NodeIndex> images(count, no_node);
  for (RootIndex root = 0; root < tree.root_count(); ++root) images[root] = symmetry.poses.image(root);
  for (NodeIndex node = 0; node < count; ++node) {
    const NodeIndex image = images[node];
    if (image == no_node) continue;
    bool is_divided = false;
    for (const ModePair& pair : pairs) {
      const LeafState state = tree.state(node, pair.representative);
      tree.state(image, pair.mode) = symmetry.image(state);
      is_divided = is_divided || state.is_divided();
    }
    if (!is_divided) continue;
    const NodeIndex first = tree.first_child(node), first_image = tree.add_children(image);
    for (NodeIndex rank = 0; rank < tree.children_per_node(); ++rank)
      images[first + rank] = first_image + symmetry.poses.image_rank(tree.place(node).root, rank);
  }
  return images;
}

Component mirrored(const Component& component, const MapSymmetry& symmetry,
                   const std::vector<NodeIndex>& images) {
  Component result = component;
  result.determinant_sign *= symmetry.determinant_sign;
  for (RootIndex root = 0; root < component.bounds.size(); ++root)
    result.bounds[symmetry.poses.image(root)] = symmetry.poses.image(root, component.bounds[root]);
  for (NodeIndex& leaf : result.leaves) leaf = images[leaf];
  return result;
}

ModeComponents mirrored(const ModeComponents& found, const MapSymmetry& symmetry,
                        const std::vector<NodeIndex>& images) {
  ModeComponents result = found;
  for (std::size_t i = 0; i < found.components.size(); ++i)
    result.components[i] = mirrored(found.components[i], symmetry, images);
  return result;
}

}  // namespace

void mirror_modes(PoseTree& tree, const std::vector<MapSymmetry>& symmetries,
                  const std::vector<ModeSource>& sources, std::vector<ModeComponents>& components) {
  for (const MapSymmetry& symmetry : symmetries) {
    const std::vector<ModePair> pairs = pairs_of(symmetry, sources);
    if (pairs.empty()) continue;
    const std::vector<NodeIndex> images = mirror_states(tree, symmetry, pairs);
    for (const ModePair& pair : pairs)
      components[pair.mode] = mirrored(components[pair.representative], symmetry, images);
  }
}

}  // namespace parallel_aspects
