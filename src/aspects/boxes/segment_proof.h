// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_SEGMENT_PROOF_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_SEGMENT_PROOF_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/tree/pose_space.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// The sign of det A where a position is proved free of singularities and within limits in a working mode (by
/// its index in the classifier); 0 where that is not proved. Needs a live `RoundingUpward`. Neither allocates
/// nor throws.
int proved_sign(const BoxClassifier& classifier, std::size_t dimension, std::size_t mode,
                const MapPosition& position) noexcept;

/// A box around the part of a straight segment between the shares `begin` and `end` of its length. Needs a
/// live `RoundingUpward`.
Box hull(std::size_t dimension, const MapPoint& from, const MapPoint& to, double begin, double end) noexcept;

/// Whether the straight segment between two points of a root box is proved free of singularities and within
/// limits, with det A of the given sign all along: it is covered by boxes, halved where they are too long, at
/// most `max_halvings` times. Needs a live `RoundingUpward`. Neither allocates nor throws.
bool segment_is_free(const BoxClassifier& classifier, std::size_t dimension, std::size_t mode, int sign,
                     const MapPosition& from, const MapPoint& to, int max_halvings = 12) noexcept;

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

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_SEGMENT_PROOF_H
