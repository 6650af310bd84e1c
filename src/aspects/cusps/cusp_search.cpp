// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/cusp_search.h"

#include "aspects/cusps/krawczyk.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace parallel_aspects {
namespace {

// Boxes that are larger are not worth Newton's test, and smaller ones not worth being divided [half turns].
constexpr double largest_tested = 0.1, smallest_box = 0x1p-30;

// Boxes that are looked at in all. A slice with some ten cusps takes some ten thousand.
constexpr std::size_t largest_effort = 1000000;

// Newton's test of a somewhat larger box also proves cusps that lie on a face.
constexpr double inflation = 1.5;

// What is left after these is rounding.
constexpr int contractions = 8;

bool may_vanish(const Interval& value) { return !value.positive() && !value.negative(); }

using Legs = std::array<HeldSlice::LegOver, 2>;

/// Both legs over a box; nothing where it is too large to tell.
std::optional<Legs> legs_over(const HeldSlice& slice, const SlicePosture& posture, const SliceTurns& at) {
  const auto first = slice.leg_over(0, posture[0], at);
  if (!first) return std::nullopt;
  const auto second = slice.leg_over(1, posture[1], at);
  if (!second) return std::nullopt;
  return Legs{*first, *second};
}

/// D and {D, g_i} with derivatives up to an order, and g_i, all at fixed joint values.
template <std::size_t Order>
struct CuspFunctions {
  std::array<Jet<Order + 2>, 2> g;
  Jet<Order + 1> d;
  std::array<Jet<Order>, 2> along_kernel;

  CuspFunctions(const HeldSlice& slice, const Legs& legs, const SliceTurns& at)
      : g{slice.equation<Order + 2>(0, legs[0], at), slice.equation<Order + 2>(1, legs[1], at)},
        d(bracket(g[0], g[1])) {
    for (std::size_t i = 0; i < 2; ++i) along_kernel[i] = bracket(d, g[i].template truncated<Order + 1>());
  }
};

using Over = CuspFunctions<1>;
using AtCenter = CuspFunctions<0>;
using Gradient = std::array<Interval, 2>;

/// Gradients of D and of both {D, g_i} over the slice, along which the joint values move.
struct TotalGradients {
  Gradient d;
  std::array<Gradient, 2> along_kernel;

  TotalGradients(const HeldSlice& slice, const Legs& legs, const Over& over, const SliceTurns& at) {
    const std::array<Jet<2>, 2> by_joint{slice.slope<2>(0, legs[0], at), slice.slope<2>(1, legs[1], at)};
    const std::array<Jet<1>, 2> d_by_joint{bracket(by_joint[0], over.g[1].truncated<2>()),
                                           bracket(over.g[0].truncated<2>(), by_joint[1])};
    const auto total = [&](const Jet<1>& fixed, const std::array<Interval, 2>& by) {
      Gradient sum{fixed.at(1, 0), fixed.at(0, 1)};
      for (std::size_t j = 0; j < 2; ++j) {
        const Interval factor = by[j] * reciprocal(legs[j].entry);
        sum[0] += factor * over.g[j].at(1, 0);
        sum[1] += factor * over.g[j].at(0, 1);
      }
      return sum;
    };
    d = total(over.d.truncated<1>(), {d_by_joint[0].value(), d_by_joint[1].value()});
    for (std::size_t i = 0; i < 2; ++i) {
      std::array<Interval, 2> by;
      for (std::size_t j = 0; j < 2; ++j) by[j] = bracket(d_by_joint[j], over.g[i].truncated<1>()).value();
      by[i] += bracket(over.d.truncated<1>(), by_joint[i].truncated<1>()).value();
      along_kernel[i] = total(over.along_kernel[i], by);
    }
  }
};

bool may_vanish(const Interval& center, const Gradient& gradient, const SliceCenter& middle) {
  return may_vanish(center + gradient[0] * middle.offset(0) + gradient[1] * middle.offset(1));
}

double gradient_norm(const Jet<1>& g) { return std::hypot(middle_of(g.at(1, 0)), middle_of(g.at(0, 1))); }

/// Whether neither leg can be stretched or folded in the box, so that both joint values are smooth over it.
bool are_regular(const Legs& legs) {
  return std::all_of(legs.begin(), legs.end(), [](const HeldSlice::LegOver& leg) {
    return leg.reaches == Verdict::holds && !may_vanish(leg.entry);
  });
}

/// A box of the slice in one posture.
class CuspTest {
 public:
  CuspTest(const HeldSlice& slice, const SlicePosture& posture, const Box& box)
      : slice_(slice), posture_(posture), box_(box), over_(SliceTurns(ranges_of(box))) {}

  bool may_hold_cusp() const {
    const auto legs = legs_over(slice_, posture_, over_);
    if (!legs) return true;
    for (const HeldSlice::LegOver& leg : *legs)
      if (leg.reaches == Verdict::fails) return false;
    const Over over(slice_, *legs, over_);
    if (!may_vanish(over.d.value()) || !may_vanish(over.along_kernel[0].value()) ||
        !may_vanish(over.along_kernel[1].value()))
      return false;
    const SliceCenter middle(box_);
    const auto center = at_center(middle);
    if (!are_regular(*legs) || !center) return true;
    const TotalGradients slopes(slice_, *legs, over, over_);
    return may_vanish(center->d.value(), slopes.d, middle) &&
           may_vanish(center->along_kernel[0].value(), slopes.along_kernel[0], middle) &&
           may_vanish(center->along_kernel[1].value(), slopes.along_kernel[1], middle);
  }

