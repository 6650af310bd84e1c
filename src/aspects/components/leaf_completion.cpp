// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/leaf_completion.h"

#include "aspects/components/witness_groups.h"
#include "aspects/tree/box_parts.h"

#include <optional>
#include <vector>

namespace parallel_aspects {
namespace {

/// The leaves of one working mode, for one sign of det A.
class SignCompletion {
 public:
  SignCompletion(PoseTree& tree, const BoxClassifier& classifier, const StarFinder& stars,
                 std::size_t max_boxes, std::size_t mode, SignGraph& graph, const ComponentPolicy& policy)
      : tree_(tree),
        classifier_(classifier),
        stars_(stars),
        mode_(mode),
        graph_(graph),
        policy_(policy),
        boxes_left_(max_boxes) {}

  void run(const MapControl& control) {
    std::vector<NodeIndex> left = look_into_all(indeterminate_nodes(), control);
    MapControl again = control;
    again.progress = nullptr;  // a few leaves at most
    for (std::size_t before = left.size() + 1; left.size() < before && !is_cancelled(control);) {
      graph_.settle_faces(tree_, classifier_);
      lead_out_of_bare_components(again);
      before = left.size();
      left = look_into_all(left, again);
    }
  }

 private:
  std::vector<NodeIndex> indeterminate_nodes() const {
    std::vector<NodeIndex> nodes;
    for (std::size_t v = 0; v < graph_.indeterminate_leaves().size(); ++v)
      if (graph_.indeterminate_leaves().node(v) != no_node)
        nodes.push_back(graph_.indeterminate_leaves().node(v));
    return nodes;
  }

  /// Returns those that lead to components which are not known to be one: the leaves that follow may join
  /// them.
  std::vector<NodeIndex> look_into_all(const std::vector<NodeIndex>& nodes, const MapControl& control) {
    std::vector<NodeIndex> left;
    for (std::size_t i = 0; i < nodes.size() && boxes_left_ > 0 && !is_cancelled(control); ++i) {
      if (control.progress) control.progress(static_cast<double>(i) / static_cast<double>(nodes.size()));
      if (look_into(nodes[i]) && !settle(nodes[i])) left.push_back(nodes[i]);
    }
    return left;
  }

  /// Components without an inside leaf stood alone when they were found. They may be empty, or parts of
  /// others that have grown since.
  void lead_out_of_bare_components(const MapControl& control) {
    for (std::size_t place = 0; place < graph_.members().size() && !is_cancelled(control); ++place) {
      const NodeIndex node = graph_.members()[place];
      if (node == no_node || graph_.is_listed(graph_.component(node)) || !look_into(node)) continue;
      if (poses_.empty()) {
        graph_.drop(tree_, node);
      } else if (const auto leaf = common_leaf(node, graph_.component(node)); leaf && *leaf != no_node) {
        graph_.join(node, *leaf);
      }
    }
  }

  bool look_into(NodeIndex node) {
    poses_.clear();
    parts_left_ = policy_.max_parts_for_stars;
    return look_into(tree_.place(node).root, tree_.box(node), policy_.levels_of_stars);
  }

  /// Gathers poses that all the box has of the set is connected with; false where that is not proved.
  bool look_into(RootIndex root, const Box& box, std::uint32_t levels) {
    const Stars stars = find(root, box);
    if (stars.is_known) {
      poses_.insert(poses_.end(), stars.poses.begin(),
                    stars.poses.begin() + static_cast<std::ptrdiff_t>(stars.count));
      return true;
    }
    if (levels == 0 || parts_left_ == 0) return false;
    --parts_left_;
    for (std::uint32_t rank = 0; rank < tree_.children_per_node(); ++rank)
      if (!look_into(root, part_of(box, rank), levels - 1)) return false;
    return true;
  }

  /// Of a leaf all of which is connected with the poses; false where these lead to different components.
  bool settle(NodeIndex node) {
    if (poses_.empty()) {
      graph_.take_in_emptiness(tree_, node);
      return true;
    }
    const std::optional<NodeIndex> leaf = common_leaf(node, SignGraph::none);
    if (leaf) graph_.take_in_whole(tree_, node, *leaf);
    return leaf.has_value();
  }

  std::optional<NodeIndex> common_leaf(NodeIndex node, std::uint32_t except) {
    const auto find_stars = [this](RootIndex root, const Box& box) { return find(root, box); };
    const WitnessGroups::Proofs proofs{tree_, classifier_, find_stars, mode_, graph_, policy_};
    return WitnessGroups(proofs, node, poses_, except).common_leaf();
  }

  // Nothing is known where too many were looked for.
  Stars find(RootIndex root, const Box& box) {
    if (boxes_left_ == 0) return {};
    --boxes_left_;
    return stars_.find(root, box, tree_.region(), mode_, graph_.sign());
  }

  PoseTree& tree_;
  const BoxClassifier& classifier_;
  const StarFinder& stars_;
  std::size_t mode_;
  SignGraph& graph_;
  const ComponentPolicy& policy_;
  std::vector<MapPoint> poses_;
  std::size_t parts_left_ = 0;
  std::size_t boxes_left_;
};

}  // namespace

void complete_leaves(PoseTree& tree, const BoxClassifier& classifier, const StarFinder& stars,
                     std::size_t max_boxes, LeafGraph& graph, const MapControl& control,
                     const ComponentPolicy& policy) {
  const RoundingUpward rounding;
  for (const int sign : {1, -1}) {
    const MapControl half = part_of(control, sign > 0 ? 0.0 : 0.5, sign > 0 ? 0.5 : 1.0);
    SignCompletion(tree, classifier, stars, max_boxes, graph.mode(), graph.of(sign), policy).run(half);
  }
}

}  // namespace parallel_aspects
