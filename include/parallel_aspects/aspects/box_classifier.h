// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOX_CLASSIFIER_H
#define PARALLEL_ASPECTS_ASPECTS_BOX_CLASSIFIER_H

#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/leaf_state.h"
#include "parallel_aspects/aspects/pose_space.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// A set of working modes: bit i stands for the i-th of the list that the classifier was made with.
using ModeSet = std::uint64_t;

/// Proves boxes inside or outside, in the coordinates of the manipulator's `PoseSpace`. Immutable; may be
/// used from any number of threads.
class BoxClassifier {
 public:
  virtual ~BoxClassifier() = default;

  /// Writes states[i] for each mode i in `modes`, for a box of the given root. A live `RoundingUpward` is
  /// required in this thread.
  virtual void classify(RootIndex root, const Box& box, ModeSet modes, LeafState* states) const noexcept = 0;

  /// A box of positions [m] that holds every reachable pose; nothing where legs without limits leave none.
  virtual std::optional<Box> reachable_positions() const = 0;
};

/// The classifier for the manipulator's task space; null where there is none yet.
std::unique_ptr<const BoxClassifier> make_box_classifier(const Manipulator& manipulator,
                                                         const std::vector<WorkingMode>& modes);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOX_CLASSIFIER_H
