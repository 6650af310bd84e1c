// SPDX-License-Identifier: BSD-3-Clause
#include "arms/arm_cusps.h"

#include "aspects/zeros/krawczyk.h"

#include "arms/factor_enclosure.h"
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr double smallest_box = 0x1p-24;  // [half turns]
constexpr std::size_t most_boxes = 400000;
constexpr int most_refinements = 20;

// A function of theta2 and theta3 with its derivatives.
struct WithGradient {
  EnclosedPolynomial value, by_second, by_third;

  explicit WithGradient(const TrigPolynomial& a)
      : value(a), by_second(a.derivative(1, true)), by_third(a.derivative(2, true)) {}
};

JointNumbers<Interval> as_ranges(const Box& box) {
  JointNumbers<Interval> numbers;
  for (std::size_t i = 0; i < 2; ++i)
    numbers[i + 1] = turn_of_any_half_turns(Interval(box.lower[i], box.upper[i]));
  return numbers;
}

JointNumbers<Affine<2>> as_forms(const Box& box) {
  JointNumbers<Affine<2>> numbers;
  for (std::size_t i = 0; i < 2; ++i)
    numbers[i + 1] = turn_of_any_half_turns(Affine<2>::coordinate(Interval(box.lower[i], box.upper[i]), i));
  return numbers;
}

bool has_zero(const Interval& a) { return !a.positive() && !a.negative(); }

// A singular point (f = 0) where the direction that the operational point does not move in, (-g_3, g_2) with
// g the height or the squared distance from the first axis, is along the singular curve. Both g are
// equivalent where their gradients do not vanish.
class CuspSearch {
 public:
  CuspSearch(const TrigPolynomial& factor, const TrigPolynomial& squared, const TrigPolynomial& height)
      : factor_(factor),
        tangency_{WithGradient(tangency(factor, height)), WithGradient(tangency(factor, squared))},
        gradient_{WithGradient(height), WithGradient(squared)} {}

  // False where a box is left of which nothing is known.
  bool run(KnownZeros& found) const {
    const RoundingUpward rounding;
    std::vector<Box> open{{2, {-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}}};
    for (std::size_t count = 0; !open.empty(); ++count) {
      const Box box = open.back();
      open.pop_back();
      if (count > most_boxes) return false;
      if (is_free(box) || is_settled(box, found)) continue;
      if (box.width(0) < smallest_box) return false;
      for (unsigned part = 0; part < 4; ++part) {
        Box quarter = box;
        for (std::size_t i = 0; i < 2; ++i)
          ((part >> i & 1U) != 0 ? quarter.lower : quarter.upper)[i] = box.center(i);
        open.push_back(quarter);
      }
    }
    return true;
  }

 private:
  static TrigPolynomial tangency(const TrigPolynomial& f, const TrigPolynomial& g) {
    return f.derivative(2, true) * g.derivative(1, true) - f.derivative(1, true) * g.derivative(2, true);
  }

  bool is_free(const Box& box) const {
    const auto forms = as_forms(box);
    return !has_zero(factor_.value.over(forms).range()) ||
           !has_zero(tangency_[0].value.over(forms).range()) ||
           !has_zero(tangency_[1].value.over(forms).range());
  }

  bool is_settled(const Box& box, KnownZeros& found) const {
    // Zeros on a face are found in a larger box.
    const Box larger = scaled(box, 1.25);
    if (found.cover(box)) return true;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto at = as_forms(larger);
      if (!is_regular(gradient_[k], at)) continue;
      const ZeroSearch search = krawczyk_test(larger, pair(tangency_[k], larger));
      if (search.zeros == Zeros::none) return true;
      if (search.zeros == Zeros::one) return found.note({larger, refined(search.enclosure, tangency_[k])});
    }
    return false;
  }

  // By the same test again, as the zero is in what it leaves.
  Box refined(Box enclosure, const WithGradient& tangency) const {
    for (int step = 0; step < most_refinements; ++step) {
      const ZeroSearch again = krawczyk_test(enclosure, pair(tangency, enclosure));
      const Box next = intersection(enclosure, again.enclosure);
      if (again.zeros == Zeros::none || !(next.width(0) < 0.9 * enclosure.width(0))) break;
      enclosure = next;
    }
    return enclosure;
  }

  static bool is_regular(const WithGradient& g, const JointNumbers<Affine<2>>& at) {
    return !has_zero(g.by_second.over(at).range()) || !has_zero(g.by_third.over(at).range());
  }

  PairOverBox pair(const WithGradient& tangency, const Box& box) const {
    Box point = box;
    for (std::size_t i = 0; i < 2; ++i) point.lower[i] = point.upper[i] = box.center(i);
    const auto middle = as_ranges(point);
    const auto over = as_forms(box);
    PairOverBox result;
    result.center = {factor_.value.over(middle), tangency.value.over(middle)};
    result.jacobian[0] = {factor_.by_second.over(over).range(), factor_.by_third.over(over).range()};
    result.jacobian[1] = {tangency.by_second.over(over).range(), tangency.by_third.over(over).range()};
    return result;
  }

  WithGradient factor_;
  std::array<WithGradient, 2> tangency_, gradient_;  // by the height and by the squared distance
};

double value_at(const TrigPolynomial& a, const MapPoint& half_turns) {
  const RoundingUpward rounding;
  Box point{2, half_turns, half_turns};
  const Interval value = EnclosedPolynomial(a).over(as_ranges(point));
  return 0.5 * (value.lower() + value.upper());
}

}  // namespace

ArmCusps arm_cusps(const SerialArm& arm, const ArmDeterminant& determinant) {
  const PolynomialVector point = point_behind_first(arm);
  const TrigPolynomial squared = point[0] * point[0] + point[1] * point[1];
  const double base_height = arm.base().linear().col(2).dot(arm.base().translation());
  ArmCusps cusps{{}, true};
  for (const FactorGroup& group : determinant.groups)
    for (const TrigPolynomial& factor : group.factors) {
      KnownZeros found;
      cusps.is_complete = CuspSearch(factor, squared, point[2]).run(found) && cusps.is_complete;
      for (const KnownZero& each : found.all()) {
        const MapPoint at = each.enclosure.middle();
        cusps.all.push_back({std::sqrt(std::max(0.0, value_at(squared, at))),
                             base_height + value_at(point[2], at), half_turn * at[0], half_turn * at[1]});
      }
    }
  return cusps;
}

}  // namespace parallel_aspects
