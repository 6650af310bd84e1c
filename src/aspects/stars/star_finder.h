// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_STARS_STAR_FINDER_H
#define PARALLEL_ASPECTS_ASPECTS_STARS_STAR_FINDER_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/stars/stars.h"
#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace parallel_aspects {

/// Proves that what S(mode, sign) has in a box is star-shaped about a pose, in coordinates in which its
/// boundary is smooth; docs/maps.md has the proof. Immutable; may be used from any number of threads.
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

#endif  // PARALLEL_ASPECTS_ASPECTS_STARS_STAR_FINDER_H
