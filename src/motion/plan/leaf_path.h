// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_LEAF_PATH_H
#define PARALLEL_ASPECTS_MOTION_PLAN_LEAF_PATH_H

#include "aspects/components/disjoint_sets.h"
#include "aspects/map/map_contents.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace parallel_aspects {

class FaceComponents;

/// From an inside leaf to another one of the aspect, which may share no face with it.
struct LeafPassage {
  NodeIndex to = no_node;
  std::vector<Pose> poses;     ///< the first in the one leaf, the last in the other
  NodeIndex beside = no_node;  ///< of `passages_beside`, the undecided leaf between
};

/// Those that begin in a leaf.
using LeafPassages = std::unordered_map<NodeIndex, std::vector<LeafPassage>>;

/// Which passages of `passages_beside` are proved free: by the leaf where they begin, that between, and that
/// where they end.
using PassageProofs = std::map<std::array<NodeIndex, 3>, bool>;

/// From this inside leaf through one undecided leaf beside both, where its faces to them are nearest to each
/// other, maybe in one pose; whether the segment is free is not proved.
std::vector<LeafPassage> passages_beside(const AspectMap::Contents& map, const Aspect& aspect,
                                         NodeIndex leaf);

/// Climbs, as those by which a map joins what no faces of inside leaves connect, from parts other than the
/// largest to the first leaf of another part, and back. Each segment is proved. Some of them where it is
/// cancelled.
LeafPassages climbs_between_parts(const AspectMap::Contents& map, const Aspect& aspect,
                                  FaceComponents& components, const MapControl& control);

/// How far the platform moves from one pose to another: the distance of the operational point, and the
/// rotation times the characteristic length [m].
double distance_between(const Manipulator& manipulator, const Pose& from, const Pose& to);

/// A pose of a path through leaves, and the leaf that is entered there.
struct LeafStep {
  Pose pose;
  NodeIndex leaf = no_node;
};

/// Which leaves a path may pass, and by which it begins and ends.
struct LeafChoice {
  std::vector<NodeIndex> first, last;  ///< of `leaves_near` the ends
  bool undecided =
      false;  ///< those with the aspect's sign at their middle too; what lies there is not proved

  /// Where they are given, from an inside leaf to another by these, and beside one undecided leaf between
  /// them along a segment that `is_free` proves: in narrow corridors leaves touch at corners alone.
  const LeafPassages* passages = nullptr;
  std::function<bool(const Pose&, const Pose&)> is_free{};
  PassageProofs* proofs = nullptr;  ///< with `passages`: what `is_free` answered, for other searches as well

  MapControl control{};  ///< where it is cancelled, no path is found

  /// Parallel index that the path is to keep; where it cannot, one as large as it can by the middles of the
  /// leaves. 0 where it is to be short.
  double wanted_index = 0.0;

  /// Not from the one to the other; an end of the path is `no_node`.
  std::set<std::pair<NodeIndex, NodeIndex>> barred{};
};

/// Which inside leaves of one working mode faces between inside leaves connect.
class FaceComponents {
 public:
  FaceComponents(const AspectMap::Contents& map, std::size_t mode);

  bool are_connected(NodeIndex a, NodeIndex b) { return part_of(a) == part_of(b); }

  /// The leaf that stands for all that are connected with this one.
  NodeIndex part_of(NodeIndex leaf) { return sets_.find(leaf); }

 private:
  DisjointSets sets_;
};

/// The parallel index at the middle of leaves in one working mode, of those where it was asked for.
using LeafIndices = std::unordered_map<NodeIndex, double>;

/// Inside leaves of an aspect that hold a pose or are near it, the nearest first.
std::vector<NodeIndex> leaves_near(const AspectMap::Contents& map, const Aspect& aspect, const Pose& pose);

/// The pose itself where the leaf holds it.
Pose nearest_in(const AspectMap::Contents& map, NodeIndex leaf, const Pose& pose);

/// Steps from one pose to another through leaves of one aspect that share faces, or have a passage between
/// them: the first pose, a pose of each face, the poses of each passage, or the middle of an undecided leaf,
/// and the last, with `no_node`; where an index is wanted, through the middles of all leaves. Else wide
/// leaves are preferred, since little is near that ends the aspect. Empty where no leaf to begin with is
/// connected with one to end with. `components` and `indices` are those of the aspect's working mode.
std::vector<LeafStep> find_leaf_path(const AspectMap::Contents& map, FaceComponents& components,
                                     LeafIndices& indices, int aspect, const Pose& from, const Pose& to,
                                     const LeafChoice& choice);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_LEAF_PATH_H
