// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/strut_slice.h"

#include "aspects/cusps/cusp_functions.h"
#include "aspects/cusps/jet.h"
#include "aspects/zeros/krawczyk.h"
#include "interval/scalar_range.h"
#include "legs/held_leg.h"
#include "model/angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace parallel_aspects {
namespace {

Planar<Interval> anchor_of(const Leg& leg) noexcept { return {leg.anchor.x(), leg.anchor.y()}; }

Planar<Interval> base_of(const Leg& leg) noexcept { return {leg.base_point().x(), leg.base_point().y()}; }

Planar<Interval> difference(const Planar<Interval>& a, const Planar<Interval>& b) noexcept {
  return {a.x - b.x, a.y - b.y};
}

/// Of the anchor over the plane of the base point [m].
Interval height_of(const Leg& leg) noexcept {
  return Interval(leg.anchor.z()) - Interval(leg.base_point().z());
}

/// rho^2 / 2 of a strut that has this joint value; 0 where its length would be negative.
Interval half_square_at(const Leg& leg, double q) {
  if (!leg.can_have(q)) return 0.0;
  const Interval in_plane = HeldLeg(leg, q, 0.0).rod(Turn<Interval>{1.0, 0.0}).x;
  return Interval(0.5) * (square(in_plane) + square(height_of(leg)));
}

/// The same at the shortest and at the longest length within limits.
std::array<Interval, 2> limits_of(const Leg& leg) {
  const bool rises = leg.has_branch(1);
  const double shortest = rises ? leg.limits.lower : leg.limits.upper;
  const double longest = rises ? leg.limits.upper : leg.limits.lower;
  return {std::isfinite(shortest) ? half_square_at(leg, shortest) : Interval(0.0),
          std::isfinite(longest) ? half_square_at(leg, longest) : Interval(HUGE_VAL)};
}

}  // namespace

StrutSlice::StrutSlice(const Manipulator& manipulator, const MapSlice& slice) : held_(slice.joint->leg) {
  assert_rounding_upward();
  add_legs(manipulator);
  const HeldLeg rod(manipulator.leg(held_), slice.joint->value, 0.0);
  set_rod(rod.rod(Turn<Interval>{1.0, 0.0}).x);
}

StrutSlice::StrutSlice(const Manipulator& manipulator, std::size_t held) : dimension_(3), held_(held) {
  assert_rounding_upward();
  add_legs(manipulator);
  set_rod(with_half_square({held_limits_[0].lower(), held_limits_[1].upper()}).rod_);
}

void StrutSlice::add_legs(const Manipulator& manipulator) {
  held_squared_height_ = square(height_of(manipulator.leg(held_)));
  held_limits_ = limits_of(manipulator.leg(held_));
  for (std::size_t i = 0, j = 0; j < manipulator.leg_count(); ++j)
    if (j != held_) legs_[i++] = MovingLeg(manipulator, held_, j);
}

void StrutSlice::set_rod(const Interval& rod) noexcept {
  rod_ = rod;
  for (MovingLeg& leg : legs_) leg.set_rod(rod);
}

Box StrutSlice::whole() const noexcept {
  Box box = whole_slice();
  if (dimension_ == 2) return box;
  box.dimension = 3;
  box.lower[2] = rod_.lower();
  box.upper[2] = rod_.upper();
  return box;
}

StrutSlice StrutSlice::with_rod(const Interval& rod) const noexcept {
  StrutSlice result = *this;
  result.dimension_ = 2;
  result.set_rod(rod);
  return result;
}

StrutSlice StrutSlice::with_half_square(const Interval& value) const noexcept {
  return with_rod(square_root(not_negative_part(Interval(2.0) * value - held_squared_height_)));
}

StrutSlice StrutSlice::at(const Lengths& lengths) const noexcept {
  return dimension_ == 2 ? *this : with_half_square(Interval(0.5) * square(Interval(lengths[2])));
}

StrutSlice StrutSlice::over(const Box& box) const noexcept {
  return dimension_ == 2 ? *this : with_rod({box.lower[2], box.upper[2]});
}

Interval StrutSlice::held_half_square() const noexcept {
  return Interval(0.5) * (square(rod_) + held_squared_height_);
}

