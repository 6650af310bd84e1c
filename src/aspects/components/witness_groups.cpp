// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/witness_groups.h"

#include "aspects/boxes/segment_proof.h"

#include <algorithm>
#include <utility>

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

}  // namespace parallel_aspects
