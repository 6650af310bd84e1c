// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_COMPONENTS_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_COMPONENTS_H

#include "aspects/components/sign_graph.h"
#include "aspects/symmetry/map_symmetry.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

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

/// A connected union of inside leaves of one working mode and sign.
struct Component {
  int determinant_sign = 0;
  double measure_inside = 0.0;  ///< of its leaves
  double measure_estimated =
      0.0;                       ///< with the undecided leaves nearest to it whose centers are in S(s, sigma)
  double measure_cluster = 0.0;  ///< with everything that it is not proved separate from
  std::vector<Box> bounds;       ///< of its leaves, by root; of dimension 0 where it has none
  std::size_t cluster = 0;       ///< components of one cluster are not proved separate from each other
  std::vector<NodeIndex> leaves;
};

/// The components of one working mode.
struct ModeComponents {
  std::vector<Component> components;
  std::size_t cluster_count = 0;
  std::vector<std::pair<std::size_t, std::size_t>>
      unresolved;  ///< pairs of components whose undecided leaves meet
  double measure_undecided = 0.0;
  std::size_t indeterminate_leaves =
      0;                  ///< undecided leaves, a sign each, of which it is not known what they hold
  std::size_t bound = 0;  ///< components with those that have no inside leaf, which could be empty
};

/// Sums up what the graph of a working mode has shown.
/// Ends early, unfinished, when cancelled.
ModeComponents find_components(const PoseTree& tree, std::size_t mode, LeafGraph& graph,
                               const MapControl& control);

/// Gives each mode that has a representative the states that this has at the images of its nodes, dividing
/// nodes where need be, and its components. `components` holds those of the representatives, by mode, and has
/// room for all.
void mirror_modes(PoseTree& tree, const std::vector<MapSymmetry>& symmetries,
                  const std::vector<ModeSource>& sources, std::vector<ModeComponents>& components);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_COMPONENTS_H
