// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/pose_tree.h"

#include "aspects/tree/neighbour_leaves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace parallel_aspects {
namespace {

Box square_box(double lower, double upper) { return Box{2, {lower, lower, 0.0}, {upper, upper, 0.0}}; }

TEST(ExactRegion, EnclosesTheBoxClosely) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> corner(-100.0, 100.0), width(1.0, 50.0);
  for (int i = 0; i < 1000; ++i) {
    const double lower = corner(random), upper = lower + width(random);
    const auto exact = exact_region(square_box(lower, upper));
    ASSERT_TRUE(exact) << lower << ", " << upper;
    EXPECT_LE(exact->lower[0], lower);
    EXPECT_GE(exact->upper[0], upper);
    EXPECT_LE(exact->width(0), (upper - lower) * 1.001);
  }
}

TEST(ExactRegion, RefusesWhatHasNoSize) {
  EXPECT_FALSE(exact_region(square_box(1.0, 1.0)));
  EXPECT_FALSE(exact_region(square_box(1.0, 0.0)));
  EXPECT_FALSE(exact_region(square_box(0.0, std::numeric_limits<double>::infinity())));
  EXPECT_FALSE(exact_region(square_box(std::nan(""), 1.0)));
  EXPECT_FALSE(exact_region(square_box(1e6, 1e6 + 1.0)));
}

/// A tree of one mode, divided at random; leaves are undecided.
PoseTree random_tree(int divisions, std::size_t dimension, unsigned seed) {
  const Box region = *exact_region(Box{dimension, {-0.7, -1.3, -2.9}, {1.1, 2.3, 3.7}});
  PoseTree tree(make_pose_space(dimension == 2 ? TaskSpace::T2 : TaskSpace::T3, region, 1.0), 1);
  tree.state(0, 0) = LeafState::undecided(true, true);
  std::mt19937 random(seed);
  for (int i = 0; i < divisions; ++i) {
    const auto node = static_cast<NodeIndex>(random() % tree.node_count());
    if (tree.state(node, 0).is_divided() || tree.place(node).level >= PoseTree::deepest_level) continue;
    const NodeIndex first = tree.divide(node, [](std::size_t) { return true; });
    for (NodeIndex child = first; child < first + tree.children_per_node(); ++child)
      tree.state(child, 0) = LeafState::undecided(true, true);
  }
  return tree;
}

std::vector<NodeIndex> leaves(const PoseTree& tree) {
  std::vector<NodeIndex> result;
  for (NodeIndex node = 0; node < tree.node_count(); ++node)
    if (tree.state(node, 0).is_leaf()) result.push_back(node);
  return result;
}

TEST(PoseTree, FindsTheLeafThatContainsAPoint) {
  const PoseTree tree = random_tree(2000, 2, 5);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> x(-0.7, 1.1), y(-1.3, 2.3);
  for (int i = 0; i < 1000; ++i) {
    const MapPoint point{x(random), y(random), 0.0};
    const auto leaf = tree.leaf_at({0, point}, 0);
    ASSERT_TRUE(leaf);
    EXPECT_TRUE(tree.box(*leaf).contains(point));
    EXPECT_TRUE(tree.state(*leaf, 0).is_leaf());
  }
  EXPECT_FALSE(tree.leaf_at({0, {5.0, 0.0, 0.0}}, 0));
  EXPECT_FALSE(tree.leaf_at({0, {std::nan(""), 0.0, 0.0}}, 0));
}

// Two independent ways to the pairs of leaves with a common face: the recursion over the tree, and every pair
// of boxes compared as numbers.
TEST(PoseTree, FacesAreThoseThatBoxesShare) {
  for (const std::size_t dimension : {2U, 3U}) {
    const PoseTree tree = random_tree(60, dimension, static_cast<unsigned>(dimension));
    std::set<std::pair<NodeIndex, NodeIndex>> found, expected;
    visit_faces(tree, 0,
                [&found](NodeIndex a, NodeIndex b) { EXPECT_TRUE(found.insert(std::minmax(a, b)).second); });
    for (const NodeIndex a : leaves(tree))
      for (const NodeIndex b : leaves(tree)) {
        if (a >= b) continue;
        std::size_t touching = 0, overlapping = 0;
        const Box one = tree.box(a), other = tree.box(b);
        for (std::size_t i = 0; i < dimension; ++i) {
          const double lower = std::max(one.lower[i], other.lower[i]);
          const double upper = std::min(one.upper[i], other.upper[i]);
          touching += lower == upper;
          overlapping += lower < upper;
        }
        if (touching == 1 && overlapping == dimension - 1) expected.insert({a, b});
        EXPECT_EQ(faces_between(tree, {a}, {b}).size(), expected.count({a, b}));
      }
    EXPECT_EQ(found, expected);
    EXPECT_GT(found.size(), 50U);
  }
}

}  // namespace
}  // namespace parallel_aspects
