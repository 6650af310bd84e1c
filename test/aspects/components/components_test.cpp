// SPDX-License-Identifier: BSD-3-Clause
//
// Components of trees with states set at random, against a flood over all leaves that may hold poses of the
// set.
#include "aspects/components/components.h"

#include "aspects/components/contacts.h"
#include "aspects/components/disjoint_sets.h"
#include "aspects/tree/neighbour_leaves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

const LeafState indeterminate_leaf = LeafState::undecided(true, false);
const LeafState whole_leaf = indeterminate_leaf.with_whole(1);

/// A tree of one mode in which all leaves are of one level, and outside.
PoseTree even_tree(std::size_t dimension, std::uint32_t level) {
  const Box region{dimension, {0.0, 0.0, 0.0}, {8.0, 8.0, 8.0}};
  const TaskSpace space = dimension == 1 ? TaskSpace::T1 : dimension == 2 ? TaskSpace::T2 : TaskSpace::T3;
  PoseTree tree(make_pose_space(space, *exact_region(region), 1.0), 1);
  tree.state(0, 0) = LeafState::undecided(true, true);
  for (NodeIndex node = 0; node < tree.node_count(); ++node) {
    if (tree.place(node).level == level) {
      tree.state(node, 0) = LeafState::outside();
      continue;
    }
    const NodeIndex first = tree.divide(node, [](std::size_t) { return true; });
    for (NodeIndex child = first; child < first + tree.children_per_node(); ++child)
      tree.state(child, 0) = LeafState::undecided(true, true);
  }
  return tree;
}

PoseTree row_of(const std::vector<LeafState>& states) {
  PoseTree tree = even_tree(1, 3);
  for (NodeIndex node = 0; node < tree.node_count(); ++node)
    if (tree.state(node, 0).is_leaf() && tree.place(node).cell[0] < states.size())
      tree.state(node, 0) = states[tree.place(node).cell[0]];
  return tree;
}

ModeComponents components_of(const PoseTree& tree) {
  const MapControl control;
  const ComponentPolicy policy;
  LeafGraph graph(tree, 0, true, control, policy);
  return find_components(tree, 0, graph, control);
}

TEST(Components, InsideLeavesBesideAWholePartAreOne) {
  const ModeComponents found =
      components_of(row_of({LeafState::inside(1), whole_leaf, LeafState::inside(1)}));
  EXPECT_EQ(found.components.size(), 1U);
  EXPECT_EQ(found.bound, 1U);
}

TEST(Components, OpenLeavesLeaveTwoUnresolved) {
  const ModeComponents found = components_of(
      row_of({LeafState::inside(1), indeterminate_leaf, indeterminate_leaf, LeafState::inside(1)}));
  EXPECT_EQ(found.components.size(), 2U);
  EXPECT_EQ(found.cluster_count, 1U);
  EXPECT_EQ(found.unresolved.size(), 1U);
}

// What the whole part holds may be connected with both, though it is joined to neither.
TEST(Components, AWholePartBetweenOpenLeavesLeavesTwoUnresolved) {
  const ModeComponents found = components_of(row_of({LeafState::inside(1), indeterminate_leaf, whole_leaf,
                                                     whole_leaf, indeterminate_leaf, LeafState::inside(1)}));
  EXPECT_EQ(found.components.size(), 2U);
  EXPECT_EQ(found.cluster_count, 1U);
  EXPECT_EQ(found.unresolved.size(), 1U);
}

TEST(Components, NothingBetweenThemIsSeparate) {
  const ModeComponents found = components_of(
      row_of({LeafState::inside(1), indeterminate_leaf, LeafState::outside(), LeafState::inside(1)}));
  EXPECT_EQ(found.cluster_count, 2U);
  EXPECT_TRUE(found.unresolved.empty());
}

class RandomStates : public testing::TestWithParam<unsigned> {
 protected:
  RandomStates() : random_(GetParam()), tree_(even_tree(2 + GetParam() % 2, 3)), reach_(0) {
    const double share = std::uniform_real_distribution<double>(0.3, 0.8)(random_);
    for (NodeIndex node = 0; node < tree_.node_count(); ++node)
      if (tree_.state(node, 0).is_leaf()) tree_.state(node, 0) = random_state(share);
    reach_ = DisjointSets(tree_.node_count());
    for (NodeIndex node = 0; node < tree_.node_count(); ++node)
      if (tree_.state(node, 0).may_be(1))
        for (const NodeIndex other : neighbour_leaves(tree_, 0, node))
          if (tree_.state(other, 0).may_be(1)) reach_.unite(node, other);
  }

  LeafState random_state(double share_outside) {
    if (std::bernoulli_distribution(share_outside)(random_)) return LeafState::outside();
    const unsigned kind = random_() % 3;
    return kind == 0 ? LeafState::inside(1) : kind == 1 ? whole_leaf : indeterminate_leaf;
  }

  std::mt19937 random_;
  PoseTree tree_;
  DisjointSets reach_;  // leaves that are connected if all that may be in them is
};

TEST_P(RandomStates, ClustersAreWhatAFloodReaches) {
  std::set<std::uint32_t> clusters;
  for (NodeIndex node = 0; node < tree_.node_count(); ++node)
    if (tree_.state(node, 0).is_inside(1)) clusters.insert(reach_.find(node));
  EXPECT_EQ(components_of(tree_).cluster_count, clusters.size());
}

TEST_P(RandomStates, ContactsAreFoundFromTheSmallerOnes) {
  const MapControl control;
  const ComponentPolicy policy;
  LeafGraph graphs(tree_, 0, false, control, policy);
  SignGraph& graph = graphs.of(1);
  std::set<std::pair<std::uint32_t, std::uint32_t>> parts;  // reach of listed components
  for (NodeIndex node = 0; node < tree_.node_count(); ++node)
    if (tree_.state(node, 0).is_inside(1)) parts.emplace(reach_.find(node), graph.component(node));
  std::set<std::uint32_t> expected;  // those that something else can be reached from
  for (const auto& [reach, component] : parts)
    if (component != graph.largest_component() &&
        std::count_if(parts.begin(), parts.end(), [r = reach](const auto& part) { return part.first == r; }) >
            1)
      expected.insert(component);
  std::set<std::uint32_t> found;
  for (const SignGraph::Contact& contact : ContactSearch(tree_, 0, graph, control, policy).run()) {
    EXPECT_EQ(reach_.find(contact.leaf), reach_.find(contact.other_leaf));
    EXPECT_EQ(reach_.find(contact.leaf), reach_.find(contact.node));
    EXPECT_FALSE(tree_.state(contact.node, 0).is_inside());
    found.insert({graph.component(contact.leaf), graph.component(contact.other_leaf)});
  }
  for (const std::uint32_t component : expected) EXPECT_EQ(found.count(component), 1U) << component;
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomStates, testing::Range(0U, 60U));

}  // namespace
}  // namespace parallel_aspects
