// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/sign_graph.h"

#include "aspects/boxes/part_proof.h"
#include "aspects/components/climb.h"
#include "aspects/simd/box_requests.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

// As many as the widest vectors have lanes.
constexpr std::size_t faces_at_once = 8;

/// Children share a face where their ranks differ along one coordinate.
constexpr bool is_power_of_two(std::size_t a) noexcept { return (a & (a - 1)) == 0; }

}  // namespace

void SignGraph::LeafCounts::add(NodeIndex node, LeafState state, int sign) noexcept {
  if (!state.may_be(sign)) return;
  ++(state.is_whole(sign) ? in_components : indeterminate);
  blocks += NodeNumbers::block_of(node) != last_block;
  last_block = NodeNumbers::block_of(node);
}

void SignGraph::reserve(const PoseTree& tree, const LeafCounts& counts) {
  slot_.reserve(tree.node_count(), counts.blocks);
  indeterminate_.reserve(counts.indeterminate);
  components_.reserve(counts.in_components);
  traits_.reserve(counts.in_components);
  new_leaves_.reserve(counts.in_components);
  members_.reserve(counts.in_components);
}

void SignGraph::add_leaf(NodeIndex node, LeafState state) {
  if (!state.may_be(sign_)) return;
  if (!state.is_whole(sign_)) {
    set_slot(node, LeafSlot::indeterminate(indeterminate_.add(node)));
    return;
  }
  add_member(node, {state.is_inside(sign_)});
  new_leaves_.push_back(node);
}

/// In a component of its own.
LeafSlot SignGraph::add_member(NodeIndex node, const Traits& traits) {
  const LeafSlot slot = LeafSlot::member(components_.add());
  set_slot(node, slot);
  traits_.push_back(traits);
  members_.push_back(node);
  return slot;
}

void SignGraph::take_in_proof(const PoseTree& tree, NodeIndex node) {
  const LeafSlot old = slot(node);
  if (!old.is_indeterminate()) return;
  indeterminate_.set_examined(old.item());
  if (tree.state(node, mode_).may_be(sign_) && !tree.state(node, mode_).is_whole(sign_)) return;
  const std::vector<LeafSlot> neighbours = indeterminate_.neighbours(old.item());
  for (const LeafSlot neighbour : neighbours) forget_neighbour(neighbour, old);
  indeterminate_.forget(old.item());
  set_slot(node, LeafSlot::nowhere());
  add_leaf(node, tree.state(node, mode_));
  for (const LeafSlot neighbour : neighbours) connect(tree, node, this->node(neighbour));
}

void SignGraph::unite(LeafSlot a, LeafSlot b) {
  const std::uint32_t one = current(a.place()), other = current(b.place());
  if (one == other) return;
  // The larger set decides whether contacts of both are worth work: one that was given up stays so when
  // crumbs join it, and a crumb that was given up is worth it again as part of a larger set that was not.
  const Traits &larger = traits_[traits_[one].leaves < traits_[other].leaves ? other : one],
               &smaller = traits_[&larger == &traits_[one] ? other : one];
  const Traits traits{larger.has_inside_leaf || smaller.has_inside_leaf, larger.climbed || smaller.climbed,
                      larger.is_given_up, larger.leaves + smaller.leaves};
  components_.unite(one, other);
  traits_[std::min(one, other)] = traits;  // the smallest member stands for a set, see `DisjointSets`
}

void SignGraph::connect(const PoseTree& tree, NodeIndex a, NodeIndex b) {
  const LeafSlot one = slot(a), other = slot(b);
  if (a == b || one.is_nowhere() || other.is_nowhere()) return;
  if (one.is_member() && other.is_member()) {
    // All of their common face is in the set where one of them is inside, so what the other holds meets it.
    const bool inside = tree.state(a, mode_).is_inside(sign_) || tree.state(b, mode_).is_inside(sign_);
    if (inside)
      unite(one, other);
    else
      faces_.emplace_back(a, b);
    return;
  }
  if (one.is_indeterminate()) indeterminate_.add_neighbour(one.item(), other);
  if (other.is_indeterminate()) indeterminate_.add_neighbour(other.item(), one);
}

void SignGraph::settle_faces(const PoseTree& tree, const BoxClassifier& classifier) {
  NodePairs faces;
  faces.swap(faces_);
  for (std::size_t next = 0; next < faces.size() && !is_cancelled(control_);)
    next = settle_some(tree, classifier, faces, next);
}

/// From the face `next` on; returns where to go on. Several are examined together, of which some may turn
/// out to lie between components that the others join.
std::size_t SignGraph::settle_some(const PoseTree& tree, const BoxClassifier& classifier,
                                   const NodePairs& faces, std::size_t next) {
  std::vector<SharedFace> shared;
  std::vector<std::pair<std::size_t, std::size_t>> ends;  // which face, and the end of what its nodes share
  for (; next < faces.size() && ends.size() < faces_at_once; ++next) {
    const auto [a, b] = faces[next];
    if (!are_apart(a, b)) continue;
    for (const SharedFace& each : shared_faces(tree, a, b)) shared.push_back(each);
    ends.emplace_back(next, shared.size());
  }
  const std::vector<Part> parts = find_parts(classifier, mode_, sign_, std::move(shared));
  std::size_t first = 0;
  for (const auto& [face, end] : ends) {
    settle(faces[face].first, faces[face].second, parts.data() + first, end - first);
    first = end;
  }
  return next;
}

