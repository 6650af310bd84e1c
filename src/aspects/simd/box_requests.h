// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SIMD_BOX_REQUESTS_H
#define PARALLEL_ASPECTS_ASPECTS_SIMD_BOX_REQUESTS_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/boxes/part_proof.h"
#include "aspects/tree/neighbour_leaves.h"

#include <vector>

namespace parallel_aspects {

/// A box that is to be classified.
struct BoxRequest {
  RootIndex root;
  Box box;
  ModeSet modes;
  LeafState* states;  ///< to be written, by mode
};
using BoxRequests = std::vector<BoxRequest>;

/// Whose vectors boxes are classified in, as many at once as they have lanes: two or four. With `none` one by
/// one. What is found is the same to the last digit.
enum class InstructionSet { none, sse2, avx2 };

/// Whether this processor has it.
bool has_instructions(InstructionSet instructions) noexcept;

/// The widest that this processor has.
InstructionSet widest_instructions() noexcept;

/// What maps are computed with: the widest, unless tests or measurements use another that the processor has.
InstructionSet instructions_in_use() noexcept;
void use_instructions(InstructionSet instructions) noexcept;

/// As `BoxClassifier::classify` for each box, several at a time where the robot and the detail allow it; the
/// processor must have the instructions. A live `RoundingUpward` is required.
void classify(const BoxClassifier& classifier, const BoxRequests& requests, Detail detail,
              InstructionSet instructions = instructions_in_use()) noexcept;

/// As `find_part` for each of these boxes.
std::vector<Part> find_parts(const BoxClassifier& classifier, std::size_t mode, int sign,
                             std::vector<SharedFace> boxes,
                             InstructionSet instructions = instructions_in_use());

/// A box of which an index is to be bounded, and the share of `BoxClassifier::enclose_index`.
struct IndexRequest {
  RootIndex root;
  Box box;
  double share;
};

/// As `BoxClassifier::enclose_index` for each of these boxes.
std::vector<Interval> enclose_index(const BoxClassifier& classifier, std::size_t mode, int sign,
                                    ParallelIndex index, const std::vector<IndexRequest>& boxes,
                                    InstructionSet instructions = instructions_in_use());

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SIMD_BOX_REQUESTS_H
