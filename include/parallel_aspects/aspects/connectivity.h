// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CONNECTIVITY_H
#define PARALLEL_ASPECTS_ASPECTS_CONNECTIVITY_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/singularity/indices.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// What two aspects that touch have between them.
enum class Crossing {
  serial,  ///< B_jj = 0 of one leg, whose sign changes: the working modes differ in it, det A keeps its sign
  parallel,  ///< det A = 0, whose sign changes; the working mode stays
};

/// A proved place where two aspects touch.
struct GateCrossing {
  /// The segment: its two ends, or three poses where it goes through a glued face of the space of poses. A
  /// serial one begins in both aspects, a parallel one in that with positive det A.
  std::vector<Pose> segment;

  Pose pose;  ///< in the middle of the segment

  /// How far from other singularities and from limits it is: where it begins, the least of the other indices
  /// and of how far each actuated joint is from its nearest limit, over half of its range. From 0 to 1, no
  /// bound.
  double index = 0.0;
};

/// Two aspects that touch, or that may.
///
/// Proved of a serial crossing: there is a segment of poses from one that lies in both aspects, in the one's
/// working mode and in the other's, to one that `leg` does not reach. Up to where B_jj first is zero the legs
/// reach within limits, no other B_jj is zero, and det A has the aspects' sign in both modes, at B_jj = 0
/// too. So the robot can go there in one mode and come back in the other, through this singularity alone.
///
/// A serial margin keeps the aspects of different working modes apart. Such a crossing then leads through
/// what the margin shuts out: it is lifted for `leg`, and all others are kept all along.
///
/// Proved of a parallel crossing: there is a segment of poses from one aspect to the other all along which
/// the legs reach within limits, no B_jj is zero, and det A is zero exactly once, where it changes sign at a
/// rate that is not zero.
///
/// Not proved: such configurations were found close to each other, in one leaf, but no segment was.
struct Neighbours {
  int first = 0;                           ///< id, the lower one
  int second = 0;                          ///< id, the higher one
  Crossing crossing = Crossing::parallel;  ///< what is between them
  std::size_t leg = 0;                     ///< whose B_jj is zero, where serial
  bool proved = false;                     ///< whether the contact is, as above
  Pose pose;  ///< in the leaf where they touch; where proved, that of the first crossing

  /// Where proved, the best crossings of those that were tried, spread over where the aspects touch: the one
  /// with the largest index first.
  std::vector<GateCrossing> crossings;
};

/// Pairs of aspects that touch, by rising ids, across glued faces of the space of poses too. They are looked
/// for in undecided leaves from which undecided leaves lead to both, in up to a few hundred for each two
/// aspects. Of pairs that are not listed nothing is claimed. Empty where cancelled.
std::vector<Neighbours> find_neighbours(const AspectMap& map, const MapControl& control = {});

/// "serial" or "parallel".
const char* name(Crossing crossing) noexcept;

/// Aspects that are proved to be joined through serial singularities: the robot gets from each to each other
/// one, changing its working mode on the way, and never loses control of the platform. All have one sign of
/// det A.
struct AspectSet {
  std::vector<int> aspects;  ///< ids, rising
  int determinant_sign = 0;  ///< +1 or -1
  double workspace_lower =
      0.0;  ///< volume of the poses proved to lie in one of them or more, see `measure_unit`
};

/// The aspects of a map as nodes, and the gates between them.
struct AspectGraph {
  std::vector<Neighbours> gates;  ///< as `find_neighbours` lists them
  std::vector<AspectSet> sets;    ///< by their lowest id; every aspect is in one

  /// Lower bound of the number of different sets that these are parts of, proved: within the region of the
  /// map there is no path between two of so many, whatever serial singularities it goes through.
  std::size_t proved_set_count = 0;

  /// By index of a set, the first set that it is not proved to be different from: its own index for each of
  /// the `proved_set_count`.
  std::vector<std::size_t> set_group;

  /// Index of the set that holds an aspect.
  std::size_t set_of(int aspect) const noexcept;
};

