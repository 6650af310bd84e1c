// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_STAGE_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_STAGE_H

#include "aspects/constraints/constraint_tests.h"
#include "aspects/tree/leaf_state.h"
#include "aspects/tree/pose_space.h"
#include "interval/interval.h"
#include "legs/limit_verdict.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

// A box of a chart (see charts.h) is evaluated in stages, each of which is made from the one before, so that
// none can be asked for what is not known yet:
//   BoxIntervals  B_jj^2, det A and the constraints by intervals;
//   BoxForms      the same by affine forms, much tighter in small boxes, and values at the center;
//   BoxSlopes     their partial derivatives: how S(s, sigma) grows, and whether it is connected.
// A stage refers to the one that it was made from, which has to outlive it.

namespace parallel_aspects {

/// A leg of which poses are looked at only where B_jj^2, if it vanishes in the box, is at most this.
struct BoundedEntry {
  std::size_t leg;
  double largest_square;
};

/// A box of a chart, and what is asked of it. All but the bound is referred to.
template <class Chart>
struct ChartBox {
  const Chart& chart;
  const ConstraintTests<Chart::point_dimension>& tests;
  RootIndex root;
  const Box& box;
  std::optional<BoundedEntry> bound = std::nullopt;

  /// Another box of the same root.
  ChartBox with(const Box& other, std::optional<BoundedEntry> other_bound = std::nullopt) const {
    return {chart, tests, root, other, other_bound};
  }

  Interval range(std::size_t i) const { return {box.lower[i], box.upper[i]}; }
};

/// B_jj^2 and |B_jj| of each leg over a box. A leg is *clear* where B_jj^2 is positive on the whole box.
template <std::size_t Legs>
class BoxEntries {
 public:
  using Values = std::array<Interval, Legs>;

  BoxEntries(const Values& squares, const std::optional<BoundedEntry>& bound)
      : squares_(squares), bound_(bound) {
    for (const Interval& square : squares_) reachable_nowhere_ = reachable_nowhere_ || square.upper() <= 0.0;
    if (reachable_nowhere_) return;
    for (std::size_t j = 0; j < Legs; ++j) values_[j] = square_root(square_looked_at(j));
  }

  /// With further enclosures of B_jj^2.
  BoxEntries with(const Values& squares) const {
    Values both;
    for (std::size_t j = 0; j < Legs; ++j) both[j] = intersection(squares_[j], squares[j]);
    return BoxEntries(both, bound_);
  }

  /// Whether some leg reaches no pose of the box. Then there are no values.
  bool reachable_nowhere() const noexcept { return reachable_nowhere_; }

  const Interval& square(std::size_t j) const noexcept { return squares_[j]; }
  const Interval& value(std::size_t j) const noexcept { return values_[j]; }
  const Values& values() const noexcept { return values_; }

  bool clear(std::size_t j) const noexcept { return squares_[j].positive(); }
  std::size_t unclear_count() const noexcept {
    std::size_t count = 0;
    for (std::size_t j = 0; j < Legs; ++j) count += clear(j) ? 0U : 1U;
    return count;
  }
  bool all_clear() const noexcept { return unclear_count() == 0; }
  bool all_clear_but(std::size_t leg) const noexcept { return unclear_count() == (clear(leg) ? 0U : 1U); }

  /// The first leg that is not clear; none where all are.
  std::optional<std::size_t> first_unclear() const noexcept {
    for (std::size_t j = 0; j < Legs; ++j)
      if (!clear(j)) return j;
    return std::nullopt;
  }

 private:
  Interval square_looked_at(std::size_t j) const {
    const Interval all = not_negative_part(squares_[j]);
    if (!bound_ || j != bound_->leg || clear(j)) return all;
    return {all.lower(), std::min(all.upper(), bound_->largest_square)};
  }

  Values squares_, values_;
  std::optional<BoundedEntry> bound_;
  bool reachable_nowhere_ = false;
};

/// What intervals and affine forms tell alike. A `Stage` has
///  - at(): the ChartBox; entries(): BoxEntries;
///  - displacement(j): over intervals;
///  - constraints(): ConstraintVerdicts; legs(): EvaluatedLegs, unless the box is reachable nowhere;
///  - determinant(signs): enclosure of det A; sign_of(determinant, signs): its sign where that is proved;
///  - keeps_parallel_margins(signs): see MarginTests.
template <class Chart, class Stage>
class BoxStage {
 public:
  static constexpr std::size_t leg_count = Chart::leg_count, coordinate_count = Chart::coordinate_count;
  using Signs = std::array<int, leg_count>;

  bool reachable_nowhere() const noexcept { return stage().entries().reachable_nowhere(); }

  LeafState state(const Signs& signs) const {
    if (reachable_nowhere()) return LeafState::outside();
    const Verdict allowed = is_allowed(signs);
    if (allowed == Verdict::fails) return LeafState::outside();
    const Interval value = stage().determinant(signs);
    const int sign = stage().sign_of(value, signs);
    if (sign != 0 && allowed == Verdict::holds && stage().entries().all_clear())
      return LeafState::inside(sign);
    if (sign != 0) return LeafState::undecided(sign > 0, sign < 0);
    return LeafState::undecided(value.upper() > 0.0, value.lower() < 0.0);
  }

  /// Whether the box may hold poses of S(signs, sign) and others.
  bool is_indeterminate(const Signs& signs, int sign) const {
    const LeafState found = state(signs);
    return found.may_be(sign) && !found.is_inside();
  }

  /// By limits of actuated joints.
  Verdict within_limits(const Signs& signs) const {
    Verdict all = Verdict::holds;
    for (std::size_t j = 0; j < leg_count && all != Verdict::fails; ++j)
      all = both(all, verdict(stage().at().chart.limits(j, stage().displacement(j),
                                                        stage().entries().value(j), signs[j])));
    return all;
  }

  /// By limits and all other constraints, where some pose may be reached.
  Verdict is_allowed(const Signs& signs) const {
    Verdict result = within_limits(signs);
    if (result != Verdict::fails) result = both(result, keeps_serial_margins());
    return result == Verdict::fails ? result : both(result, is_allowed_otherwise(signs));
  }

  /// By all constraints but limits and serial margins.
  Verdict is_allowed_otherwise(const Signs& signs) const {
    const Verdict result = keeps_parallel_margins(signs);
    if (stage().at().tests.none() || result == Verdict::fails) return result;
    return both(result, stage().constraints().all(signs, stage().legs()));
  }

  /// By the margins from singularities.
  Verdict keeps_margins(const Signs& signs) const {
    const Verdict result = keeps_serial_margins();
    return result == Verdict::fails ? result : both(result, keeps_parallel_margins(signs));
  }

  Verdict keeps_serial_margin(std::size_t j) const {
    return stage().at().tests.margins().serial(j, stage().entries().square(j));
  }

  Verdict keeps_serial_margins() const {
    Verdict result = Verdict::holds;
    if (!stage().at().tests.margins().any()) return result;
    for (std::size_t j = 0; j < leg_count; ++j) result = both(result, keeps_serial_margin(j));
    return result;
  }

  Verdict keeps_parallel_margins(const Signs& signs) const {
    return stage().at().tests.margins().has_parallel() ? stage().parallel_margins_by_squares(signs)
                                                       : Verdict::holds;
  }

 protected:
  BoxStage() = default;
  ~BoxStage() = default;
  BoxStage(const BoxStage&) = delete;
  BoxStage& operator=(const BoxStage&) = delete;

 private:
  const Stage& stage() const { return static_cast<const Stage&>(*this); }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_STAGE_H
