// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/gate_leaves.h"

#include "aspects/map/map_contents.h"
#include "aspects/tree/neighbour_leaves.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace parallel_aspects {
namespace {

// Some tenth of a millisecond of work.
constexpr NodeIndex nodes_between_looks = 4096;

/// From the leaves that share a face with an undecided one, step by step over faces between such leaves.
class NearestOfMode {
 public:
  NearestOfMode(const AspectMap::Contents& map, std::size_t mode, const MapControl& control)
      : map_(map), mode_(mode), control_(control), first_(map.tree.node_count() + 1) {
    std::vector<std::pair<NodeIndex, NodeIndex>> steps;
    visit([&](NodeIndex from, NodeIndex to) {
      ++first_[from + 1];
      steps.emplace_back(from, to);
    });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    neighbours_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const auto& [from, to] : steps) neighbours_[next[from]++] = to;
  }

  std::vector<int> run(int sign) const {
    std::vector<int> nearest(map_.tree.node_count());
    std::vector<NodeIndex> open;
    for (NodeIndex node = 0; node < map_.tree.node_count(); ++node)
      if (map_.tree.state(node, mode_).is_inside(sign)) {
        nearest[node] = map_.leaf_aspect(node, mode_);
        open.push_back(node);
      }
    for (std::size_t at = 0; at < open.size(); ++at)
      for (std::size_t i = first_[open[at]]; i < first_[open[at] + 1]; ++i) {
        const NodeIndex next = neighbours_[i];
        if (nearest[next] != 0 || !map_.tree.state(next, mode_).may_be(sign)) continue;
        nearest[next] = nearest[open[at]];
        open.push_back(next);
      }
    return nearest;
  }

  /// Calls `visit` with each two leaves that share a face, one of them undecided, in this order and the
  /// other.
  template <class Visit>
  void visit_pairs(const Visit& visit) const {
    for (NodeIndex from = 0; from < map_.tree.node_count(); ++from)
      for (std::size_t i = first_[from]; i < first_[from + 1]; ++i) {
        visit(from, neighbours_[i]);
        visit(neighbours_[i], from);
      }
  }

 private:
  /// Every step onto an undecided leaf.
  template <class Visit>
  void visit(const Visit& visit) const {
    visit_faces(
        map_.tree, mode_,
        [&](NodeIndex a, NodeIndex b) {
          if (map_.tree.state(b, mode_).is_undecided()) visit(a, b);
          if (map_.tree.state(a, mode_).is_undecided()) visit(b, a);
        },
        control_);
  }

  const AspectMap::Contents& map_;
  std::size_t mode_;
  const MapControl& control_;
  std::vector<std::size_t> first_;  // by leaf, where its neighbours begin
  std::vector<NodeIndex> neighbours_;
};

/// Collects the leaves of one working mode.
class ModeLeaves {
 public:
  ModeLeaves(const AspectMap::Contents& map, const GateClasses& classes, const NearestAspects& nearest,
             std::size_t mode, const MapControl& control)
      : map_(map),
        nearest_(nearest),
        mode_(mode),
        control_(control),
        has_parallel_(classes.is_searched({Crossing::parallel, mode, 0})),
        others_(map.modes[mode].leg_count()) {
    for (std::size_t leg = 0; leg < others_.size(); ++leg) {
      const GateClass serial{Crossing::serial, mode, leg};
      if (classes.is_searched(serial)) others_[leg] = other_mode(map, serial);
      has_serial_ = has_serial_ || others_[leg].has_value();
    }
  }

  std::vector<GateLeaves> run() {
    if (has_parallel_ || has_serial_)
      for (NodeIndex node = 0; node < map_.tree.node_count(); ++node) {
        if (node % nodes_between_looks == 0 && is_cancelled(control_)) break;
        if (map_.tree.state(node, mode_).is_undecided()) add(node);
      }
    if (has_parallel_) add_touching();
    std::vector<GateLeaves> result;
    for (auto& [key, leaves] : leaves_) {
      std::sort(leaves.begin(), leaves.end());
      leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
      const auto [crossing, leg, sign, one, other] = key;
      result.push_back({crossing, leg, mode_, sign, std::move(leaves)});
    }
    return result;
  }