StrutSlice::MovingLeg::MovingLeg(const Manipulator& manipulator, std::size_t held, std::size_t j) : index(j) {
  const Leg &leg = manipulator.leg(j), &other = manipulator.leg(held);
  between_anchors = difference(anchor_of(leg), anchor_of(other));
  between_bases = difference(base_of(other), base_of(leg));
  squared_height = square(height_of(leg));
  limits = limits_of(leg);
}

void StrutSlice::MovingLeg::set_rod(const Interval& rod) noexcept {
  half_square = CosineSum::half_square(rod, between_anchors, between_bases, squared_height);
  const Interval sum =
      rod + square_root(squared_norm(between_anchors)) + square_root(squared_norm(between_bases));
  largest = (Interval(0.5) * (square(sum) + squared_height)).upper();
}

namespace {

// Half lengths of boxes about cusps along the curve that are tried: the first, and how often it is halved
// [half turns].
constexpr double largest_half = 0.1;
constexpr int halvings = 16;

// Such a box is wider than the tangent of the curve needs by these parts of its length, tried in turn.
constexpr std::array<double, 3> rooms_across{0.25, 0.5, 1.0};

// Parts of such a box, and of one of its faces, that are examined.
constexpr std::size_t most_parts = 1000, most_parts_of_face = 64;

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

/// Whether one of both is proved of each part of a box: D does not vanish, or signs hold.
template <class Hold>
bool is_covered(const StrutSlice& slice, const Box& whole, std::size_t most, const Hold& hold) {
  std::vector<Box> boxes{whole};
  for (std::size_t effort = 0; !boxes.empty(); ++effort) {
    if (effort >= most) return false;
    const Box box = boxes.back();
    boxes.pop_back();
    if (is_off(slice, box) || hold(box)) continue;
    for (const Box& half : halves_of(box)) boxes.push_back(half);
  }
  return true;
}

/// A cusp, and which way its curve goes.
struct CuspPlace {
  Box cusp;
  std::array<double, 2> center;
  std::size_t across;  // the axis along which D changes more
  double rise;         // of the curve along it, over what it goes along the other
  CuspSigns signs;

  CuspPlace(const StrutSlice& slice, const Box& of)
      : CuspPlace(of, ArcFunctions(slice, SliceTurns(std::array{of.center(0), of.center(1)}))) {}

  Box box(double half, double room) const {
    Box result{2, {}, {}};
    for (std::size_t k = 0; k < 2; ++k) {
      const double reach = k == across ? (rise + room) * half : half;
      result.lower[k] = center[k] - reach;
      result.upper[k] = center[k] + reach;
    }
    return result;
  }

 private:
  CuspPlace(const Box& of, const ArcFunctions& at)
      : cusp(of),
        center{of.center(0), of.center(1)},
        across(std::abs(slope(at, 0)) > std::abs(slope(at, 1)) ? 0 : 1),
        rise(std::abs(slope(at, 1 - across) / slope(at, across))),
        signs(at, across) {}

  static double slope(const ArcFunctions& at, std::size_t axis) {
    return middle_of(axis == 0 ? at.d.at(1, 0) : at.d.at(0, 1));
  }
};

bool is_injective(const StrutSlice& slice, const CuspPlace& at, const Box& box) {
  const auto never = [](const Box& /*part*/) { return false; };
  const auto hold = [&](const Box& part) { return at.signs.hold(ArcFunctions(slice, part)); };
  return contains(box, at.cusp) &&
         is_covered(slice, face_of(box, at.across, false), most_parts_of_face, never) &&
         is_covered(slice, face_of(box, at.across, true), most_parts_of_face, never) &&
         is_covered(slice, box, most_parts, hold);
}

/// The largest box about a cusp of which it is proved.
std::optional<Box> find_box_about(const StrutSlice& slice, const Box& cusp) {
  const CuspPlace at(slice, cusp);
  double half = largest_half;
  for (int i = 0; i < halvings; ++i, half *= 0.5)
    for (const double room : rooms_across)
      if (const Box box = at.box(half, room); is_injective(slice, at, box)) return box;
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