// Both hold what the set has of a common face: one pose of it that is proved makes one of the two. Where all
// common faces are proved empty, the two are no neighbours.
void SignGraph::settle(NodeIndex a, NodeIndex b, const Part* parts, std::size_t count) {
  if (!are_apart(a, b)) return;
  bool known = true;
  for (std::size_t i = 0; i < count; ++i) {
    if (parts[i].kind == Part::Kind::connected && policy_.joins_across_faces) return unite(slot(a), slot(b));
    known = known && parts[i].kind == Part::Kind::empty;
  }
  if (!known) unknown_faces_.emplace_back(a, b);
}

void SignGraph::forget_neighbour(LeafSlot leaf, LeafSlot old_neighbour) {
  if (leaf.is_indeterminate()) indeterminate_.remove_neighbour(leaf.item(), old_neighbour);
}

void SignGraph::replace(PoseTree& tree, NodeIndex node, const std::vector<NodeIndex>& neighbours,
                        const NodePairs& faces) {
  const LeafSlot old = slot(node);
  std::vector<NodeIndex> children;
  for (NodeIndex rank = 0; rank < tree.children_per_node(); ++rank) {
    children.push_back(tree.first_child(node) + rank);
    LeafState& state = tree.state(children.back(), mode_);
    // What was ruled out of all of a leaf is ruled out of its children, whatever their own enclosures say.
    if (old.is_nowhere() && state.may_be(sign_)) state = state.without(sign_);
  }
  if (old.is_nowhere()) return;
  for (const NodeIndex neighbour : neighbours) forget_neighbour(slot(neighbour), old);
  if (old.is_member()) {
    replace_whole(tree, old, children);
  } else {
    indeterminate_.forget(old.item());
    indeterminate_.set_divided(old.item());
    for (const NodeIndex child : children) add_leaf(child, tree.state(child, mode_));
    for (std::size_t i = 0; i < children.size(); ++i)
      for (std::size_t j = i + 1; j < children.size(); ++j)
        if (is_power_of_two(i ^ j)) connect(tree, children[i], children[j]);
  }
  for (const auto& [child, neighbour] : faces) connect(tree, child, neighbour);
  set_slot(node, LeafSlot::nowhere());
}

/// All that the children hold of the set is in the component that the leaf was in.
void SignGraph::replace_whole(PoseTree& tree, LeafSlot leaf, const std::vector<NodeIndex>& children) {
  members_[leaf.place()] = no_node;
  const std::uint32_t whole = current(leaf.place());
  for (const NodeIndex child : children) {
    LeafState& state = tree.state(child, mode_);
    if (!state.may_be(sign_)) continue;
    components_.unite(whole, add_member(child, {}).place());
    ++traits_[whole].leaves;
    if (state.is_inside(sign_))
      traits_[whole].has_inside_leaf = true;
    else
      state = state.with_whole(sign_);
    if (!traits_[whole].has_inside_leaf) new_leaves_.push_back(child);
  }
}

std::vector<NodeIndex> SignGraph::climb_from_new(PoseTree& tree, const BoxClassifier& classifier,
                                                 bool bare_too) {
  std::vector<NodeIndex> bare, leaves;
  leaves.swap(new_leaves_);
  // One component need not climb: the others come to it.
  if (!has_climbed_ && !leaves.empty()) traits_[largest_component()].climbed = has_climbed_ = true;
  for (const NodeIndex leaf : leaves) {
    if (is_cancelled(control_)) break;
    if (holds_nothing(leaf) || !tree.state(leaf, mode_).is_leaf()) continue;
    Traits& traits = traits_[component(leaf)];
    if (!traits.climbed && (traits.has_inside_leaf || bare_too)) {
      const Part part = witness(tree, classifier, leaf);
      if (part.kind == Part::Kind::empty) {
        drop(tree, leaf);
        continue;
      }
      if (policy_.climbs && part.kind != Part::Kind::unknown) climb(tree, classifier, leaf, part.pose);
    }
    if (!traits_[component(leaf)].has_inside_leaf) bare.push_back(leaf);
  }
  return bare;
}

Part SignGraph::witness(const PoseTree& tree, const BoxClassifier& classifier, NodeIndex leaf) const {
  const Box box = tree.box(leaf);
  if (tree.state(leaf, mode_).is_inside(sign_)) return {Part::Kind::connected, box.middle()};
  const Part part = find_part_or_wedge(classifier, mode_, sign_, tree.place(leaf).root, box);
  return part.kind != Part::Kind::joined || tree.region().contains(part.pose) ? part : Part{};
}

