// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_STAGE_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_STAGE_H

#include "aspects/boxes/box_states.h"
#include "aspects/constraints/constraint_tests.h"
#include "aspects/tree/leaf_state.h"
#include "aspects/tree/pose_space.h"
#include "interval/interval.h"
#include "interval/interval_lanes.h"
#include "interval/lanes.h"
#include "legs/limit_verdict.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>

// A box of a chart (see charts.h) is evaluated in stages, each of which is made from the one before, so that
// none can be asked for what is not known yet:
//   BoxIntervals  B_jj^2, det A and the constraints by intervals;
//   BoxForms      the same by affine forms, much tighter in small boxes, and values at the center;
//   BoxSlopes     their partial derivatives: how S(s, sigma) grows, and whether it is connected.
// A stage refers to the one that it was made from, which has to outlive it.
//
// `Number` is double, or several in lanes: then there are as many boxes of one root, and what is told of each
// is the same to the last digit as it is alone. Lanes know no constraints but limits of actuated joints.

namespace parallel_aspects {

/// A leg of which poses are looked at only where B_jj^2, if it vanishes in the box, is at most this.
struct BoundedEntry {
  std::size_t leg;
  double largest_square;
};

/// A box of a chart, and what is asked of it. All but the bound is referred to.
template <class Chart, class Number = double>
struct ChartBox {
  static constexpr std::size_t dimension = Chart::coordinate_count;
  using Range = RangeOf<Number>;
  using Where = std::conditional_t<std::is_same_v<Number, double>, Box, std::array<Range, dimension>>;

  const Chart& chart;
  const ConstraintTests<Chart::point_dimension>& tests;
  RootIndex root;
  const Where& box;
  std::optional<BoundedEntry> bound = std::nullopt;

  /// Another box of the same root.
  ChartBox with(const Box& other, std::optional<BoundedEntry> other_bound = std::nullopt) const {
    return {chart, tests, root, other, other_bound};
  }

  Range range(std::size_t i) const {
    if constexpr (std::is_same_v<Number, double>)
      return {box.lower[i], box.upper[i]};
    else
      return box[i];
  }
  std::array<Range, dimension> ranges() const {
    std::array<Range, dimension> result;
    for (std::size_t i = 0; i < dimension; ++i) result[i] = range(i);
    return result;
  }
  Number width(std::size_t i) const { return range(i).upper() - range(i).lower(); }
};

/// B_jj^2 and |B_jj| of each leg over a box. A leg is *clear* where B_jj^2 is positive on the whole box.
template <std::size_t Legs, class Number = double>
class BoxEntries {
 public:
  using Range = RangeOf<Number>;
  using Mask = MaskOf<Number>;
  using Values = std::array<Range, Legs>;

  BoxEntries(const Values& squares, const std::optional<BoundedEntry>& bound)
      : squares_(squares), bound_(bound) {
    for (std::size_t j = 0; j < Legs; ++j) {
      reachable_nowhere_ |= squares_[j].upper() <= 0.0;
      values_[j] = square_root(square_looked_at(j));
    }
  }

  /// With further enclosures of B_jj^2.
  BoxEntries with(const Values& squares) const {
    Values both;
    for (std::size_t j = 0; j < Legs; ++j) both[j] = intersection(squares_[j], squares[j]);
    return BoxEntries(both, bound_);
  }

  /// Whether some leg reaches no pose of the box. Then the values tell nothing.
  const Mask& reachable_nowhere() const noexcept { return reachable_nowhere_; }

  const Range& square(std::size_t j) const noexcept { return squares_[j]; }
  const Range& value(std::size_t j) const noexcept { return values_[j]; }
  const Values& values() const noexcept { return values_; }

  Mask clear(std::size_t j) const noexcept { return squares_[j].positive(); }
  Mask all_clear() const noexcept { return all_clear_but(Legs); }
  Mask all_clear_but(std::size_t leg) const noexcept {
    Mask all = !Mask{};
    for (std::size_t j = 0; j < Legs; ++j)
      if (j != leg) all &= clear(j);
    return all;
  }

  /// Whether all legs but one are clear.
  Mask single_unclear() const noexcept {
    Mask some{}, several{};
    for (std::size_t j = 0; j < Legs; ++j) {
      several |= some & !clear(j);
      some |= !clear(j);
    }
    return some & !several;
  }

  /// The first leg that is not clear; none where all are.
  std::optional<std::size_t> first_unclear() const noexcept {
    for (std::size_t j = 0; j < Legs; ++j)
      if (!clear(j)) return j;
    return std::nullopt;
  }

