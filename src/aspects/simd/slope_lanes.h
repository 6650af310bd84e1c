// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SIMD_SLOPE_LANES_H
#define PARALLEL_ASPECTS_ASPECTS_SIMD_SLOPE_LANES_H

#include "aspects/simd/lane_stages.h"
#include "interval/dual.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// The directions in which sets grow through boxes, one in each lane (see Monotonicity).
template <class Mask, std::size_t N>
struct MonotonicityLanes {
  std::array<Mask, N> upward, downward;

  MonotonicityLanes() {
    upward.fill(~Mask{});
    downward.fill(~Mask{});
  }

  /// Along no coordinate in lanes where the condition holds.
  void forget(const Mask& condition) {
    for (std::size_t i = 0; i < N; ++i) {
      upward[i] &= ~condition;
      downward[i] &= ~condition;
    }
  }

  /// See Monotonicity::require, in lanes where the condition holds.
  template <class Values>
  void require(const Mask& condition, const Values& gradient) {
    for (std::size_t i = 0; i < N; ++i) {
      const auto range = range_of(gradient[i]);
      upward[i] &= ~condition | (range.lower() >= 0.0);
      downward[i] &= ~condition | (range.upper() <= 0.0);
    }
  }

  void restrict_to(const MonotonicityLanes& other) {
    for (std::size_t i = 0; i < N; ++i) {
      upward[i] &= other.upward[i];
      downward[i] &= other.downward[i];
    }
  }

  /// Along every coordinate in which the boxes have a width.
  Mask along_all(const std::array<Mask, N>& has_width) const {
    Mask all = ~Mask{};
    for (std::size_t i = 0; i < N; ++i) all &= ~has_width[i] | upward[i] | downward[i];
    return all;
  }
};

/// The stage `BoxSlopes` of boxes of one chart and root, one in each lane: monotone sets and shells, as each
/// box has them alone.
template <class Chart, class Numbers>
class SlopeLanes {
 public:
  using Forms = LaneForms<Chart, Numbers>;
  using Range = typename Forms::Range;
  using Form = typename Forms::Form;
  using Mask = typename Forms::Mask;
  using Signs = typename Forms::Types::Signs;
  static constexpr std::size_t leg_count = Chart::leg_count, coordinate_count = Chart::coordinate_count;

  static SlopeLanes of(const Forms& forms) {
    return outlined<Numbers>([&forms] { return SlopeLanes(forms); });
  }

  /// See BoxSlopes::is_whole, without faces. `determinant` is that of the forms.
  Mask is_whole(const Signs& signs, int sign, const Range& determinant) const {
    const Mask along = monotonicity(signs, sign, determinant).along_all(has_width_);
    Growth of_shell;
    return along | shell(signs, sign, ~along, of_shell);
  }

  using Growth = MonotonicityLanes<Mask, coordinate_count>;

  /// See BoxSlopes::monotonicity.
  Growth monotonicity(const Signs& signs, int sign, const Range& determinant) const {
    Growth growth;
    for (std::size_t j = 0; j < leg_count; ++j) {
      growth.require(~entries().clear[j], placed_.squared_b_entry(j).gradient);
      restrict_by_limits(j, signs[j], growth);
    }
    const Mask open = ~has_sign(determinant, sign);
    if (in_none(open)) return growth;
    Growth of_determinant = monotonicity_of_determinant(signs, sign);
    for (std::size_t i = 0; i < coordinate_count; ++i) {
      of_determinant.upward[i] |= ~open;
      of_determinant.downward[i] |= ~open;
    }
    growth.restrict_to(of_determinant);
    return growth;
  }

  /// Along every coordinate in which the boxes have a width.
  Mask along_all(const Growth& growth) const { return growth.along_all(has_width_); }

  /// See BoxSlopes::shell, in lanes where that is asked; writes how the sets grow.
  Mask shell(const Signs& signs, int sign, Mask asked, Growth& growth) const {
    asked &= ~entries().all_clear;
    for (std::size_t j = 0; j < leg_count; ++j) asked &= forms_.limits().hold[j][branch_of(signs[j])];
    if (in_none(asked)) return asked;
    growth = Growth();
    for (std::size_t j = 0; j < leg_count; ++j) {
      const Mask unclear = ~entries().clear[j];
      growth.require(unclear, placed_.squared_b_entry(j).gradient);
      asked &= ~unclear | has_sign(determinant_without_entry(j, signs).range(), sign);
    }
    if (in_none(asked)) return asked;
    growth.restrict_to(monotonicity_of_determinant(signs, -sign));
    asked &= growth.along_all(has_width_);
    return in_none(asked) ? asked : asked & is_lowest_unreachable(growth);
  }

 private:
  using Slope = Dual<coordinate_count, Form>;

  explicit SlopeLanes(const Forms& forms)
      : forms_(forms),
        placed_(chart(), forms.intervals().root(), coordinates()),
        legs_(chart(), placed_, entry_slopes()) {
    for (std::size_t j = 0; j < leg_count; ++j) unclear_count_ += ~entries().clear[j] & 1;
    for (std::size_t i = 0; i < coordinate_count; ++i)
      has_width_[i] = ranges()[i].upper() - ranges()[i].lower() > 0.0;
  }

