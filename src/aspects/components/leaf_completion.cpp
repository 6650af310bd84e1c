// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/leaf_completion.h"

#include "aspects/boxes/segment_proof.h"
#include "aspects/tree/pose_tree.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr int halvings_between_poses = 4;

// Numbers found by trial.
constexpr std::size_t climbs_of_a_group = 8, nearest_tried = 8;
constexpr double least_edge = 0x1p-30;  // of a box of two poses, as a share of the leaf's
constexpr int most_between = 6;         // times that stars are joined by further ones

}  // namespace

WitnessGroups::WitnessGroups(const Proofs& proofs, NodeIndex node, std::vector<MapPoint> poses,
                             std::uint32_t except)
    : proofs_(proofs),
      leaf_(proofs.tree.box(node)),
      root_(proofs.tree.place(node).root),
      except_(except),
      asked_(poses.size()),
      poses_(std::move(poses)),
      groups_(poses_.size()),
      leaves_(poses_.size(), no_node) {}

std::optional<NodeIndex> WitnessGroups::common_leaf() {
  join_along_segments();
  for (const auto& step :
       {&WitnessGroups::climb_from_groups, &WitnessGroups::join_by_stars, &WitnessGroups::rise_from_groups}) {
    (this->*step)();
    if (const NodeIndex leaf = leaf_of_all(); leaf != no_node) return leaf;
  }
  return is_one_group() ? std::optional<NodeIndex>(no_node) : std::nullopt;
}

/// Most poses lie close to the one before; to see that they are joined with it takes less than a climb.
void WitnessGroups::join_along_segments() {
  for (std::size_t i = 1; i < poses_.size(); ++i)
    if (is_free(poses_[i - 1], poses_[i])) unite(i, i - 1);
}

void WitnessGroups::climb_from_groups() {
  std::vector<std::size_t> climbs(poses_.size(), 0);
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const std::size_t group = groups_.find(static_cast<std::uint32_t>(i));
    if (leaves_[group] == no_node && climbs[group]++ < climbs_of_a_group) leaf_of(i) = leaf_above(poses_[i]);
  }
}

/// In a thin wedge poses of neighbouring parts see each other in the coordinates of a star, where no straight
/// segment is free.
void WitnessGroups::join_by_stars() {
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < poses_.size(); ++i)
      if (!leads_to(main_leaf(), i)) again = join_by_stars(i) || again;
  }
}

bool WitnessGroups::join_by_stars(std::size_t i) {
  for (const std::size_t other : nearest_of_others(i)) {
    if (!are_joined(poses_[i], poses_[other], most_between)) continue;
    unite(i, other);
    return true;
  }
  return false;
}

std::vector<std::size_t> WitnessGroups::nearest_of_others(std::size_t i) {
  std::vector<std::pair<double, std::size_t>> others;
  const std::uint32_t own = groups_.find(static_cast<std::uint32_t>(i));
  for (std::uint32_t k = 0; k < poses_.size(); ++k)
    if (groups_.find(k) != own) others.emplace_back(squared_distance(poses_[i], poses_[k]), k);
  const std::size_t count = std::min(nearest_tried, others.size());
  std::partial_sort(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(count), others.end());
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < count; ++k) result.push_back(others[k].second);
  return result;
}

double WitnessGroups::squared_distance(const MapPoint& a, const MapPoint& b) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < leaf_.dimension; ++i) {
    const double share = (a[i] - b[i]) / leaf_.width(i);
    sum += share * share;
  }
  return sum;
}

/// Each pose of the set in a box of both is connected with one of the box's stars, so that they are joined if
/// all of these are.
bool WitnessGroups::are_joined(const MapPoint& a, const MapPoint& b, int more) const {
  Box box = leaf_;
  for (std::size_t i = 0; i < leaf_.dimension; ++i) {
    const auto [least, most] = std::minmax(a[i], b[i]);
    box.lower[i] = least - least_edge * leaf_.width(i);
    box.upper[i] = most + least_edge * leaf_.width(i);
  }
  const Stars stars = find_stars(box);
  if (!stars.is_known || stars.count == 0 || (stars.count > 1 && more == 0)) return false;
  for (std::size_t k = 1; k < stars.count; ++k) {
    const MapPoint &one = stars.poses[k - 1], &other = stars.poses[k];
    if (!is_free(one, other) && !are_joined(one, other, more - 1)) return false;
  }
  return true;
}