 private:
  Range square_looked_at(std::size_t j) const {
    const Range all = not_negative_part(squares_[j]);
    if (!bound_ || j != bound_->leg || in_all(clear(j))) return all;
    return {all.lower(), smaller_of(all.upper(), in_lanes<Number>(bound_->largest_square))};
  }

  Values squares_, values_;
  std::optional<BoundedEntry> bound_;
  Mask reachable_nowhere_{};
};

/// B_jj^2 of all legs.
template <class Placed>
auto squares_of(const Placed& placed) {
  std::array<decltype(range_of(placed.squared_b_entry(0))), Placed::leg_count> result;
  for (std::size_t j = 0; j < result.size(); ++j) result[j] = range_of(placed.squared_b_entry(j));
  return result;
}

/// Where det A is proved to have a sign.
template <class Mask>
struct ProvedSign {
  Mask positive, negative;
};

/// Whether a value is proved to have this sign.
template <class Range>
auto has_sign(const Range& value, int sign) {
  return sign > 0 ? value.positive() : value.negative();
}

inline std::size_t branch_of(int sign) noexcept { return sign > 0 ? 1 : 0; }

/// What intervals and affine forms tell alike. A `Stage` has
///  - at(): the ChartBox; entries(): BoxEntries;
///  - displacement(j): over intervals;
///  - constraints(): ConstraintVerdicts; legs(): EvaluatedLegs, unless the box is reachable nowhere;
///  - determinant(signs): enclosure of det A; proved_sign(determinant, signs): its sign where that is proved;
///  - parallel_margins_by_squares(signs): see MarginTests.
template <class Chart, class Number, class Stage>
class BoxStage {
 public:
  static constexpr std::size_t leg_count = Chart::leg_count, coordinate_count = Chart::coordinate_count;
  static constexpr bool is_of_one_box = std::is_same_v<Number, double>;
  using Signs = std::array<int, leg_count>;
  using Range = RangeOf<Number>;
  using Mask = MaskOf<Number>;
  using Bits = BitsOf<Number>;

  const Mask& reachable_nowhere() const noexcept { return stage().entries().reachable_nowhere(); }

  /// See box_states.h; without what is known of centers and whole parts.
  Bits states(const Signs& signs) const {
    const Proved<Mask> allowed = is_allowed_where_reached(signs);
    if (in_all(allowed.fails)) return Bits{};
    const Range value = stage().determinant(signs);
    const auto [positive, negative] = stage().proved_sign(value, signs);
    const Bits may_be = bits_where((value.upper() > 0.0) & !negative, state_bits::may_be_positive) |
                        bits_where((value.lower() < 0.0) & !positive, state_bits::may_be_negative);
    const Mask inside = (positive | negative) & allowed.holds & stage().entries().all_clear();
    return bits_where(!allowed.fails, may_be | bits_where(inside, state_bits::is_inside));
  }

  LeafState state(const Signs& signs) const { return state_of(states(signs)); }

  /// Whether the box may hold poses of S(signs, sign) and others.
  bool is_indeterminate(const Signs& signs, int sign) const {
    const Bits found = states(signs);
    return has_bits(found, may_be_bit(sign)) && is_undecided(found);
  }

  /// By limits of the actuated joint of leg j.
  const Proved<Mask>& limits(std::size_t j, int sign) const {
    std::optional<Proved<Mask>>& found = limits_[j][branch_of(sign)];
    if (!found)
      found = outlined<Number>([&] {
        return proved(
            stage().at().chart.limits(j, stage().displacement(j), stage().entries().value(j), sign));
      });
    return *found;
  }

  /// By limits of all actuated joints.
  Proved<Mask> limits(const Signs& signs) const {
    Proved<Mask> all{!Mask{}, Mask{}};
    for (std::size_t j = 0; j < leg_count && !in_all(all.fails); ++j) {
      const Proved<Mask>& each = limits(j, signs[j]);
      all.holds &= each.holds;
      all.fails |= each.fails;
    }
    return all;
  }
  Verdict within_limits(const Signs& signs) const { return verdict_of(limits(signs)); }

  /// By limits and all other constraints; fails where no pose is reached.
  Proved<Mask> is_allowed_where_reached(const Signs& signs) const {
    if constexpr (is_of_one_box) {
      const Verdict allowed = reachable_nowhere() ? Verdict::fails : is_allowed(signs);
      return {allowed == Verdict::holds, allowed == Verdict::fails};
    } else {
      const Proved<Mask> all = limits(signs);
      return {all.holds, all.fails | reachable_nowhere()};
    }
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

  // Found where they are asked for first, and kept: by leg and branch.
  mutable std::array<std::array<std::optional<Proved<Mask>>, 2>, leg_count> limits_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_STAGE_H
