// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_contents.h"
#include "aspects/map/map_plan.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_modes = 64;  // the bits of a ModeSet

ModeSet undecided_modes(const PoseTree& tree, NodeIndex node) {
  ModeSet modes = 0;
  for (std::size_t mode = 0; mode < tree.mode_count(); ++mode)
    if (tree.state(node, mode).is_undecided()) modes |= ModeSet{1} << mode;
  return modes;
}

/// In how many undecided modes of a leaf each constraint is unknown.
using Counts = std::array<std::uint8_t, all_constraint_kinds.size()>;

Counts count_unknown(const AspectMap::Contents& map, NodeIndex node) {
  Counts counts{};
  const ModeSet modes = undecided_modes(map.tree, node);
  if (modes == 0) return counts;
  std::array<ConstraintKinds, max_modes> kinds;
  map.classifier->find_unknown_constraints(map.tree.place(node).root, map.tree.box(node), modes,
                                           kinds.data());
  for (std::size_t mode = 0; mode < map.modes.size(); ++mode)
    for (std::size_t k = 0; k < counts.size(); ++k)
      if ((modes >> mode & 1U) != 0 && kinds[mode][k]) ++counts[k];
  return counts;
}

}  // namespace

std::vector<ConstraintBoundary> constraint_boundaries(const AspectMap& map) {
  const AspectMap::Contents& contents = map.contents();
  const ConstraintKinds kinds = contents.manipulator->constraint_kinds();
  if (kinds.none()) return {};
  const PoseTree& tree = contents.tree;
  std::vector<Counts> counts(tree.node_count());
  tbb::parallel_for(tbb::blocked_range<NodeIndex>(0, static_cast<NodeIndex>(tree.node_count())),
                    [&](const auto& range) {
                      const RoundingUpward rounding;
                      for (NodeIndex node = range.begin(); node != range.end(); ++node)
                        counts[node] = count_unknown(contents, node);
                    });
  std::vector<ConstraintBoundary> result;
  for (const ConstraintKind kind : all_constraint_kinds) {
    if (!kinds[index_of(kind)]) continue;
    ConstraintBoundary boundary{kind, 0, 0.0};
    for (NodeIndex node = 0; node < tree.node_count(); ++node) {
      const std::uint8_t count = counts[node][index_of(kind)];
      boundary.leaves += count;
      if (count > 0) boundary.measure += count * tree.space().measure(tree.box(node));
    }
    result.push_back(boundary);
  }
  return result;
}

MissingModes missing_modes(const AspectMap& map) {
  const AspectMap::Contents& contents = map.contents();
  MissingModes result;
  for (std::size_t mode = 0; mode < contents.modes.size(); ++mode) {
    const auto& existing = contents.existing_modes;
    if (std::find(existing.begin(), existing.end(), contents.modes[mode]) != existing.end()) continue;
    bool is_empty = true;
    for (NodeIndex node = 0; node < contents.tree.node_count() && is_empty; ++node)
      is_empty = !contents.tree.state(node, mode).is_undecided();
    (is_empty ? result.empty : result.unknown).push_back(contents.modes[mode]);
  }
  return result;
}

bool is_cut_by_region(const AspectMap& map) {
  const AspectMap::Contents& contents = map.contents();
  if (map.region().dimension == 0 || (map.slice() && map.slice()->joint)) return false;
  const std::optional<Box> reach =
      within_workspace(contents.classifier->reachable_positions(), *contents.manipulator, map.slice());
  if (!reach) return true;
  const Box region = map.region();
  for (std::size_t i = 0; i < reach->dimension; ++i)
    if (!(region.lower[i] <= reach->lower[i] && reach->upper[i] <= region.upper[i])) return true;
  return false;
}

}  // namespace parallel_aspects
