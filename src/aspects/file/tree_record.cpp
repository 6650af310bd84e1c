// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/pose_tree.h"

#include <utility>

namespace parallel_aspects {

TreeRecord PoseTree::record() const {
  TreeRecord record;
  record.parents.resize((node_count() - root_count()) >> dimension());
  for (NodeIndex node = 0; node < node_count(); ++node)
    if (first_child(node) != no_node) record.parents[family(first_child(node))] = node;
  for (NodeIndex node = 0; node < node_count(); ++node)
    for (std::size_t mode = 0; mode < modes_; ++mode)
      if (!inherits(record.parents, node, mode)) record.states.push_back(state(node, mode).code());
  return record;
}

std::optional<PoseTree> PoseTree::from_record(std::shared_ptr<const PoseSpace> space, std::size_t modes,
                                              const TreeRecord& record) {
  PoseTree tree(std::move(space), modes);
  if (!tree.append_all_children(record.parents) || !tree.set_states(record)) return std::nullopt;
  return tree;
}

bool PoseTree::append_all_children(const std::vector<NodeIndex>& parents) {
  if (parents.size() > (no_node - root_count()) >> dimension()) return false;
  const std::size_t nodes = root_count() + (parents.size() << dimension());
  parents_.reserve(parents.size());
  first_child_.reserve(nodes);
  states_.reserve(nodes * modes_);
  for (const NodeIndex parent : parents) {
    if (parent >= node_count() || first_child(parent) != no_node) return false;
    if (place(parent).level >= deepest_level) return false;
    append_children(parent);
  }
  return true;
}

// Children come after their parents.
bool PoseTree::set_states(const TreeRecord& record) {
  auto next = record.states.begin();
  for (NodeIndex node = 0; node < node_count(); ++node)
    for (std::size_t mode = 0; mode < modes_; ++mode) {
      if (inherits(record.parents, node, mode)) continue;
      if (next == record.states.end()) return false;
      const std::optional<LeafState> known = LeafState::from_code(*next++);
      if (!known || (known->is_divided() && first_child(node) == no_node)) return false;
      state(node, mode) = *known;
    }
  return next == record.states.end();
}

}  // namespace parallel_aspects
