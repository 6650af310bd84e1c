// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_COMPLETION_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_COMPLETION_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/components/components.h"
#include "aspects/components/disjoint_sets.h"
#include "aspects/components/sign_graph.h"
#include "aspects/star_sets/star_finder.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Joins poses of S(mode, sign) in and about one leaf to groups, each proved connected, and searches for the
/// component that each group is in. Needs a live `RoundingUpward`.
class WitnessGroups {
 public:
  /// What is asked for proofs; all must outlive this.
  struct Proofs {
    const PoseTree& tree;
    const BoxClassifier& classifier;
    std::function<Stars(RootIndex, const Box&)> find_stars;  // of a box within the region
    std::size_t mode;
    SignGraph& graph;
    const ComponentPolicy& policy;
  };

  /// `poses`: proved to be in the set, in the root box of the leaf `node`; one at least. `except`: a
  /// component that no leaf is searched for in, or `SignGraph::none`.
  WitnessGroups(const Proofs& proofs, NodeIndex node, std::vector<MapPoint> poses, std::uint32_t except);

  /// A leaf of the component that all poses are in; `no_node` where they are one group that leads to none.
  /// Nothing where they are not proved to be connected.
  std::optional<NodeIndex> common_leaf();

 private:
  /// A pose, and the range of those of which it is connected with one.
  struct Branch {
    std::size_t from, first, count;
  };

  void join_along_segments();
  void climb_from_groups();
  void join_by_stars();
  bool join_by_stars(std::size_t i);
  void rise_from_groups();
  void rise(std::size_t i);
  NodeIndex leaf_above(const MapPoint& pose);
  void branch_out(std::size_t i, const Stars& stars);
  NodeIndex common_leaf(const Branch& branch);
  bool are_joined(const MapPoint& a, const MapPoint& b, int more) const;
  bool is_free(const MapPoint& a, const MapPoint& b) const;
  double squared_distance(const MapPoint& a, const MapPoint& b) const;
  std::vector<std::size_t> nearest_of_others(std::size_t i);
  Box about(const MapPoint& pose, double share) const;
  Stars find_stars(Box box) const;
  void unite(std::size_t a, std::size_t b);
  NodeIndex& leaf_of(std::size_t i) { return leaves_[groups_.find(static_cast<std::uint32_t>(i))]; }
  NodeIndex main_leaf();
  bool leads_to(NodeIndex leaf, std::size_t i);
  NodeIndex leaf_of_all();
  bool is_one_group();

  const Proofs& proofs_;
  Box leaf_;
  RootIndex root_;
  std::uint32_t except_;
  std::size_t asked_;  // of the poses; those after them are of branches
  std::vector<MapPoint> poses_;
  DisjointSets groups_;  // of the poses
  std::vector<Branch> branches_;
  std::vector<NodeIndex> leaves_;  // of a component, by group; `no_node` for none
};

/// Proves of indeterminate leaves that they are whole or empty by stars about poses nearby (see StarFinder),
/// of the leaf or of all its parts, of no more than `max_boxes` for a sign. Those that are neither stay
/// indeterminate. Ends early when cancelled; progress is that of the leaves of this graph.
void complete_leaves(PoseTree& tree, const BoxClassifier& classifier, const StarFinder& stars,
                     std::size_t max_boxes, LeafGraph& graph, const MapControl& control,
                     const ComponentPolicy& policy);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_COMPLETION_H
