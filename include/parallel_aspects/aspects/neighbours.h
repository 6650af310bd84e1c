// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_NEIGHBOURS_H
#define PARALLEL_ASPECTS_ASPECTS_NEIGHBOURS_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
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
  bool proved = false;                     ///< whether it is, as said above
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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_NEIGHBOURS_H
