// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/leaf_graph.h"

#include "parallel_aspects/aspects/face_traversal.h"
#include "parallel_aspects/aspects/interval.h"
#include "parallel_aspects/aspects/segment_proof.h"

#include <algorithm>

namespace parallel_aspects {
namespace {

bool same_sign_inside(LeafState a, LeafState b) { return a.is_inside() && a == b; }

}  // namespace

LeafGraph::LeafGraph(const PoseTree& tree, std::size_t mode) : mode_(mode) {
  slot_.resize(tree.node_count(), none);
  for (NodeIndex node = 0; node < tree.node_count(); ++node) add_leaf(tree, node);
  visit_faces(tree, mode, [this, &tree](NodeIndex a, NodeIndex b) { connect(tree, a, b); });
}

void LeafGraph::add_leaf(const PoseTree& tree, NodeIndex node) {
  const LeafState state = tree.state(node, mode_);
  if (state.is_inside()) {
    slot_[node] = components_.add();
    inside_leaves_.push_back(node);
  } else if (state.is_undecided()) {
    slot_[node] = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back({node, {}, {}});
  }
}

void LeafGraph::connect(const PoseTree& tree, NodeIndex a, NodeIndex b) {
  if (a == b) return;  // glued to itself
  const LeafState state_a = tree.state(a, mode_), state_b = tree.state(b, mode_);
  if (same_sign_inside(state_a, state_b)) return components_.unite(slot_[a], slot_[b]);
  if (state_a.is_undecided() && slot_[b] != none) vertices_[slot_[a]].neighbours.push_back(b);
  if (state_b.is_undecided() && slot_[a] != none) vertices_[slot_[b]].neighbours.push_back(a);
}

void LeafGraph::compare(std::uint32_t v, std::uint32_t w, NodeIndex leaf, NodeIndex other, Meeting& meeting) {
  if (component(leaf) != component(other)) meeting.contacts.push_back({v, w, leaf, other});
}

std::vector<std::uint32_t> LeafGraph::start_from_components(const PoseTree& tree, int sign,
                                                            Meeting& meeting) {
  std::vector<std::uint32_t> queue;
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    const Vertex& vertex = vertices_[v];
    if (vertex.node == no_node || !tree.state(vertex.node, mode_).may_be(sign)) continue;
    for (const NodeIndex neighbour : vertex.neighbours) {
      if (!tree.state(neighbour, mode_).is_inside(sign)) continue;
      if (meeting.nearest[v] == no_node) {
        meeting.nearest[v] = neighbour;
        queue.push_back(v);
      } else {
        compare(v, v, meeting.nearest[v], neighbour, meeting);
      }
    }
  }
  return queue;
}

void LeafGraph::spread(const PoseTree& tree, int sign, std::vector<std::uint32_t> queue, Meeting& meeting) {
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::uint32_t v = queue[head];
    for (const NodeIndex neighbour : vertices_[v].neighbours) {
      const LeafState state = tree.state(neighbour, mode_);
      if (!state.is_undecided() || !state.may_be(sign)) continue;
      const std::uint32_t w = slot_[neighbour];
      if (meeting.nearest[w] == no_node) {
        meeting.nearest[w] = meeting.nearest[v];
        queue.push_back(w);
      } else if (v < w) {
        compare(v, w, meeting.nearest[v], meeting.nearest[w], meeting);
      }
    }
  }
}

LeafGraph::Meeting LeafGraph::meeting(const PoseTree& tree, int sign) {
  Meeting meeting;
  meeting.nearest.assign(vertices_.size(), no_node);
  spread(tree, sign, start_from_components(tree, sign, meeting), meeting);
  for (std::uint32_t v = 0; v < vertices_.size(); ++v)
    if (meeting.nearest[v] == no_node && vertices_[v].node != no_node &&
        tree.state(vertices_[v].node, mode_).may_be(sign))
      meeting.hidden.push_back(v);
  return meeting;
}

int LeafGraph::center_sign(const PoseTree& tree, const BoxClassifier& classifier, std::uint32_t vertex) {
  Vertex& asked = vertices_[vertex];
  if (!asked.center_sign) {
    const MapPosition center{tree.place(asked.node).root, tree.box(asked.node).middle()};
    asked.center_sign = proved_sign(classifier, tree.dimension(), mode_, center);
  }
  return *asked.center_sign;
}

void LeafGraph::find_center_signs(const PoseTree& tree, const BoxClassifier& classifier) {
  const RoundingUpward rounding;
  for (std::uint32_t vertex = 0; vertex < vertices_.size(); ++vertex) center_sign(tree, classifier, vertex);
}

void LeafGraph::refine(PoseTree& tree, const BoxClassifier& classifier, std::uint32_t vertex) {
  const NodeIndex node = vertices_[vertex].node;
  const NodeIndex first = tree.divide(node, [this](std::size_t mode) { return mode == mode_; });
  slot_.resize(tree.node_count(), none);
  std::vector<NodeIndex> children;
  {
    const RoundingUpward rounding;
    for (NodeIndex child = first; child < first + tree.children_per_node(); ++child) {
      classifier.classify(tree.place(child).root, tree.box(child), ModeSet{1} << mode_, tree.states(child));
      add_leaf(tree, child);
      children.push_back(child);
    }
  }
  const auto neighbours = std::move(vertices_[vertex].neighbours);
  vertices_[vertex] = {};
  for (std::size_t i = 0; i < children.size(); ++i)
    for (std::size_t j = i + 1; j < children.size(); ++j)
      if (share_face(tree, children[i], children[j])) connect(tree, children[i], children[j]);
  for (const NodeIndex neighbour : neighbours) replace(tree, node, children, neighbour);
}

void LeafGraph::replace(const PoseTree& tree, NodeIndex old_node, const std::vector<NodeIndex>& children,
                        NodeIndex neighbour) {
  if (tree.state(neighbour, mode_).is_undecided()) {
    auto& list = vertices_[slot_[neighbour]].neighbours;
    list.erase(std::remove(list.begin(), list.end(), old_node), list.end());
  }
  for (const NodeIndex child : children)
    if (share_face(tree, child, neighbour)) connect(tree, child, neighbour);
}

}  // namespace parallel_aspects
