// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/cusp_search.h"

#include "aspects/uniqueness/krawczyk.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

/// D and {D, g_i} with derivatives up to an order, and g_i.
template <std::size_t Order>
struct CuspFunctions {
  std::array<Jet<Order + 2>, 2> g;
  Jet<Order + 1> d;
  std::array<Jet<Order>, 2> along_kernel;

  CuspFunctions(const StrutSlice& slice, const SliceTurns& at)
      : g{slice.half_square<Order + 2>(0, at), slice.half_square<Order + 2>(1, at)}, d(bracket(g[0], g[1])) {
    for (std::size_t i = 0; i < 2; ++i) along_kernel[i] = bracket(d, g[i].template truncated<Order + 1>());
  }
};

using Over = CuspFunctions<1>;
using AtCenter = CuspFunctions<0>;

template <std::size_t N>
bool may_vanish(const Interval& center, const Jet<N>& over, const SliceCenter& middle) {
  return may_vanish(over.value()) &&
         may_vanish(center + over.at(1, 0) * middle.offset(0) + over.at(0, 1) * middle.offset(1));
}

bool may_hold_cusp(const Over& over, const AtCenter& center, const SliceCenter& middle) {
  if (!may_vanish(center.d.value(), over.d, middle)) return false;
  for (std::size_t i = 0; i < 2; ++i)
    if (!may_vanish(center.along_kernel[i].value(), over.along_kernel[i], middle)) return false;
  return true;
}

double gradient_norm(const Jet<2>& g) { return std::hypot(middle_of(g.at(1, 0)), middle_of(g.at(0, 1))); }

PairOverBox pair_of(const Over& over, const AtCenter& center, std::size_t i) {
  return {
      {center.d.value(), center.along_kernel[i].value()},
      {{{over.d.at(1, 0), over.d.at(0, 1)}, {over.along_kernel[i].at(1, 0), over.along_kernel[i].at(0, 1)}}}};
}

class CuspSearch {
 public:
  CuspSearch(const StrutSlice& slice, const MapControl& control) : slice_(slice), control_(control) {}

  CuspBoxes run() {
    boxes_.push_back(whole_slice());
    for (std::size_t effort = 0; !boxes_.empty(); ++effort) {
      if (effort % 1024 == 0 && is_cancelled(control_)) result_.cancelled = true;
      if (result_.cancelled) break;
      const Box box = boxes_.back();
      boxes_.pop_back();
      if (effort < largest_effort)
        examine(box);
      else
        result_.undecided.push_back(box);
    }
    for (const Known& each : known_) result_.cusps.push_back(without_turns(each.enclosure));
    return std::move(result_);
  }

 private:
  struct Known {
    Box unique;     // holds one cusp
    Box enclosure;  // of it
  };

  void examine(const Box& box) {
    if (is_known(box)) return;
    const SliceCenter middle(box);
    const Over over(slice_, SliceTurns(ranges_of(box)));
    const AtCenter center(slice_, SliceTurns(middle.at));
    if (!may_hold_cusp(over, center, middle)) return;
    const double width = std::max(box.width(0), box.width(1));
    if (width < largest_tested && is_settled(scaled(box, inflation))) return;
    if (width < smallest_box) return result_.undecided.push_back(box);
    for (const Box& half : halves_of(box)) boxes_.push_back(half);
  }

  bool is_known(const Box& box) const {
    return std::any_of(known_.begin(), known_.end(),
                       [&](const Known& each) { return contains_up_to_turns(each.unique, box); });
  }

  ZeroSearch newton(const Box& box, std::size_t i) const {
    const Over over(slice_, SliceTurns(ranges_of(box)));
    const AtCenter center(slice_, SliceTurns(SliceCenter(box).at));
    return krawczyk_test(box, pair_of(over, center, i));
  }

  /// Whether it is proved that the box holds no cusp, or one, which then is known.
  bool is_settled(const Box& box) {
    const AtCenter center(slice_, SliceTurns(SliceCenter(box).at));
    const std::size_t i = gradient_norm(center.g[0]) > gradient_norm(center.g[1]) ? 0 : 1;
    const ZeroSearch found = newton(box, i);
    if (found.zeros != Zeros::one) return found.zeros == Zeros::none;
    Box enclosure = found.enclosure;
    for (int k = 0; k < contractions; ++k)
      enclosure = intersection(enclosure, newton(enclosure, i).enclosure);
    return has_rank_one(enclosure, i) && note({box, enclosure});
  }

  bool has_rank_one(const Box& box, std::size_t i) const {
    const auto g = slice_.half_square<1>(i, SliceTurns(ranges_of(box)));
    return !may_vanish(g.at(1, 0)) || !may_vanish(g.at(0, 1));
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

  const StrutSlice& slice_;
  const MapControl& control_;
  std::vector<Box> boxes_;
  std::vector<Known> known_;
  CuspBoxes result_;
};

}  // namespace

CuspBoxes find_cusp_boxes(const StrutSlice& slice, const MapControl& control) {
  assert_rounding_upward();
  return CuspSearch(slice, control).run();
}

}  // namespace parallel_aspects
