// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_FINDER_H
#define PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_FINDER_H

#include "aspects/boxes/box_classifier.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace parallel_aspects {

/// What was found of the set in a box.
struct Stars {
  static constexpr std::size_t most = 16;

  bool is_known = false;  ///< if so, all that the box has of the set is connected with some of the poses each
  std::array<MapPoint, most> poses{};  ///< of the set, maybe a little outside of the box
  std::size_t count = 0;               ///< 0 where the box has nothing of the set

  static Stars none() noexcept {
    Stars result;
    result.is_known = true;
    return result;
  }
  static Stars one(const MapPoint& pose) noexcept {
    Stars result = none();
    result.poses[result.count++] = pose;
    return result;
  }

  /// What is known of two boxes together.
  Stars with(const Stars& other) const noexcept {
    Stars result = *this;
    result.is_known = is_known && other.is_known && count + other.count <= most;
    if (result.is_known) std::copy_n(other.poses.begin(), other.count, result.poses.begin() + count);
    result.count += other.count;
    return result;
  }
};

/// Proves that what S(mode, sign) has in a box is star-shaped about a pose, in coordinates in which its
/// boundary is smooth; docs/theory/maps.md has the proof. Immutable; may be used from any number of threads.
class StarFinder {
 public:
  virtual ~StarFinder() = default;

  /// Of a box within `region`, the root box. Needs a live `RoundingUpward`.
  virtual Stars find(RootIndex root, const Box& box, const Box& region, std::size_t mode,
                     int sign) const noexcept = 0;
};

/// For maps of all poses with two and three degrees of freedom; null for others.
std::unique_ptr<const StarFinder> make_star_finder(const Manipulator& manipulator,
                                                   const std::vector<WorkingMode>& modes);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_FINDER_H
