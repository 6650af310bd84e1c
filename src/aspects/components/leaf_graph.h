// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_GRAPH_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_GRAPH_H

#include "aspects/components/sign_graph.h"
#include "aspects/tree/pose_tree.h"

#include <cstddef>

namespace parallel_aspects {

/// How the leaves of one working mode are connected, for both signs of det A.
class LeafGraph {
 public:
  /// `looks_everywhere`: see there. The control and the policy must outlive this.
  LeafGraph(const PoseTree& tree, std::size_t mode, bool looks_everywhere, const MapControl& control,
            const ComponentPolicy& policy);

  std::size_t mode() const noexcept { return mode_; }
  bool looks_everywhere() const noexcept { return looks_everywhere_; }
  SignGraph& of(int sign) noexcept { return sign > 0 ? positive_ : negative_; }

  /// After more was proved of an undecided leaf.
  void take_in_proof(const PoseTree& tree, NodeIndex node) {
    positive_.take_in_proof(tree, node);
    negative_.take_in_proof(tree, node);
  }

  /// After a leaf was divided and its children were classified.
  void replace(PoseTree& tree, NodeIndex node);

 private:
  std::size_t mode_;
  bool looks_everywhere_;
  SignGraph positive_, negative_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_GRAPH_H
