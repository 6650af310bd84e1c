// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/injective_boxes.h"

#include "aspects/cusps/cusp_functions.h"
#include "aspects/cusps/jet.h"
#include "aspects/zeros/krawczyk.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace parallel_aspects {
namespace {

// Half lengths of boxes about cusps along the curve that are tried: the first, and how often it is halved
// [half turns].
constexpr double largest_half = 0.1;
constexpr int halvings = 16;

// Half the width of such a box over what the curve rises on half of its length.
constexpr double room_across = 2.0, least_across = 0.25;

// Parts of such a box that are looked at.
constexpr std::size_t most_parts = 1000;

/// What the proofs need of g, D and {D, g_i} over a box.
struct ArcFunctions {
  std::array<Jet<3>, 2> g;
  Jet<2> d;
  std::array<Jet<1>, 2> along;

  /// Over a box.
  ArcFunctions(const StrutSlice& slice, const Box& box) : ArcFunctions(slice, SliceTurns(ranges_of(box))) {}

  ArcFunctions(const StrutSlice& slice, const SliceTurns& at)
      : g{slice.half_square<3>(0, at), slice.half_square<3>(1, at)}, d(bracket(g[0], g[1])) {
    for (std::size_t i = 0; i < 2; ++i) along[i] = bracket(d, g[i].truncated<2>());
  }

  /// Whether the image of D = 0 moves one way along some direction.
  bool move_one_way() const {
    if (!may_vanish(along[0].value()) || !may_vanish(along[1].value())) return true;
    const Interval first(middle_of(along[0].value())), second(middle_of(along[1].value()));
    return !may_vanish(first * along[0].value() + second * along[1].value());
  }
};

/// What has one sign along D = 0 about a cusp: n.w, {D, w} x w, {D, n.k w} and a derivative of D.
class CuspSigns {
 public:
  CuspSigns(const ArcFunctions& at_cusp, std::size_t across) : across_(across) {
    const auto length = [&](std::size_t axis) {
      const Jet<2> w0 = at_cusp.g[0].derivative(axis), w1 = at_cusp.g[1].derivative(axis);
      return std::hypot(middle_of(w0.value()), middle_of(w1.value()));
    };
    column_ = length(0) > length(1) ? 0 : 1;
    for (std::size_t i = 0; i < 2; ++i)
      normal_[i] = Interval(middle_of(at_cusp.g[i].derivative(column_).value()));
    const std::array<Interval, 4> values = values_of(at_cusp);
    for (std::size_t i = 0; i < 4; ++i) signs_[i] = Interval(middle_of(values[i]) < 0.0 ? -1.0 : 1.0);
  }

  bool hold(const ArcFunctions& over) const {
    const std::array<Interval, 4> values = values_of(over);
    for (std::size_t i = 0; i < 4; ++i)
      if (!(signs_[i] * values[i]).positive()) return false;
    return true;
  }

 private:
  std::array<Interval, 4> values_of(const ArcFunctions& f) const {
    const std::array<Jet<1>, 2> w{f.g[0].derivative(column_).truncated<1>(),
                                  f.g[1].derivative(column_).truncated<1>()};
    const Jet<1> d = f.d.truncated<1>();
    return {normal_[0] * w[0].value() + normal_[1] * w[1].value(),
            w[0].value() * bracket(d, w[1]).value() - w[1].value() * bracket(d, w[0]).value(),
            bracket(d, normal_[0] * f.along[0] + normal_[1] * f.along[1]).value(),
            across_ == 0 ? d.at(1, 0) : d.at(0, 1)};
  }

  std::size_t across_, column_ = 0;
  std::array<Interval, 2> normal_;
  std::array<Interval, 4> signs_;
};

/// The face of a box at one end of an axis.
Box face_of(const Box& box, std::size_t axis, bool upper) {
  Box face = box;
  face.lower[axis] = face.upper[axis] = upper ? box.upper[axis] : box.lower[axis];
  return face;
}

/// Whether D does not vanish on a box or a face.
bool is_off(const StrutSlice& slice, const Box& box) {
  const SliceCenter middle(box);
  const SliceTurns over(ranges_of(box)), at(middle.at);
  const Jet<1> d = bracket(slice.half_square<2>(0, over), slice.half_square<2>(1, over));
  const Interval center = bracket(slice.half_square<1>(0, at), slice.half_square<1>(1, at)).value();
  return !may_vanish(d.value()) ||
         !may_vanish(center + d.at(1, 0) * middle.offset(0) + d.at(0, 1) * middle.offset(1));
}

/// Whether they do at all poses of D = 0 in a box.
bool hold_along(const StrutSlice& slice, const CuspSigns& signs, const Box& whole) {
  std::vector<Box> boxes{whole};
  for (std::size_t effort = 0; !boxes.empty(); ++effort) {
    if (effort >= most_parts) return false;
    const Box box = boxes.back();
    boxes.pop_back();
    if (is_off(slice, box) || signs.hold(ArcFunctions(slice, box))) continue;
    for (const Box& half : halves_of(box)) boxes.push_back(half);
  }
  return true;
}

/// The largest box about a cusp of which it is proved.
std::optional<Box> find_box_about(const StrutSlice& slice, const Box& cusp) {
  const std::array<double, 2> center{cusp.center(0), cusp.center(1)};
  const ArcFunctions at(slice, SliceTurns(center));
  const std::array<double, 2> slope{middle_of(at.d.at(1, 0)), middle_of(at.d.at(0, 1))};
  const std::size_t across = std::abs(slope[0]) > std::abs(slope[1]) ? 0 : 1;
  const double rise = std::abs(slope[1 - across] / slope[across]);
  const CuspSigns signs(at, across);
  double half = largest_half;
  for (int i = 0; i < halvings; ++i, half *= 0.5) {
    Box box{2, {}, {}};
    for (std::size_t k = 0; k < 2; ++k) {
      const double reach = k == across ? std::max(room_across * rise, least_across) * half : half;
      box.lower[k] = center[k] - reach;
      box.upper[k] = center[k] + reach;
    }
    if (contains(box, cusp) && is_off(slice, face_of(box, across, false)) &&
        is_off(slice, face_of(box, across, true)) && hold_along(slice, signs, box))
      return box;
  }
  return std::nullopt;
}

}  // namespace

InjectiveBoxes::InjectiveBoxes(const StrutSlice& slice, const std::vector<Box>& cusps) : slice_(slice) {
  for (const Box& cusp : cusps)
    if (const auto box = find_box_about(slice, cusp)) about_cusps_.push_back(*box);
}

bool InjectiveBoxes::holds(const Box& box) const {
  return std::any_of(about_cusps_.begin(), about_cusps_.end(),
                     [&](const Box& each) { return contains_up_to_turns(each, box); }) ||
         ArcFunctions(slice_, box).move_one_way();
}

}  // namespace parallel_aspects
