// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/graph/joined_sets.h"

#include "aspects/components/disjoint_sets.h"
#include "aspects/map/map_contents.h"
#include "aspects/tree/neighbour_leaves.h"
#include "interval/interval.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace parallel_aspects {

std::vector<AspectSet> joined_sets(const std::vector<int>& signs, const std::vector<Neighbours>& gates) {
  DisjointSets joined(signs.size());
  for (const Neighbours& gate : gates)
    if (gate.proved && gate.crossing == Crossing::serial)
      joined.unite(static_cast<std::uint32_t>(gate.first - 1), static_cast<std::uint32_t>(gate.second - 1));
  std::map<std::uint32_t, AspectSet> sets;
  for (std::uint32_t i = 0; i < signs.size(); ++i) {
    AspectSet& set = sets[joined.find(i)];
    set.aspects.push_back(static_cast<int>(i) + 1);
    set.determinant_sign = signs[i];
  }
  std::vector<AspectSet> result;
  for (auto& item : sets) result.push_back(std::move(item.second));
  return result;
}

void group_sets(const std::function<bool(int, int)>& may_join, AspectGraph& graph) {
  const std::vector<AspectSet>& sets = graph.sets;
  graph.set_group.assign(sets.size(), 0);
  graph.proved_set_count = 0;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    std::size_t& group = graph.set_group[i] = i;
    for (std::size_t k = 0; k < i && group == i; ++k)
      if (sets[k].determinant_sign == sets[i].determinant_sign &&
          may_join(sets[k].aspects.front(), sets[i].aspects.front()))
        group = graph.set_group[k];
    graph.proved_set_count += group == i ? 1 : 0;
  }
}

namespace {

class Exclusion {
 public:
  Exclusion(const AspectMap::Contents& map, int sign, const MapControl& control)
      : map_(map),
        sign_(sign),
        control_(control),
        sets_(map.tree.node_count() * map.modes.size()),
        holds_aspect_(sets_.size()),
        leaf_of_(map.aspects.size(), none) {}

