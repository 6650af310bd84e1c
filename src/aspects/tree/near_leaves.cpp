// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/near_leaves.h"

#include <limits>

namespace parallel_aspects {

// Children come after their parents, and have no states of modes that end above them.
InsideMarks::InsideMarks(const PoseTree& tree)
    : bytes_((2 * tree.mode_count() + 7) / 8), marks_(bytes_ * tree.node_count(), 0) {
  for (NodeIndex node = static_cast<NodeIndex>(tree.node_count()); node-- > 0;) {
    std::uint8_t* own = marks_.data() + node * bytes_;
    for (std::size_t mode = 0; mode < tree.mode_count(); ++mode) {
      const LeafState state = tree.state(node, mode);
      if (!state.is_inside()) continue;
      const std::size_t bit = 2 * mode + (state.is_inside(1) ? 1 : 0);
      own[bit / 8] = static_cast<std::uint8_t>(own[bit / 8] | 1U << bit % 8);
    }
    const NodeIndex first = tree.first_child(node);
    if (first == no_node) continue;
    const std::uint8_t* below = marks_.data() + first * bytes_;
    for (std::size_t i = 0; i < tree.children_per_node() * bytes_; ++i)
      own[i % bytes_] = static_cast<std::uint8_t>(own[i % bytes_] | below[i]);
  }
}

namespace {

class Search {
 public:
  Search(const PoseTree& tree, std::size_t mode, int sign, const MapPoint& point, const InsideMarks* marks)
      : tree_(tree),
        mode_(mode),
        sign_(sign),
        point_(point),
        marks_(marks),
        weights_(tree.space().weights()) {}

  NearLeaves run(RootIndex root) {
    descend(root, tree_.box(root));
    return found_;
  }

 private:
  double farthest() const {
    return found_.count < NearLeaves::most ? std::numeric_limits<double>::infinity()
                                           : found_.items[found_.count - 1].squared_distance;
  }

  void descend(NodeIndex node, const Box& box) {
    const LeafState state = tree_.state(node, mode_);
    if (!state.is_divided() && !state.is_inside(sign_)) return;
    if (marks_ != nullptr && !marks_->holds(node, mode_, sign_)) return;
    const double distance = box.squared_distance(point_, weights_);
    if (distance >= farthest()) return;
    if (!state.is_divided()) return insert(node, distance);
    const NodeIndex nearest = box.rank_of(point_), first = tree_.first_child(node);
    for (NodeIndex turn = 0; turn < tree_.children_per_node(); ++turn)
      descend(first + (turn ^ nearest), child(box, turn ^ nearest));
  }

  static Box child(const Box& box, NodeIndex rank) {
    Box result = box;
    for (std::size_t i = 0; i < box.dimension; ++i)
      ((rank >> i & 1U) != 0 ? result.lower : result.upper)[i] = box.center(i);
    return result;
  }

  void insert(NodeIndex leaf, double distance) {
    if (found_.count < NearLeaves::most) ++found_.count;
    std::size_t at = found_.count - 1;
    for (; at > 0 && found_.items[at - 1].squared_distance > distance; --at)
      found_.items[at] = found_.items[at - 1];
    found_.items[at] = {leaf, distance};
  }

  const PoseTree& tree_;
  std::size_t mode_;
  int sign_;
  const MapPoint& point_;
  const InsideMarks* marks_;
  MapPoint weights_;
  NearLeaves found_;
};

}  // namespace

NearLeaves near_inside_leaves(const PoseTree& tree, std::size_t mode, int sign, const MapPosition& position,
                              const InsideMarks* marks) noexcept {
  return Search(tree, mode, sign, position.point, marks).run(position.root);
}

}  // namespace parallel_aspects