bool WitnessGroups::is_free(const MapPoint& a, const MapPoint& b) const {
  return segment_is_free(proofs_.classifier, leaf_.dimension, proofs_.mode, proofs_.graph.sign(), {root_, b},
                         a, halvings_between_poses);
}

/// Out of wedges in which a climb finds no way: by stars of growing boxes about a pose.
void WitnessGroups::rise_from_groups() {
  for (std::size_t i = 0; i < asked_; ++i)
    if (leaf_of(i) == no_node) rise(i);
  join_by_stars();
  for (const Branch& branch : branches_)
    if (leaf_of(branch.from) == no_node) leaf_of(branch.from) = common_leaf(branch);
}

void WitnessGroups::rise(std::size_t i) {
  for (double share = proofs_.policy.smallest_rise; share <= 1.0; share *= 2.0) {
    const Stars stars = find_stars(about(poses_[i], share));
    if (!stars.is_known) continue;
    if (stars.count == 1) {
      poses_[i] = stars.poses[0];
    } else {
      branch_out(i, stars);
    }
  }
  leaf_of(i) = leaf_above(poses_[i]);
}

/// A pose is connected with one of several, so that it is where all of them are.
void WitnessGroups::branch_out(std::size_t i, const Stars& stars) {
  branches_.push_back({i, poses_.size(), stars.count});
  for (std::size_t k = 0; k < stars.count; ++k) {
    poses_.push_back(stars.poses[k]);
    groups_.add();
    leaves_.push_back(leaf_above(stars.poses[k]));
  }
}

/// Of all poses that a branch leads to.
NodeIndex WitnessGroups::common_leaf(const Branch& branch) {
  const NodeIndex first = leaf_of(branch.first);
  for (std::size_t k = branch.first; k < branch.first + branch.count; ++k)
    if (!leads_to(first, k)) return no_node;
  return first;
}

NodeIndex WitnessGroups::leaf_above(const MapPoint& pose) {
  return proofs_.graph.component_leaf_above(proofs_.tree, proofs_.classifier, {root_, pose}, except_);
}

/// A box with edges of this share of the leaf's.
Box WitnessGroups::about(const MapPoint& pose, double share) const {
  Box box = leaf_;
  for (std::size_t i = 0; i < leaf_.dimension; ++i) {
    box.lower[i] = pose[i] - 0.5 * share * leaf_.width(i);
    box.upper[i] = pose[i] + 0.5 * share * leaf_.width(i);
  }
  return box;
}

/// In what the region holds of a box.
Stars WitnessGroups::find_stars(Box box) const {
  const Box& region = proofs_.tree.region();
  for (std::size_t i = 0; i < box.dimension; ++i) {
    box.lower[i] = std::max(region.lower[i], box.lower[i]);
    box.upper[i] = std::min(region.upper[i], box.upper[i]);
  }
  return proofs_.find_stars(root_, box);
}

/// Components that both lead to are one.
void WitnessGroups::unite(std::size_t a, std::size_t b) {
  const NodeIndex leaf = leaf_of(a), other = leaf_of(b);
  if (leaf != no_node && other != no_node) proofs_.graph.join(leaf, other);
  groups_.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
  leaf_of(a) = leaf != no_node ? leaf : other;
}

/// Of the first group that leads to a component; `no_node` if none does.
NodeIndex WitnessGroups::main_leaf() {
  for (std::size_t i = 0; i < asked_; ++i)
    if (leaf_of(i) != no_node) return leaf_of(i);
  return no_node;
}

bool WitnessGroups::leads_to(NodeIndex leaf, std::size_t i) {
  return leaf != no_node && leaf_of(i) != no_node &&
         proofs_.graph.component(leaf_of(i)) == proofs_.graph.component(leaf);
}

/// `no_node` where not all groups lead to one component.
NodeIndex WitnessGroups::leaf_of_all() {
  const NodeIndex leaf = main_leaf();
  for (std::size_t i = 0; i < asked_; ++i)
    if (!leads_to(leaf, i)) return no_node;
  return leaf;
}

bool WitnessGroups::is_one_group() {
  for (std::uint32_t i = 0; i < asked_; ++i)
    if (groups_.find(i) != 0) return false;
  return true;
}

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

  // Nothing is known where too many were searched for.
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