  std::vector<int> run(const std::vector<AspectSet>& sets) {
    const RoundingUpward rounding;
    unite_aspects();
    unite_sets(sets);
    for (std::size_t mode = 0; mode < map_.modes.size() && !are_all_one(); ++mode) unite_neighbours(mode);
    for (std::size_t mode = 0; mode < map_.modes.size(); ++mode)
      for (std::size_t leg = 0; leg < map_.modes[mode].leg_count(); ++leg) unite_across(mode, leg);
    return labels();
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  void unite_aspects() {
    for (NodeIndex node = 0; node < map_.tree.node_count(); ++node)
      for (std::size_t mode = 0; mode < map_.modes.size(); ++mode) {
        if (!map_.tree.state(node, mode).is_inside(sign_)) continue;
        std::uint32_t& first = leaf_of_[static_cast<std::size_t>(map_.leaf_aspect(node, mode) - 1)];
        if (first == none) add_aspect(first = item(node, mode));
        unite(first, item(node, mode));
      }
  }

  void unite_sets(const std::vector<AspectSet>& sets) {
    for (const AspectSet& set : sets) {
      if (set.determinant_sign != sign_) continue;
      for (const int id : set.aspects) unite(leaf_of(set.aspects.front()), leaf_of(id));
    }
  }

  std::uint32_t leaf_of(int aspect) const { return leaf_of_[static_cast<std::size_t>(aspect - 1)]; }

  void add_aspect(std::uint32_t leaf) {
    holds_aspect_[leaf] = true;
    ++parts_;
  }

  /// Counts as sets are joined, since examining all aspects after each step would cost more than the steps.
  void unite(std::uint32_t a, std::uint32_t b) {
    a = sets_.find(a);
    b = sets_.find(b);
    if (a == b) return;
    sets_.unite(a, b);
    if (holds_aspect_[a] && holds_aspect_[b]) --parts_;
    holds_aspect_[sets_.find(a)] = holds_aspect_[a] || holds_aspect_[b];
  }

  /// Whether no two sets are left to be separated.
  bool are_all_one() const { return parts_ <= 1; }

  std::uint32_t item(NodeIndex node, std::size_t mode) const {
    return static_cast<std::uint32_t>(node * map_.modes.size() + mode);
  }

  bool may_hold_path(NodeIndex leaf, std::size_t mode) const {
    return map_.tree.state(leaf, mode).may_be(sign_);
  }

  void unite_neighbours(std::size_t mode) {
    visit_faces(
        map_.tree, mode,
        [&](NodeIndex a, NodeIndex b) {
          if (may_hold_path(a, mode) && may_hold_path(b, mode)) unite(item(a, mode), item(b, mode));
        },
        control_);
  }

  /// Once for the two modes that differ in this leg.
  void unite_across(std::size_t mode, std::size_t leg) {
    if (map_.modes[mode].sign(leg) < 0) return;
    WorkingMode flipped = map_.modes[mode];
    flipped.set_sign(leg, -1);
    const auto other = mode_index(map_, flipped);
    if (!other) return;
    for (RootIndex root = 0; root < map_.tree.root_count(); ++root)
      descend(root, {mode, root}, {*other, root}, leg);
  }

  /// Where one mode stands: in this node, or in a leaf above it.
  struct Side {
    std::size_t mode;
    NodeIndex node;
  };

  /// A path changes the sign of B_jj only at a pose that is in an undecided leaf of both modes: pairs without
  /// are left out.
  void descend(NodeIndex node, Side here, Side there, std::size_t leg) {
    if (are_all_one() || is_cancelled(control_)) return;
    const bool here_divided = is_divided(here), there_divided = is_divided(there);
    if (!here_divided && !may_change(here)) return;
    if (!there_divided && !may_change(there)) return;
    if (!here_divided && !there_divided) return unite_if_singular(node, here, there, leg);
    const NodeIndex first = map_.tree.first_child(node);
    for (NodeIndex child = first; child < first + map_.tree.children_per_node(); ++child)
      descend(child, here_divided ? Side{here.mode, child} : here,
              there_divided ? Side{there.mode, child} : there, leg);
  }

  bool is_divided(const Side& side) const { return map_.tree.state(side.node, side.mode).is_divided(); }

  /// Inside leaves hold no B_jj = 0.
  bool may_change(const Side& side) const {
    return map_.tree.state(side.node, side.mode).is_undecided() && may_hold_path(side.node, side.mode);
  }

  /// `node` is the smaller one of the two leaves.
  void unite_if_singular(NodeIndex node, const Side& here, const Side& there, std::size_t leg) {
    if (sets_.find(item(here.node, here.mode)) == sets_.find(item(there.node, there.mode))) return;
    const BoxFacts facts = map_.classifier->facts(map_.tree.place(node).root, map_.tree.box(node), here.mode);
    const bool is_excluded =
        facts.unreachable != 0 || is_clear(facts, leg) || facts.determinant_sign == -sign_;
    if (is_excluded) return;
    unite(item(here.node, here.mode), item(there.node, there.mode));
  }

  /// Whether B_jj of the leg is proved not to vanish; the facts have nothing about a leg whose joint is held.
  bool is_clear(const BoxFacts& facts, std::size_t leg) const {
    const bool is_held = map_.slice && map_.slice->joint && map_.slice->joint->leg == leg;
    return !is_held && (facts.clear & BoxFacts::bit(leg)) != 0;
  }

  std::vector<int> labels() {
    std::vector<int> result;
    for (const std::uint32_t leaf : leaf_of_)
      result.push_back(leaf == none ? -1 : static_cast<int>(sets_.find(leaf)));
    return result;
  }

  const AspectMap::Contents& map_;
  int sign_;
  const MapControl& control_;
  DisjointSets sets_;
  std::vector<bool> holds_aspect_;      // by the item that stands for its set
  std::size_t parts_ = 0;               // sets that hold an aspect
  std::vector<std::uint32_t> leaf_of_;  // by id - 1, one leaf of each aspect with this sign
};

}  // namespace

std::vector<int> possibly_joined(const AspectMap::Contents& map, const std::vector<AspectSet>& sets, int sign,
                                 const MapControl& control) {
  return Exclusion(map, sign, control).run(sets);
}

}  // namespace parallel_aspects
