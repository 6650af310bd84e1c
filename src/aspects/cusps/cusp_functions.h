// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_FUNCTIONS_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_FUNCTIONS_H

#include "aspects/cusps/held_slice.h"
#include "aspects/cusps/jet.h"
#include "interval/interval.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

// The functions that vanish at cusps, see `find_cusp_boxes`. All of it needs a live `RoundingUpward`.

namespace parallel_aspects {

/// Both legs whose joints move, over a box.
using CuspLegs = std::array<HeldSlice::LegOver, 2>;

/// Nothing where the box is too large to decide.
inline std::optional<CuspLegs> legs_over(const HeldSlice& slice, const SlicePosture& posture,
                                         const SlicePlace& at) noexcept {
  const auto first = slice.leg_over(0, posture[0], at);
  if (!first) return std::nullopt;
  const auto second = slice.leg_over(1, posture[1], at);
  if (!second) return std::nullopt;
  return CuspLegs{*first, *second};
}

/// Whether one of them reaches nothing of the box.
inline bool is_out_of_reach(const CuspLegs& legs) noexcept {
  return legs[0].reaches == Verdict::fails || legs[1].reaches == Verdict::fails;
}

/// Whether neither leg can be stretched or folded in the box, so that both joint values are smooth over it.
inline bool are_regular(const CuspLegs& legs) noexcept {
  return std::all_of(legs.begin(), legs.end(), [](const HeldSlice::LegOver& leg) {
    return leg.reaches == Verdict::holds && !may_vanish(leg.entry);
  });
}

/// Whether D may vanish, by what that takes alone.
inline bool may_be_singular(const CuspLegs& legs, const SliceTurns& at) noexcept {
  return may_vanish(bracket(legs[0].equation.jet<1>(at), legs[1].equation.jet<1>(at)).value());
}

/// D and {D, g_i} with derivatives up to an order, and g_i, all at fixed joint values.
template <std::size_t Order>
struct CuspFunctions {
  std::array<Jet<Order + 2>, 2> g;
  Jet<Order + 1> d;
  std::array<Jet<Order>, 2> along_kernel;

  CuspFunctions(const CuspLegs& legs, const SliceTurns& at)
      : g{legs[0].equation.jet<Order + 2>(at), legs[1].equation.jet<Order + 2>(at)}, d(bracket(g[0], g[1])) {
    for (std::size_t i = 0; i < 2; ++i) along_kernel[i] = bracket(d, g[i].template truncated<Order + 1>());
  }

  bool may_have_cusp() const noexcept {
    return may_vanish(d.value()) && may_vanish(along_kernel[0].value()) &&
           may_vanish(along_kernel[1].value());
  }

  /// The equation whose gradient is the longer one.
  std::size_t better_equation() const noexcept {
    const auto length = [this](std::size_t i) {
      return std::hypot(middle_of(g[i].at(1, 0)), middle_of(g[i].at(0, 1)));
    };
    return length(0) > length(1) ? 0 : 1;
  }
};

/// By the coordinates of a slice, or of a family of them, whose third is the value that is held.
template <std::size_t Dimension>
using CuspGradient = std::array<Interval, Dimension>;

/// Gradients of D and of both {D, g_i} over the slice or family, along which the joint values move.
template <std::size_t Dimension>
struct TotalGradients {
  CuspGradient<Dimension> d;
  std::array<CuspGradient<Dimension>, 2> along_kernel;

  TotalGradients(const CuspLegs& legs, const CuspFunctions<1>& over, const SliceTurns& at) {
    const Jets<2> by_joint{legs[0].slope.jet<2>(at), legs[1].slope.jet<2>(at)};
    const Jets<2> g{over.g[0].truncated<2>(), over.g[1].truncated<2>()};
    const Jets<1> d_by_joint{bracket(by_joint[0], g[1]), bracket(g[0], by_joint[1])};
    set_fixed(legs, over, at);
    for (std::size_t j = 0; j < 2; ++j) {
      const Interval d_by = d_by_joint[j].value();
      std::array<Interval, 2> along_by{bracket(d_by_joint[j], over.g[0].truncated<1>()).value(),
                                       bracket(d_by_joint[j], over.g[1].truncated<1>()).value()};
      along_by[j] += bracket(over.d.truncated<1>(), by_joint[j].truncated<1>()).value();
      for (std::size_t k = 0; k < Dimension; ++k) {
        const Interval joint_slope = reciprocal(legs[j].entry) * slopes_[j][k];
        d[k] += d_by * joint_slope;
        for (std::size_t i = 0; i < 2; ++i) along_kernel[i][k] += along_by[i] * joint_slope;
      }
    }
  }

 private:
  template <std::size_t Order>
  using Jets = std::array<Jet<Order>, 2>;

  /// At fixed joint values.
  void set_fixed(const CuspLegs& legs, const CuspFunctions<1>& over, const SliceTurns& at) {
    const auto set = [](const Jet<1>& jet, CuspGradient<Dimension>& gradient) {
      gradient[0] = jet.at(1, 0);
      gradient[1] = jet.at(0, 1);
    };
    set(over.d.truncated<1>(), d);
    for (std::size_t i = 0; i < 2; ++i) {
      set(over.along_kernel[i], along_kernel[i]);
      set(over.g[i].template truncated<1>(), slopes_[i]);
    }
    if constexpr (Dimension == 3) set_fixed_by_held(legs, over, at);
  }

  void set_fixed_by_held(const CuspLegs& legs, const CuspFunctions<1>& over, const SliceTurns& at) {
    const Jets<2> by_held{legs[0].held_slope.jet<2>(at), legs[1].held_slope.jet<2>(at)};
    const Jet<1> d_by_held =
        bracket(by_held[0], over.g[1].truncated<2>()) + bracket(over.g[0].truncated<2>(), by_held[1]);
    d[2] = d_by_held.value();
    for (std::size_t i = 0; i < 2; ++i) {
      along_kernel[i][2] = bracket(d_by_held, over.g[i].truncated<1>()).value() +
                           bracket(over.d.truncated<1>(), by_held[i].truncated<1>()).value();
      slopes_[i][2] = by_held[i].value();
    }
  }

  std::array<CuspGradient<Dimension>, 2> slopes_;  // of g_i: divided by B_jj those of the joint values
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_FUNCTIONS_H