 private:
  using Key = std::tuple<Crossing, std::size_t, int, int, int>;

  void add_touching() {
    for (const NearestAspects::Touching& each : nearest_.touching(mode_))
      leaves_[{Crossing::parallel, 0, 1, each.positive, each.negative}].push_back(each.leaf);
  }

  void add(NodeIndex node) {
    const int positive = nearest_.of(node, mode_, 1), negative = nearest_.of(node, mode_, -1);
    if (has_parallel_ && positive != 0 && negative != 0)
      leaves_[{Crossing::parallel, 0, 1, positive, negative}].push_back(node);
    if (!has_serial_ || (positive == 0 && negative == 0)) return;
    const MapPosition middle{map_.tree.place(node).root, map_.tree.box(node).middle()};
    for (std::size_t leg = 0; leg < others_.size(); ++leg) {
      const auto there = others_[leg] ? map_.tree.leaf_at(middle, *others_[leg]) : std::nullopt;
      if (!there || !map_.tree.state(*there, *others_[leg]).is_undecided()) continue;
      for (const int sign : {1, -1}) {
        const int here = sign > 0 ? positive : negative, other = nearest_.of(*there, *others_[leg], sign);
        if (here != 0 && other != 0) leaves_[{Crossing::serial, leg, sign, here, other}].push_back(node);
      }
    }
  }

  const AspectMap::Contents& map_;
  const NearestAspects& nearest_;
  std::size_t mode_;
  const MapControl& control_;
  bool has_parallel_, has_serial_ = false;          // among the classes that are searched
  std::vector<std::optional<std::size_t>> others_;  // by leg
  std::map<Key, std::vector<NodeIndex>> leaves_;
};

NodeIndex smaller(const PoseTree& tree, NodeIndex one, NodeIndex other) {
  return tree.box(one).width(0) < tree.box(other).width(0) ? one : other;
}

}  // namespace

NearestAspects::NearestAspects(const AspectMap::Contents& map, const GateClasses& classes,
                               const MapControl& control)
    : nearest_(2 * map.modes.size()), touching_(map.modes.size()) {
  tbb::parallel_for(std::size_t{0}, map.modes.size(), [&](std::size_t mode) {
    if (!classes.is_needed(mode) || is_cancelled(control)) return;
    const NearestOfMode of_mode(map, mode, control);
    for (const int sign : {1, -1}) nearest_[2 * mode + (sign > 0 ? 1 : 0)] = of_mode.run(sign);
    if (!classes.is_searched({Crossing::parallel, mode, 0})) return;
    const auto is_of_sign = [&](NodeIndex leaf, int sign) {
      return map.tree.state(leaf, mode).may_be(sign) && of(leaf, mode, sign) != 0 &&
             of(leaf, mode, -sign) == 0;
    };
    of_mode.visit_pairs([&](NodeIndex one, NodeIndex other) {
      if (is_of_sign(one, 1) && is_of_sign(other, -1))
        touching_[mode].push_back({smaller(map.tree, one, other), of(one, mode, 1), of(other, mode, -1)});
    });
  });
}

std::vector<int> nearest_aspects(const AspectMap::Contents& map, std::size_t mode, int sign,
                                 const MapControl& control) {
  return NearestOfMode(map, mode, control).run(sign);
}

std::vector<GateLeaves> find_gate_leaves(const AspectMap::Contents& map, const GateClasses& classes,
                                         const NearestAspects& nearest, const MapControl& control) {
  std::vector<std::vector<GateLeaves>> of_mode(map.modes.size());
  tbb::parallel_for(std::size_t{0}, map.modes.size(), [&](std::size_t mode) {
    if (!is_cancelled(control)) of_mode[mode] = ModeLeaves(map, classes, nearest, mode, control).run();
  });
  std::vector<GateLeaves> result;
  for (auto& gates : of_mode)
    for (auto& gate : gates) result.push_back(std::move(gate));
  return result;
}

}  // namespace parallel_aspects