  /// The equation that is the better one of the two in the middle; nothing where none is of use.
  std::optional<std::size_t> better_equation() const {
    const auto center = at_center(SliceCenter(box_));
    if (!center) return std::nullopt;
    return gradient_norm(center->g[0].truncated<1>()) > gradient_norm(center->g[1].truncated<1>()) ? 0 : 1;
  }

  /// Of D and {D, g_i}.
  ZeroSearch newton(std::size_t i) const {
    const auto legs = legs_over(slice_, posture_, over_);
    const auto center = at_center(SliceCenter(box_));
    if (!legs || !are_regular(*legs) || !center) return {Zeros::unknown, box_};
    const TotalGradients slopes(slice_, *legs, Over(slice_, *legs, over_), over_);
    return krawczyk_test(
        box_, {{center->d.value(), center->along_kernel[i].value()}, {{slopes.d, slopes.along_kernel[i]}}});
  }

  /// Whether the gradient of g_i does not vanish.
  bool has_rank_one(std::size_t i) const {
    const auto leg = slice_.leg_over(i, posture_[i], over_);
    if (!leg) return false;
    const auto g = slice_.equation<1>(i, *leg, over_);
    return !may_vanish(g.at(1, 0)) || !may_vanish(g.at(0, 1));
  }

 private:
  std::optional<AtCenter> at_center(const SliceCenter& middle) const {
    const SliceTurns at(middle.at);
    const auto legs = legs_over(slice_, posture_, at);
    if (!legs || !are_regular(*legs)) return std::nullopt;
    return AtCenter(slice_, *legs, at);
  }

  const HeldSlice& slice_;
  SlicePosture posture_;
  Box box_;
  SliceTurns over_;
};

/// The search in one posture.
class CuspSearch {
 public:
  CuspSearch(const HeldSlice& slice, const SlicePosture& posture, const MapControl& control)
      : slice_(slice), posture_(posture), control_(control) {}

  void run(CuspBoxes& result) {
    boxes_.push_back(whole_slice());
    for (std::size_t effort = 0; !boxes_.empty(); ++effort) {
      if (effort % 1024 == 0 && is_cancelled(control_)) result.cancelled = true;
      if (result.cancelled) break;
      const Box box = boxes_.back();
      boxes_.pop_back();
      if (effort >= largest_effort || !examine(box)) result.undecided.push_back({box, posture_});
    }
    for (const Known& each : known_) result.cusps.push_back({without_turns(each.enclosure), posture_});
  }

 private:
  struct Known {
    Box unique;     // holds one cusp
    Box enclosure;  // of it
  };

  CuspTest test(const Box& box) const { return {slice_, posture_, box}; }

  /// False where the box is too small to be divided.
  bool examine(const Box& box) {
    if (is_known(box) || !test(box).may_hold_cusp()) return true;
    const double width = std::max(box.width(0), box.width(1));
    if (width < largest_tested && is_settled(scaled(box, inflation))) return true;
    if (width < smallest_box) return false;
    for (const Box& half : halves_of(box)) boxes_.push_back(half);
    return true;
  }

  bool is_known(const Box& box) const {
    return std::any_of(known_.begin(), known_.end(),
                       [&](const Known& each) { return contains_up_to_turns(each.unique, box); });
  }

  /// Whether it is proved that the box holds no cusp, or one, which then is known.
  bool is_settled(const Box& box) {
    const auto i = test(box).better_equation();
    if (!i) return false;
    const ZeroSearch found = test(box).newton(*i);
    if (found.zeros != Zeros::one) return found.zeros == Zeros::none;
    Box enclosure = found.enclosure;
    for (int k = 0; k < contractions; ++k)
      enclosure = intersection(enclosure, test(enclosure).newton(*i).enclosure);
    return test(enclosure).has_rank_one(*i) && note({box, enclosure});
  }

  /// Whether it is proved that the cusp is a known one, or none of these.
  bool note(const Known& found) {
    for (const Known& each : known_) {
      if (contains_up_to_turns(each.unique, found.enclosure)) return true;
      if (contains_up_to_turns(found.unique, each.enclosure)) return true;
      if (meet_up_to_turns(found.enclosure, each.enclosure)) return false;
    }
    known_.push_back(found);
    return true;
  }

  const HeldSlice& slice_;
  SlicePosture posture_;
  const MapControl& control_;
  std::vector<Box> boxes_;
  std::vector<Known> known_;
};

}  // namespace

CuspBoxes find_cusp_boxes(const HeldSlice& slice, const MapControl& control) {
  assert_rounding_upward();
  CuspBoxes result;
  for (const SlicePosture& posture : slice.postures()) CuspSearch(slice, posture, control).run(result);
  return result;
}

}  // namespace parallel_aspects