  const Chart& chart() const { return forms_.intervals().chart(); }
  const auto& ranges() const { return forms_.intervals().ranges(); }
  const auto& entries() const { return forms_.entries(); }

  std::array<Slope, coordinate_count> coordinates() const {
    const std::array<Form, coordinate_count> forms = Forms::coordinates(ranges());
    std::array<Slope, coordinate_count> result;
    for (std::size_t i = 0; i < coordinate_count; ++i) result[i] = Slope::coordinate(forms[i], i);
    return result;
  }

  /// See BoxSlopes::entry_slopes.
  std::array<Slope, leg_count> entry_slopes() const {
    std::array<Slope, leg_count> result;
    for (std::size_t j = 0; j < leg_count; ++j) {
      const Form& entry = forms_.legs().entry(j);
      const Form factor = reciprocal(Interval(2.0) * entry, entries().values[j].lower());
      result[j] = Slope(entry);
      for (std::size_t i = 0; i < coordinate_count; ++i)
        result[j].gradient[i] =
            where(entries().clear[j], factor * placed_.squared_b_entry(j).gradient[i], Form());
    }
    return result;
  }

  static Mask has_sign(const Range& value, int sign) {
    return sign > 0 ? value.positive() : value.negative();
  }

  /// See BoxSlopes::visit_open_limits.
  void restrict_by_limits(std::size_t j, int sign, Growth& growth) const {
    outlined<Numbers>([&] { require_limits(j, sign, growth); });
  }
  void require_limits(std::size_t j, int sign, Growth& growth) const {
    const Mask open = ~forms_.limits().hold[j][branch_of(sign)];
    if (in_none(open)) return;
    growth.forget(open & ~entries().clear[j]);
    const LimitFunctions<Range> values =
        chart().limits(j, forms_.intervals().placed().legs[j].displacement, entries().values[j], sign);
    const LimitFunctions<Slope> slopes =
        chart().limits(j, placed_.legs[j].displacement, legs_.entry(j), sign);
    for (std::size_t k = 0; k < values.count; ++k) {
      const Mask unknown = ~(values.values[k].positive() | values.values[k].negative());
      growth.require(open & entries().clear[j] & unknown, slopes.values[k].gradient);
    }
  }

  /// See BoxSlopes::monotonicity_of_determinant.
  Growth monotonicity_of_determinant(const Signs& signs, int sign) const {
    return outlined<Numbers>([&] { return growth_of_determinant(signs, sign); });
  }
  Growth growth_of_determinant(const Signs& signs, int sign) const {
    Growth growth;
    const Interval factor(sign);
    const Slope function = factor * legs_.determinant(signs);
    const Mask is_single = unclear_count_ == 1;
    growth.require(~is_single, function.gradient);
    for (std::size_t j = 0; j < leg_count; ++j) {
      const Mask unclear = ~entries().clear[j];
      if (in_none(unclear)) continue;
      const Form lever = factor * slope_along_entry(j, signs),
                 weight = Interval(2.0) * forms_.legs().entry(j);
      std::array<Form, coordinate_count> term;
      for (std::size_t i = 0; i < coordinate_count; ++i) {
        const Form alone = lever * placed_.squared_b_entry(j).gradient[i];
        term[i] = where(is_single, alone + weight * function.gradient[i], alone);
      }
      growth.require(unclear, term);
    }
    return growth;
  }

  /// See BoxSlopes::slope_along_entry and determinant_without_entry.
  Form slope_along_entry(std::size_t j, const Signs& signs) const {
    auto rows = forms_.legs().rows();
    rows[j].positive = forms_.placed().legs[j].rows.turned;
    for (std::size_t i = 0; i < leg_count; ++i) rows[j].negative[i] = -rows[j].positive[i];
    return Determinants<Form, leg_count>(rows).of(signs);
  }
  Form determinant_without_entry(std::size_t j, const Signs& signs) const {
    return outlined<Numbers>([&] { return determinant_of_fixed(j, signs); });
  }
  Form determinant_of_fixed(std::size_t j, const Signs& signs) const {
    auto rows = forms_.legs().rows();
    rows[j].positive = rows[j].negative = forms_.placed().legs[j].rows.fixed;
    return Determinants<Form, leg_count>(rows).of(signs);
  }

  Mask is_lowest_unreachable(const Growth& growth) const {
    std::array<Range, coordinate_count> corner;
    for (std::size_t i = 0; i < coordinate_count; ++i) {
      const Numbers at = where(growth.upward[i], ranges()[i].lower(), Numbers(ranges()[i].upper()));
      corner[i] = Range(at, at);
    }
    const PlacedLegs<Chart, Range> placed(chart(), forms_.intervals().root(), corner);
    Mask result{};
    for (std::size_t j = 0; j < leg_count; ++j) result |= placed.squared_b_entry(j).upper() <= 0.0;
    return result;
  }

  const Forms& forms_;
  PlacedLegs<Chart, Slope> placed_;
  EvaluatedLegs<Chart, Slope> legs_;
  Mask unclear_count_{};
  std::array<Mask, coordinate_count> has_width_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SIMD_SLOPE_LANES_H
