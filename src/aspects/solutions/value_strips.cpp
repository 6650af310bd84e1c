// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/value_strips.h"

#include "aspects/cusps/cusp_functions.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace parallel_aspects {
namespace {

// Boxes are not worth a look at the image before they are so small, and not divided below this [half turns].
constexpr double largest_looked_at = 0.125, smallest_divided = 0x1p-24;

using Values = std::array<std::optional<Interval>, 2>;

// Strips are at most this many times as long as rectangles: longer ones take time to mark.
constexpr double longest_value_strip = 64.0;

bool are_small(const Values& values, double half_width) {
  return std::all_of(values.begin(), values.end(), [&](const auto& value) {
    return value && value->upper() - value->lower() <= 2.0 * half_width;
  });
}

/// What to do with a box.
enum class Next { divide, leave, stop };

/// Covers a slice with boxes, each divided if `settle` asks for it. False where one asked to stop.
template <class Settle>
bool cover_slice(const MapControl& control, const Settle& settle) {
  std::vector<Box> boxes{whole_slice()};
  const double whole = boxes.front().measure();
  double done = 0.0;
  for (std::size_t effort = 0; !boxes.empty(); ++effort) {
    if (effort % 1024 == 0) {
      if (is_cancelled(control)) return false;
      if (control.progress) control.progress(std::min(1.0, done / whole));
    }
    const Box box = boxes.back();
    boxes.pop_back();
    const Next next = settle(box, std::max(box.width(0), box.width(1)));
    if (next == Next::stop) return false;
    if (next == Next::leave) {
      done += box.measure();
      continue;
    }
    for (const Box& half : halves_of(box)) boxes.push_back(half);
  }
  return true;
}

Next taken(const TakeStrip& take, ValueStrip strip, const SlicePosture& posture, int held) {
  strip.posture = posture;
  strip.held = held;
  return take(strip) ? Next::leave : Next::stop;
}

Values natural_values(const HeldSlice& slice, const SlicePosture& signs, const SlicePlace& place) {
  return {slice.joint_value(0, signs[0], place), slice.joint_value(1, signs[1], place)};
}

/// Whether none of these values is in the ranges.
bool are_outside(const JointRanges& ranges, const Values& values) {
  for (std::size_t i = 0; i < 2; ++i)
    if (values[i] && !ranges.may_hold(i, *values[i])) return true;
  return false;
}

/// One posture over a box where neither leg is stretched or folded.
class SmoothValues {
 public:
  /// Nothing where that is not so.
  static std::optional<SmoothValues> make(const HeldSlice& slice, const SlicePosture& posture,
                                          const CuspLegs& legs, const SlicePlace& place) {
    const SlicePlace center = place.at_center();
    const Values middle = natural_values(slice, posture, center);
    const auto at_center = legs_over(slice, posture, center);
    if (!are_regular(legs) || !middle[0] || !middle[1] || !at_center || !are_regular(*at_center))
      return std::nullopt;
    const auto over = slopes(slice, legs, place), at_middle = slopes(slice, *at_center, center);
    if (!over || !at_middle) return std::nullopt;
    return SmoothValues({*middle[0], *middle[1]}, *over, *at_middle, place.middle());
  }

  Values values() const { return {middle_[0] + change({1.0, 0.0}), middle_[1] + change({0.0, 1.0})}; }

  ValueStrip strip() const {
    const Interval middle = Interval(normal_[0]) * middle_[0] + Interval(normal_[1]) * middle_[1];
    return {values(), normal_, middle + change(normal_)};
  }

  /// Half of it, across the image.
  double width() const { return change(normal_).upper(); }

 private:
  using Matrix = std::array<std::array<Interval, 2>, 2>;

  SmoothValues(const std::array<Interval, 2>& middle, const Matrix& over, const Matrix& center,
               const SliceCenter& box)
      : middle_(middle), slopes_(over), box_(box) {
    const auto length = [&](std::size_t k) {
      return std::hypot(middle_of(center[0][k]), middle_of(center[1][k]));
    };
    const std::size_t k = length(0) > length(1) ? 0 : 1;
    if (length(k) > 0.0)
      normal_ = {-middle_of(center[1][k]) / length(k), middle_of(center[0][k]) / length(k)};
  }

  static std::optional<Matrix> slopes(const HeldSlice& slice, const CuspLegs& legs, const SlicePlace& at) {
    Matrix result;
    for (std::size_t i = 0; i < 2; ++i) {
      const Interval entry = slice.joint_entry(i, legs[i], at);
      if (may_vanish(entry)) return std::nullopt;
      const Jet<1> g = legs[i].equation.jet<1>(at.over());
      const Interval inverse = reciprocal(entry);
      result[i] = {g.at(1, 0) * inverse, g.at(0, 1) * inverse};
    }
    return result;
  }

  /// Of direction . q over the box.
  Interval change(const std::array<double, 2>& direction) const {
    Interval sum(0.0);
    for (std::size_t k = 0; k < 2; ++k)
      sum +=
          (Interval(direction[0]) * slopes_[0][k] + Interval(direction[1]) * slopes_[1][k]) * box_.offset(k);
    return sum;
  }

