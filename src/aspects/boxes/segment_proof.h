// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_SEGMENT_PROOF_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_SEGMENT_PROOF_H

#include "aspects/boxes/box_classifier.h"

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_SEGMENT_PROOF_H