std::uint32_t SignGraph::largest_component() {
  std::uint32_t largest = none;
  for (std::uint32_t i = 0; i < traits_.size(); ++i)
    if (components_.find(i) == i && (largest == none || traits_[i].leaves > traits_[largest].leaves))
      largest = i;
  return largest;
}

void SignGraph::climb(const PoseTree& tree, const BoxClassifier& classifier, NodeIndex leaf,
                      const MapPoint& pose) {
  traits_[component(leaf)].climbed = true;
  const NodeIndex reached =
      component_leaf_above(tree, classifier, {tree.place(leaf).root, pose}, component(leaf));
  if (reached != no_node) unite(slot(leaf), slot(reached));
}

NodeIndex SignGraph::component_leaf_above(const PoseTree& tree, const BoxClassifier& classifier,
                                          const MapPosition& position, std::uint32_t except) {
  Climb climb(classifier, tree.space(), mode_, sign_, position, policy_.climb);
  for (int i = 0; i <= policy_.climb.max_steps; ++i) {
    const auto here = tree.leaf_at(climb.position(), mode_);
    if (here && is_in_component(*here) && component(*here) != except) return *here;
    if (!climb.step()) return no_node;
  }
  return no_node;
}

void SignGraph::take_in_emptiness(PoseTree& tree, NodeIndex node) {
  LeafState& state = tree.state(node, mode_);
  state = state.without(sign_);
  take_in_proof(tree, node);
}

void SignGraph::take_in_whole(PoseTree& tree, NodeIndex node, NodeIndex component_leaf) {
  LeafState& state = tree.state(node, mode_);
  state = state.with_whole(sign_);
  take_in_proof(tree, node);
  if (component_leaf != no_node) unite(slot(node), slot(component_leaf));
}

void SignGraph::drop(PoseTree& tree, NodeIndex node) {
  const LeafSlot old = slot(node);
  visit_indeterminate_leaves_beside(tree, node,
                                    [&](LeafSlot neighbour) { forget_neighbour(neighbour, old); });
  LeafState& state = tree.state(node, mode_);
  state = state.without(sign_);
  members_[old.place()] = no_node;
  set_slot(node, LeafSlot::nowhere());
}

void SignGraph::start_from_components(Meeting& meeting, std::vector<std::uint32_t>& queue) {
  for (std::uint32_t v = 0; v < indeterminate_.size() && !is_cancelled(control_); ++v) {
    const NodeIndex node = indeterminate_.node(v);
    if (node == no_node) continue;
    indeterminate_.visit_neighbours(v, [&](LeafSlot neighbour) {
      if (!neighbour.is_member()) return;
      const std::uint32_t component = current(neighbour.place());
      if (meeting.nearest[v] == no_node) {
        meeting.nearest[v] = this->node(neighbour);
        meeting.components[v] = component;
        queue.push_back(v);
      } else if (meeting.components[v] != component) {
        meeting.contacts.push_back({node, node, meeting.nearest[v], this->node(neighbour)});
      }
    });
  }
}

// Breadth first, so that each indeterminate leaf takes the component that is the fewest leaves away. Along
// any chain of indeterminate leaves from one component to another the nearest component changes at some pair
// of neighbours, where the two are compared: all that such chains link is linked by contacts, if by way of a
// third.
void SignGraph::spread(Meeting& meeting, std::vector<std::uint32_t>& queue) {
  for (std::size_t head = 0; head < queue.size() && !is_cancelled(control_); ++head) {
    const std::uint32_t v = queue[head], component = meeting.components[v];
    indeterminate_.fetch(queue[std::min(head + IndeterminateLeaves::fetched_ahead, queue.size() - 1)]);
    indeterminate_.visit_neighbours(v, [&](LeafSlot neighbour) {
      if (!neighbour.is_indeterminate()) return;
      const std::uint32_t w = neighbour.item();
      if (meeting.components[w] == none) {
        meeting.nearest[w] = meeting.nearest[v];
        meeting.components[w] = component;
        queue.push_back(w);
      } else if (v < w && component != meeting.components[w]) {
        meeting.contacts.push_back(
            {indeterminate_.node(v), node(neighbour), meeting.nearest[v], meeting.nearest[w]});
      }
    });
  }
}

SignGraph::Meeting SignGraph::meeting() {
  Meeting meeting;
  meeting.nearest.assign(indeterminate_.size(), no_node);
  meeting.components.assign(indeterminate_.size(), none);
  std::vector<std::uint32_t> queue;
  start_from_components(meeting, queue);
  spread(meeting, queue);
  add_contacts_of_faces(meeting.contacts);
  return meeting;
}

void SignGraph::add_contacts_of_faces(std::vector<Contact>& contacts) {
  visit_unknown_faces([&](NodeIndex a, NodeIndex b) {
    if (component(a) != component(b)) contacts.push_back({a, b, a, b});
  });
}

}  // namespace parallel_aspects
