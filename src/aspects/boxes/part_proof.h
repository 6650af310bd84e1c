// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_PART_PROOF_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_PART_PROOF_H

#include "aspects/boxes/box_classifier.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// What is proved of the poses of S(mode, sign) in a box.
struct Part {
  enum class Kind {
    empty,
    connected,
    joined,  ///< empty, or all in one aspect, though not by ways in the box alone
    unknown
  };
  Kind kind = Kind::unknown;
  MapPoint
      pose{};  ///< where connected, one of them; where joined, one of that aspect, maybe outside of the box
};

/// Pushes the set onto faces, edges and corners of the box along which it grows (see Monotonicity), until
/// what is left of the box is all inside or has nothing of it. The box may be flat along some coordinates.
/// Needs a live `RoundingUpward`.
Part find_part(const BoxClassifier& classifier, std::size_t mode, int sign, RootIndex root, Box box) noexcept;

/// One step of that: what `examined` tells of the set in the box, or nothing yet, where the box is flattened
/// and is to be examined again.
std::optional<Part> part_or_flatten(const BoxClassifier& classifier, std::size_t mode, int sign,
                                    RootIndex root, const Examined& examined, Box& box) noexcept;

/// The same, and where it stays unknown a search for a wedge (see WedgeProof).
Part find_part_or_wedge(const BoxClassifier& classifier, std::size_t mode, int sign, RootIndex root,
                        const Box& box) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_PART_PROOF_H
