// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_CROSSING_PROOF_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_CROSSING_PROOF_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/tree/pose_space.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// A straight segment of poses in a root box.
struct CrossingSegment {
  std::size_t dimension = 0;
  RootIndex root = 0;
  MapPoint from{}, to{};
};

/// A way of one segment, or of two that meet on a glued face: the end of the first and the start of the
/// second are then one pose, in the coordinates of either side.
struct CrossingPath {
  std::array<CrossingSegment, 2> segments;
  std::size_t count = 1;

  const CrossingSegment& last() const noexcept { return segments[count - 1]; }
};

/// Whether the path is proved to lead through B_jj = 0 of `leg` (see Neighbours), from a pose where det A
/// is proved to have this sign in both modes. The modes, by their index in the classifier, differ in this leg
/// only. Needs a live `RoundingUpward`.
bool crosses_serial_singularity(const BoxClassifier& classifier, const CrossingPath& path, std::size_t mode,
                                std::size_t other_mode, std::size_t leg, int sign) noexcept;

/// Whether the path is proved to lead through det A = 0 once (see Neighbours), from where det A is proved
/// to be positive to where it is proved to be negative. Needs a live `RoundingUpward`.
bool crosses_parallel_singularity(const BoxClassifier& classifier, const CrossingPath& path,
                                  std::size_t mode) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_CROSSING_PROOF_H
