// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/base_map.h"

#include "aspects/batches/box_requests.h"
#include "aspects/symmetry/level_symmetry.h"
#include "interval/interval.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace parallel_aspects {
namespace {

// Between two blocks progress is reported and cancelling is possible; a block takes some ten milliseconds.
constexpr NodeIndex nodes_per_block = 4096;
constexpr NodeIndex nodes_per_task = 128;

void classify_block(PoseTree& tree, const BoxClassifier& classifier, const LevelSymmetry& symmetry,
                    Detail detail, NodeIndex begin, NodeIndex end) {
  tbb::parallel_for(tbb::blocked_range<NodeIndex>(begin, end, nodes_per_task), [&](const auto& range) {
    const RoundingUpward rounding;
    BoxRequests requests;
    requests.reserve(range.size());
    for (NodeIndex node = range.begin(); node != range.end(); ++node)
      if (const ModeSet modes = symmetry.own_modes(tree, node); modes != 0)
        requests.push_back({tree.place(node).root, tree.box(node), modes, tree.states(node)});
    classify(classifier, requests, detail);
  });
}

bool is_undecided(const PoseTree& tree, NodeIndex node) {
  for (std::size_t mode = 0; mode < tree.mode_count(); ++mode)
    if (tree.state(node, mode).is_undecided()) return true;
  return false;
}

/// Ends early when cancelled.
void divide_undecided(PoseTree& tree, NodeIndex begin, NodeIndex end, const MapControl& control) {
  const auto is_time_to_look = [](std::size_t done) { return done % nodes_per_block == 0; };
  std::vector<NodeIndex> undecided;
  for (NodeIndex node = begin; node != end; ++node) {
    if (is_time_to_look(node - begin) && is_cancelled(control)) return;
    if (is_undecided(tree, node)) undecided.push_back(node);
  }
  tree.reserve_families(undecided.size());
  for (std::size_t i = 0; i < undecided.size(); ++i) {
    if (is_time_to_look(i) && is_cancelled(control)) return;
    tree.divide(undecided[i], [](std::size_t) { return true; });
  }
}

/// Nodes lie along curves and surfaces, so each level costs 2^(d-1) times the one before.
class Progress {
 public:
  Progress(const MapControl& control, std::size_t dimension, std::uint32_t depth)
      : control_(control), growth_(std::ldexp(1.0, static_cast<int>(dimension) - 1)), depth_(depth) {}

  void tell(std::uint32_t level, double share_of_level) const {
    if (!control_.progress) return;
    const double cost_after = std::pow(growth_, static_cast<double>(level) - depth_);
    const double cost_before = level == 0 ? 0.0 : cost_after / growth_;
    control_.progress(cost_before + (cost_after - cost_before) * share_of_level);
  }

 private:
  const MapControl& control_;
  double growth_;
  std::uint32_t depth_;
};

}  // namespace

BaseMapStatus grow_base_map(PoseTree& tree, const BoxClassifier& classifier, std::uint32_t depth,
                            Detail detail, const MapControl& control,
                            const std::vector<MapSymmetry>& symmetries) {
  LevelSymmetry symmetry(tree, symmetries);
  const Progress progress(control, tree.dimension(), depth);
  NodeIndex begin = 0;
  for (std::uint32_t level = 0; level <= depth; ++level) {
    const auto end = static_cast<NodeIndex>(tree.node_count());
    for (NodeIndex block = begin; block < end; block += nodes_per_block) {
      if (is_cancelled(control)) return BaseMapStatus::cancelled;
      const NodeIndex block_end = std::min(end, block + nodes_per_block);
      classify_block(tree, classifier, symmetry, level < depth ? Detail::states : detail, block, block_end);
      progress.tell(level, static_cast<double>(block_end - begin) / (end - begin));
    }
    symmetry.tell(tree);
    if (level < depth) divide_undecided(tree, begin, end, control);
    if (is_cancelled(control)) return BaseMapStatus::cancelled;
    symmetry.descend(tree);
    if (tree.node_count() > max_nodes) return BaseMapStatus::too_large;
    begin = end;
  }
  return BaseMapStatus::complete;
}

}  // namespace parallel_aspects
