// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_BOX_PARTS_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_BOX_PARTS_H

#include "parallel_aspects/aspects/box.h"

#include <cstddef>
#include <cstdint>

namespace parallel_aspects {

/// The half, quarter or eighth of this rank (see `Box::rank_of`). Parts of one box share their corners bit
/// for bit, however the middle is rounded.
inline Box part_of(const Box& box, std::uint32_t rank) noexcept {
  Box part = box;
  for (std::size_t i = 0; i < box.dimension; ++i)
    ((rank >> i & 1U) != 0 ? part.lower : part.upper)[i] = box.center(i);
  return part;
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_BOX_PARTS_H