  std::array<Interval, 2> middle_;
  Matrix slopes_;
  SliceCenter box_;
  std::array<double, 2> normal_{};
};

/// Whether D may vanish in the box, by bounds of D and, of a small one, by its slope.
bool may_be_singular(const HeldSlice& slice, const SlicePosture& posture, const CuspLegs& legs,
                     const SlicePlace& place, bool is_small) {
  if (!may_be_singular(legs, place.over())) return false;
  if (!is_small || !are_regular(legs)) return true;
  const SlicePlace center = place.at_center();
  const auto at_center = legs_over(slice, posture, center);
  if (!at_center || !are_regular(*at_center)) return true;
  const auto slope = TotalGradients<2>(legs, CuspFunctions<1>(legs, place.over()), place.over()).d;
  const SliceCenter& middle = place.middle();
  return may_vanish(CuspFunctions<0>(*at_center, center.over()).d.value() + slope[0] * middle.offset(0) +
                    slope[1] * middle.offset(1));
}

/// The parallel singularities of one posture.
class ParallelStrips {
 public:
  ParallelStrips(const HeldSlice& slice, const JointRanges& ranges, const SlicePosture& posture,
                 const StripSizes& sizes, const TakeStrip& take)
      : slice_(slice), ranges_(ranges), posture_(posture), sizes_(sizes), take_(take) {}

  Next settle(const Box& box, double width) const {
    const SlicePlace place = slice_.place(box);
    const auto legs = legs_over(slice_, posture_, place);
    if (legs && (is_out_of_reach(*legs) ||
                 !may_be_singular(slice_, posture_, *legs, place, width <= largest_looked_at)))
      return Next::leave;
    if (width > largest_looked_at) return Next::divide;
    const Values values = natural_values(slice_, posture_, place);
    if (are_outside(ranges_, values)) return Next::leave;
    const auto smooth = legs ? SmoothValues::make(slice_, posture_, *legs, place) : std::nullopt;
    if (smooth && smooth->width() <= sizes_[0] &&
        are_small(smooth->values(), longest_value_strip * sizes_[1])) {
      return taken(take_, smooth->strip(), posture_, slice_.held_sign(place));
    }
    if (!are_small(values, sizes_[1]) && width > smallest_divided) return Next::divide;
    return taken(take_, {values, {}, {}}, posture_, slice_.held_sign(place));
  }

 private:
  const HeldSlice& slice_;
  const JointRanges& ranges_;
  SlicePosture posture_;
  StripSizes sizes_;
  const TakeStrip& take_;
};

/// Where leg i, 0 or 1, is stretched or folded, or that whose joint is held, 2; `sign` of B_jj of the other.
class SerialStrips {
 public:
  SerialStrips(const HeldSlice& slice, const JointRanges& ranges, std::size_t of, const SlicePosture& signs,
               const StripSizes& sizes, const TakeStrip& take)
      : slice_(slice), ranges_(ranges), of_(of), signs_(signs), sizes_(sizes), take_(take) {}

  Next settle(const Box& box, double width) const {
    const SlicePlace place = slice_.place(box);
    if (is_excluded(place)) return Next::leave;
    if (width > largest_looked_at) return Next::divide;
    const Values values = natural_values(slice_, signs_, place);
    if (are_outside(ranges_, values)) return Next::leave;
    if (!are_small(values, sizes_[1]) && width > smallest_divided) return Next::divide;
    return taken(take_, {values, {}, {}}, signs_, slice_.held_sign(place));
  }

 private:
  bool is_excluded(const SlicePlace& place) const {
    if (of_ == 2 && slice_.held_sign(place) != 0) return true;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto leg = slice_.leg_over(i, signs_[i] < 0 ? -1 : 1, place);
      if (!leg) continue;
      if (leg->reaches == Verdict::fails) return true;
      if (i == of_ && leg->reaches == Verdict::holds && !may_vanish(leg->entry)) return true;
    }
    return false;
  }

  const HeldSlice& slice_;
  const JointRanges& ranges_;
  std::size_t of_;
  SlicePosture signs_;  // 0 where it is stretched or folded
  StripSizes sizes_;
  const TakeStrip& take_;
};

}  // namespace

void enclose_parallel_singularities(const HeldSlice& slice, const JointRanges& ranges,
                                    const StripSizes& sizes, const MapControl& control,
                                    const TakeStrip& take) {
  assert_rounding_upward();
  const auto count = static_cast<double>(slice.postures().size());
  double done = 0.0;
  for (const SlicePosture& posture : slice.postures()) {
    const ParallelStrips strips(slice, ranges, posture, sizes, take);
    const MapControl part = part_of(control, done / count, (done + 1.0) / count);
    done += 1.0;
    if (!cover_slice(part, [&](const Box& box, double width) { return strips.settle(box, width); })) return;
  }
}

void enclose_serial_singularities(const HeldSlice& slice, const JointRanges& ranges, const StripSizes& sizes,
                                  const MapControl& control, const TakeStrip& take) {
  assert_rounding_upward();
  const auto count = static_cast<double>(3 * slice.postures().size());
  double done = 0.0;
  for (std::size_t of = 0; of <= 2; ++of)
    for (SlicePosture signs : slice.postures()) {
      const MapControl part = part_of(control, done / count, (done + 1.0) / count);
      done += 1.0;
      if (of < 2 && signs[of] != slice.postures().front()[of]) continue;  // both meet there
      if (of < 2) signs[of] = 0;
      const SerialStrips strips(slice, ranges, of, signs, sizes, take);
      if (!cover_slice(part, [&](const Box& box, double width) { return strips.settle(box, width); })) return;
    }
}

}  // namespace parallel_aspects
