// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_SINGULAR_LEAVES_H
#define PARALLEL_ASPECTS_DISTANCE_SINGULAR_LEAVES_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace parallel_aspects {

/// A pose that others are seen from, exactly: the centroid of the anchors [m], then the part (x, y, z, w) of
/// a quaternion that turns in the task space; of SO3 the quaternion alone.
using LeafCenter = std::array<float, 4>;

/// A part of a map that may hold a parallel singularity. In the coordinates y of a local_chart about the
/// center, all of it has |y| <= radius, and every singularity in it |normal . y - offset| <= thickness:
/// within a leaf the surface det A = 0 is nearly plane. A leaf of which that is not proved has no normal.
struct SingularLeaf {
  LeafCenter center{};
  float radius = 0.0F;
  std::array<float, 3> normal{};  ///< of length 1 to rounding, or 0
  float offset = 0.0F, thickness = 0.0F;

  bool has_plane() const noexcept { return normal != std::array<float, 3>{}; }
};

/// D of no part of some leaves from the center is more than the radius.
struct LeafBall {
  LeafCenter center{};
  float radius = 0.0F;
};

/// The leaves of one working mode, and balls about them: those of level 0 about `children` leaves each, those
/// of higher levels about as many balls of the one below, in order.
struct LeafTree {
  static constexpr std::size_t children = 8;
  std::vector<SingularLeaf> leaves;
  std::vector<std::vector<LeafBall>> levels;  ///< the last has one ball; none where there is no leaf
};

/// All parts of a map that may hold a parallel singularity, a pose that every leg reaches with det A = 0,
/// whether or not within limits. Immutable.
class SingularLeaves {
 public:
  /// Looks into every leaf that is not inside an aspect, on all threads of the calling arena. Where `control`
  /// cancels it, `complete()` is false.
  SingularLeaves(const AspectMap::Contents& map, const MapControl& control);

  bool complete() const noexcept { return complete_; }

  const LeafTree& of(std::size_t mode) const noexcept { return trees_[mode]; }  ///< by its index in the map

  /// Poses beyond these ends of a coordinate of the operational point were not mapped, and may be reached;
  /// infinite where that is proved not to be so [m].
  struct Ends {
    std::array<double, 3> lower{}, upper{};
  };
  const Ends& ends() const noexcept { return ends_; }

  /// No coordinate of a center is larger [m].
  double extent() const noexcept { return extent_; }

  std::size_t bytes() const noexcept;  ///< of memory that it takes

 private:
  std::vector<LeafTree> trees_;
  Ends ends_;
  double extent_ = 0.0;
  bool complete_ = false;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_SINGULAR_LEAVES_H
