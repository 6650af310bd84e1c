// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/constraints/serial_margin.h"
#include "aspects/graph/joined_sets.h"
#include "aspects/map/map_contents.h"
#include "parallel_aspects/aspects/connectivity.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>

namespace parallel_aspects {
namespace {

std::uint32_t index_of_aspect(int id) { return static_cast<std::uint32_t>(id - 1); }

/// Measures what the inside leaves of some aspects cover, each pose once; anything when cancelled.
class Workspace {
 public:
  Workspace(const AspectMap::Contents& map, const AspectSet& set, const MapControl& control)
      : map_(map), control_(control), belongs_(map.aspects.size() + 1) {
    for (const int aspect : set.aspects) belongs_[static_cast<std::size_t>(aspect)] = true;
  }

  double measure() const {
    ModeSet all = 0;
    for (std::size_t mode = 0; mode < map_.modes.size(); ++mode) all |= ModeSet{1} << mode;
    double sum = 0.0;
    for (RootIndex root = 0; root < map_.tree.root_count(); ++root) sum += measure(root, all);
    return sum;
  }

 private:
  /// Of a node, where `modes` are those that no leaf above it ends.
  double measure(NodeIndex node, ModeSet modes) const {
    ModeSet divided = 0;
    for (std::size_t mode = 0; mode < map_.modes.size(); ++mode) {
      if ((modes >> mode & 1U) == 0) continue;
      if (map_.tree.state(node, mode).is_divided()) divided |= ModeSet{1} << mode;
      const int aspect = map_.leaf_aspect(node, mode);
      if (belongs_[static_cast<std::size_t>(aspect)]) return map_.tree.space().measure(map_.tree.box(node));
    }
    if (divided == 0 || is_cancelled(control_)) return 0.0;
    double sum = 0.0;
    const NodeIndex first = map_.tree.first_child(node);
    for (NodeIndex rank = 0; rank < map_.tree.children_per_node(); ++rank)
      sum += measure(first + rank, divided);
    return sum;
  }

  const AspectMap::Contents& map_;
  const MapControl& control_;
  std::vector<bool> belongs_;  // by id; not 0
};

/// A path may go through every working mode, and through poses that a serial margin excludes: unless the map
/// covers all of these, its leaves prove nothing.
bool leaves_exclude(const AspectMap& map) {
  return map.contents().modes.size() == working_modes(*map.manipulator()).size() &&
         !has_serial_margin(*map.manipulator());
}

std::size_t count_of_sign(const std::vector<AspectSet>& sets, int sign) {
  return static_cast<std::size_t>(std::count_if(
      sets.begin(), sets.end(), [sign](const AspectSet& set) { return set.determinant_sign == sign; }));
}

void find_groups(const AspectMap& map, const MapControl& control, AspectGraph& graph) {
  if (!leaves_exclude(map)) return group_sets([](int, int) { return true; }, graph);
  std::array<std::vector<int>, 2> labels;
  for (const int sign : {1, -1})
    if (count_of_sign(graph.sets, sign) > 1)
      labels[sign > 0] = possibly_joined(map.contents(), graph.sets, sign, control);
  group_sets(
      [&](int one, int other) {
        const auto& of_sign = labels[map.aspects()[index_of_aspect(one)].determinant_sign > 0];
        return of_sign[index_of_aspect(one)] == of_sign[index_of_aspect(other)];
      },
      graph);
}

}  // namespace

std::size_t AspectGraph::set_of(int aspect) const noexcept {
  for (std::size_t i = 0; i < sets.size(); ++i)
    if (std::binary_search(sets[i].aspects.begin(), sets[i].aspects.end(), aspect)) return i;
  return sets.size();
}

std::shared_ptr<const AspectGraph> compute_aspect_graph(const AspectMap& map, const MapControl& control) {
  if (auto known = std::atomic_load(&map.contents().graph)) return known;
  AspectGraph graph;
  graph.gates = find_neighbours(map, control);
  std::vector<int> signs;
  for (const Aspect& aspect : map.aspects()) signs.push_back(aspect.determinant_sign);
  graph.sets = joined_sets(signs, graph.gates);
  for (AspectSet& set : graph.sets) set.workspace_lower = Workspace(map.contents(), set, control).measure();
  find_groups(map, control, graph);
  if (is_cancelled(control)) return nullptr;
  auto found = std::make_shared<const AspectGraph>(std::move(graph));
  std::atomic_store(&map.contents().graph, found);
  return found;
}

}  // namespace parallel_aspects