/// Finds the gates and joins the aspects. Sets with different signs of det A are different; of others that is
/// proved by the leaves in which B_jj = 0 is not excluded, of a map of all working modes without a serial
/// margin. The map keeps what was found for those who ask again, and `save_map` writes it. Null where
/// cancelled.
std::shared_ptr<const AspectGraph> compute_aspect_graph(const AspectMap& map, const MapControl& control = {});

/// What is proved of an index: it is no less than `lower` and no more than `upper`.
struct IndexRange {
  double lower = 0.0;                                      ///< 0 where nothing is proved
  double upper = std::numeric_limits<double>::infinity();  ///< infinite where nothing is proved
};

/// A part of an aspect that is deep: around its deepest pose the index is proved to be higher than on any
/// path to a deeper part. As a margin from parallel singularities grows, an aspect falls apart into its
/// basins.
struct Basin {
  int aspect = 0;    ///< id
  Pose deepest;      ///< where the index is the lower end of `depth` or more
  IndexRange depth;  ///< the largest index on any path from there that stays above `saddle.upper`

  /// Index, in the list, of the deeper basin that it is connected with first as the margin falls; none where
  /// the index is not proved to be higher in it than on the way to a deeper one.
  std::optional<std::size_t> deeper;

  /// The largest index that a path to that basin can keep; its lower end is 0 where the two are not proved to
  /// lie in one aspect. Below the lower end of `depth`.
  IndexRange saddle;
};

/// How deep the aspects of a map are, and how well they are connected.
struct MapBasins {
  ParallelIndex index = ParallelIndex::normalised;  ///< by which all of it is measured

  /// The largest index in each aspect, by id - 1, and in what is connected with it and in no other aspect
  /// that is listed.
  std::vector<IndexRange> deepest;

  /// The largest index that a path between the two aspects of each pair of `AspectMap::unresolved` can keep,
  /// in that order. Its lower end is 0.
  std::vector<IndexRange> bottlenecks;

  std::vector<Basin> basins;  ///< where asked for: by working mode and sign of det A, the deepest first
};

/// How much is searched for.
enum class BasinDetail {
  depths,  ///< no basins
  basins,  ///< all, in about three times the time
};

/// Finds them in the leaves of a map, by two passes over them: by falling lower and by falling upper bounds
/// of the index. Nothing when cancelled.
std::optional<MapBasins> find_basins(const AspectMap& map, ParallelIndex index, BasinDetail detail,
                                     const MapControl& control = {});

/// What is known of the paths between two poses of a map.
enum class BottleneckStatus {
  found,          ///< they lie in one aspect or could do so
  separate,       ///< proved: no path in the region of the map connects them
  not_in_aspect,  ///< one of them is not proved to lie in an aspect, or the signs of det A differ
  cancelled,
};

/// The largest index that a path between two poses can keep.
struct Bottleneck {
  BottleneckStatus status = BottleneckStatus::not_in_aspect;  ///< what is known
  std::string message;                                        ///< why, unless found
  IndexRange index;        ///< where found; its lower end is 0 where they are not proved to be connected
  std::size_t halved = 0;  ///< how many boxes were divided for it
};

/// How precisely it is searched for. The search ends where the bounds differ by no more than the larger of
/// `relative` and `absolute`, or have taken too much work; they hold either way.
struct BottleneckPrecision {
  double relative = 0.05;        ///< of the upper bound
  double absolute = 0.001;       ///< of the normalised index; for |det A|, whose unit varies, none
  std::size_t boxes = 400000;    ///< that are divided at most
  std::size_t visits = 2000000;  ///< of boxes while paths are searched for, after which no more are divided
};

/// Looks for it in one working mode, within the region of the map, dividing leaves where that matters.
Bottleneck find_bottleneck(const AspectMap& map, const WorkingMode& mode, const Pose& from, const Pose& to,
                           ParallelIndex index, const BottleneckPrecision& precision = {},
                           const MapControl& control = {});

/// "parallel" or "det_a", as questions name them.
const char* name(ParallelIndex index) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CONNECTIVITY_H
