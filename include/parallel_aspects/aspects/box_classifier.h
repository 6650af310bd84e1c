// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOX_CLASSIFIER_H
#define PARALLEL_ASPECTS_ASPECTS_BOX_CLASSIFIER_H

#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/growth.h"
#include "parallel_aspects/aspects/leaf_state.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/pose_space.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// A set of working modes: bit i stands for the i-th of the list that the classifier was made with.
using ModeSet = std::uint64_t;

/// How much is asked of a classification.
enum class Detail { states, parts };

/// A box as one working mode and sign see it.
struct Examined {
  LeafState state;
  Growth growth;
  std::optional<Growth> shell;  ///< see ChartEvaluation::shell
};

/// A function of the pose, and its slope.
struct Condition {
  double value = 0.0;
  MapPoint slope{};
};

/// Functions that are positive in S(mode, sign), and zero or less on its boundary: B_jj^2 of each leg, det A
/// times the sign, and what limits demand.
struct Conditions {
  static constexpr std::size_t most = 3 * std::size_t{max_legs} + 1;

  std::array<Condition, most> items;
  std::size_t count = 0;

  void add(const Condition& condition) noexcept { items[count++] = condition; }
};

/// Proves boxes inside or outside, in the coordinates of the manipulator's `PoseSpace`. Immutable; may be
/// used from any number of threads.
class BoxClassifier {
 public:
  virtual ~BoxClassifier() = default;

  /// Writes states[i] for each mode i in `modes`, for a box of the given root: with `Detail::parts` also what
  /// is whole and the signs at the center. A live `RoundingUpward` is required in this thread.
  virtual void classify(RootIndex root, const Box& box, ModeSet modes, Detail detail,
                        LeafState* states) const noexcept = 0;

  /// The state of a box in one mode alone. A live `RoundingUpward` is required.
  LeafState state(RootIndex root, const Box& box, std::size_t mode) const noexcept;

  /// The state of a box in one mode, and how S(s, sign) grows in it.
  virtual Examined examine(RootIndex root, const Box& box, std::size_t mode, int sign) const noexcept = 0;

  /// In double precision, proving nothing; none where a leg does not reach the position.
  virtual Conditions conditions(const MapPosition& position, std::size_t mode, int sign) const noexcept = 0;

  /// A box of positions [m] that holds every reachable pose; nothing where legs without limits leave none.
  virtual std::optional<Box> reachable_positions() const = 0;
};

/// The classifier for the manipulator's task space; null where there is none yet.
std::unique_ptr<const BoxClassifier> make_box_classifier(const Manipulator& manipulator,
                                                         const std::vector<WorkingMode>& modes);

/// The classifier for a slice of the manipulator's poses (see `find_slice_problem`), in the coordinates of
/// `make_slice_space`.
std::unique_ptr<const BoxClassifier> make_slice_classifier(const Manipulator& manipulator,
                                                           const std::vector<WorkingMode>& modes,
                                                           const MapSlice& slice);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOX_CLASSIFIER_H
