// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_CLASSIFIER_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_CLASSIFIER_H

#include "aspects/tree/leaf_state.h"
#include "aspects/tree/monotonicity.h"
#include "aspects/tree/pose_space.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/singularity/indices.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Which proofs are tried on an undecided box, and how hard. None of this can make a proof wrong: what is not
/// tried is not known. `benchmark/component_ablation` switches each off; see docs/development/benchmarks.md.
struct BoxPolicy {
  // The proofs, each as docs/theory/maps.md names it.
  bool wedges = true;
  bool shells = true;
  bool faces = true;  ///< a box is examined on the face that the set grows to

  /// Lengths of the wedge's box that are tried, each twice the one before. The first is a quarter longer than
  /// first-order approximation asks for.
  int wedge_attempts = 3;

  /// Halvings of the line that the height of a wedge is searched for on: about the digits of a double.
  int wedge_bisections = 50;

  /// Halvings of the diagonal on which a shell begins: to a billionth of it.
  int shell_bisections = 30;
};

/// A set of working modes: bit i stands for the i-th of the list that the classifier was made with.
using ModeSet = std::uint64_t;
inline constexpr std::size_t most_modes = 64;

/// How much is asked of a classification.
enum class Detail {
  states,    ///< inside, outside or undecided
  centers,   ///< the signs at the center, too
  parts,     ///< and what is whole, as far as it is seen at once
  all_parts  ///< and what more work shows to be whole
};

/// A box as one working mode and sign see it.
struct Examined {
  LeafState state;
  Monotonicity monotonicity;
  std::optional<Monotonicity> shell;  ///< see BoxSlopes::shell
};

/// A function of the pose, and its slope.
struct Condition {
  double value = 0.0;
  MapPoint slope{};
};

/// Functions that are positive in S(mode, sign), and zero or less on its boundary: B_jj^2 of each leg, det A
/// times the sign, and what limits and other constraints demand.
struct Conditions {
  static constexpr std::size_t most = 48;

  std::array<std::size_t, max_legs> entry_of_leg{};  ///< where B_jj^2 is among the items

  std::array<Condition, most> items;
  std::size_t count = 0;

  /// What there is no room for is left out.
  void add(const Condition& condition) noexcept {
    if (count < most) items[count++] = condition;
  }
};

/// A set of legs: bit j stands for leg j.
using LegSet = std::uint8_t;

/// What is proved of a box in one working mode, fact by fact.
struct BoxFacts {
  LegSet legs = 0;   ///< all that there are
  LegSet clear = 0;  ///< those with B_jj^2 positive on the whole box
  LegSet unreachable =
      0;  ///< those with B_jj^2 positive nowhere; if not empty, the fields below are not filled in
  LegSet serial_margins = 0;  ///< those that keep the serial margin on the whole box; all where there is none
  bool within_limits = false;  ///< at every pose that all legs reach; of actuated joints and by all other
                               ///< constraints but serial margins
  int determinant_sign = 0;  ///< of det A at every pose that all legs reach, B_jj = 0 too; 0 where not proved

  /// Where all legs are clear and the sign is not proved: partial derivatives of a function that is det A
  /// times a positive one.
  std::array<Interval, max_map_dimension> determinant_slope{};

  static LegSet bit(std::size_t leg) noexcept { return static_cast<LegSet>(1U << leg); }
  /// Whether all other legs are clear, and keep the serial margin.
  bool all_clear_but(LegSet except) const noexcept { return ((clear & serial_margins) | except) == legs; }
};

/// Proves boxes inside or outside, in the coordinates of the manipulator's `PoseSpace`. Immutable; may be
/// used from any number of threads.
class BoxClassifier {
 public:
  explicit BoxClassifier(const BoxPolicy& policy) noexcept : policy_(policy) {}
  virtual ~BoxClassifier() = default;

  const BoxPolicy& policy() const noexcept { return policy_; }

  /// Writes states[i] for each mode i in `modes`, for a box of the given root: with `Detail::parts` also what
  /// is whole and the signs at the center. A live `RoundingUpward` is required in this thread.
  virtual void classify(RootIndex root, const Box& box, ModeSet modes, Detail detail,
                        LeafState* states) const noexcept = 0;

  /// The state of a box in one mode alone. A live `RoundingUpward` is required.
  LeafState state(RootIndex root, const Box& box, std::size_t mode) const noexcept;

  /// The state of a box in one mode, and how S(s, sign) grows in it.
  virtual Examined examine(RootIndex root, const Box& box, std::size_t mode, int sign) const noexcept = 0;

  /// A live `RoundingUpward` is required.
  virtual BoxFacts facts(RootIndex root, const Box& box, std::size_t mode) const noexcept = 0;

  /// See WedgeProof: a pose that all of S(mode, sign) in the box is connected with, where there is a proof.
  virtual std::optional<MapPoint> find_wedge(RootIndex root, const Box& box, std::size_t mode,
                                             int sign) const noexcept = 0;

  /// In double precision, proving nothing; none where a leg does not reach the position.
  virtual Conditions conditions(const MapPosition& position, std::size_t mode, int sign) const noexcept = 0;

  /// What the index is in one mode at every pose of the box that all legs reach, whatever the constraints,
  /// and 0 for poses where det A has another sign. More work is done where less of it leaves the bounds
  /// farther apart than this share of the upper one. A live `RoundingUpward` is required.
  virtual Interval enclose_index(RootIndex root, const Box& box, std::size_t mode, int sign,
                                 ParallelIndex index, double share) const noexcept = 0;

  /// Writes kinds[i] for each mode i in `modes`: the constraints, limits of actuated joints among them, that
  /// are neither proved to hold in all of the box nor to fail in all of it. A live `RoundingUpward` is
  /// required.
  virtual void find_unknown_constraints(RootIndex root, const Box& box, ModeSet modes,
                                        ConstraintKinds* kinds) const noexcept = 0;

  /// A box of positions [m] that holds every reachable pose; nothing where legs without limits leave none.
  virtual std::optional<Box> reachable_positions() const = 0;

 private:
  BoxPolicy policy_;
};

/// The classifier for the manipulator's task space; null where there is none yet.
std::unique_ptr<const BoxClassifier> make_box_classifier(const Manipulator& manipulator,
                                                         const std::vector<WorkingMode>& modes,
                                                         const BoxPolicy& policy = {});

/// The classifier for a slice of the manipulator's poses (see `find_slice_problem`), in the coordinates of
/// `make_slice_space`.
std::unique_ptr<const BoxClassifier> make_slice_classifier(const Manipulator& manipulator,
                                                           const std::vector<WorkingMode>& modes,
                                                           const MapSlice& slice,
                                                           const BoxPolicy& policy = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_CLASSIFIER_H
