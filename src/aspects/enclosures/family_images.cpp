// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/enclosures/family_images.h"

#include "aspects/cusps/cosine_sum.h"
#include "aspects/cusps/cusp_functions.h"
#include "interval/scalar_range.h"
#include "model/angles.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace parallel_aspects {
namespace {

// Of boxes that are larger only what excludes them is examined; smaller ones are not divided [half turns].
constexpr double largest_imaged = 0.125, smallest_family_box = 0x1p-11;

using Direction = std::array<double, 3>;
using IntervalRow = std::array<Interval, 3>;

/// The joint of this leg is held at a value.
PlanarHeldSlice slices_of(const Manipulator& manipulator, std::size_t held, double value) {
  return {manipulator, HeldJoint{held, value, false}};
}

/// f and its gradient, by a, phi and the value that is held.
struct Vanishing {
  Interval value;
  IntervalRow gradient;
};

/// D, along which the other joint values move as `slopes` state.
Vanishing determinant_over(const CuspLegs& legs, const std::array<IntervalRow, 3>& slopes,
                           const SliceTurns& at) {
  using Jets = std::array<Jet<1>, 2>;
  const std::array<Jet<2>, 2> g{legs[0].equation.jet<2>(at), legs[1].equation.jet<2>(at)};
  const Jets first{g[0].truncated<1>(), g[1].truncated<1>()};
  const Jet<1> d = bracket(g[0], g[1]);
  const Jets by_joint{legs[0].slope.jet<1>(at), legs[1].slope.jet<1>(at)};
  const Jets by_held{legs[0].held_slope.jet<1>(at), legs[1].held_slope.jet<1>(at)};
  const Interval d_by_0 = bracket(by_joint[0], first[1]).value(),
                 d_by_1 = bracket(first[0], by_joint[1]).value(),
                 d_by_held = (bracket(by_held[0], first[1]) + bracket(first[0], by_held[1])).value();
  Vanishing result{d.value(), {d.at(1, 0), d.at(0, 1), d_by_held}};
  for (std::size_t k = 0; k < 3; ++k) result.gradient[k] += d_by_0 * slopes[0][k] + d_by_1 * slopes[1][k];
  return result;
}

/// Values and f over a box where all are smooth, in the order of both legs whose joints move and that which
/// is held.
struct SmoothFamily {
  std::array<IntervalRow, 3> slopes;  ///< of the values
  Vanishing f;

  /// Nothing where that is not so.
  static std::optional<SmoothFamily> make(const PlanarHeldSlice& slices, const CuspLegs& legs, bool is_serial,
                                          const SlicePlace& at) {
    if (!are_regular(legs)) return std::nullopt;
    SmoothFamily result;
    for (std::size_t i = 0; i < 2; ++i) {
      const Interval entry = slices.joint_entry(i, legs[i], at);
      if (may_vanish(entry)) return std::nullopt;
      const Interval inverse = reciprocal(entry);
      const Jet<1> g = legs[i].equation.jet<1>(at.over());
      result.slopes[i] = {g.at(1, 0) * inverse, g.at(0, 1) * inverse,
                          legs[i].held_slope.jet<0>(at.over()).value() * inverse};
    }
    result.slopes[2] = {0.0, 0.0, 1.0};
    if (is_serial) {
      const PlanarHeldSlice::HeldEntry entry = slices.held_entry_over(at);
      result.f = {entry.value, {entry.by_direction, 0.0, entry.by_held}};
    } else {
      result.f = determinant_over(legs, result.slopes, at.over());
    }
    return result;
  }

  Direction column(std::size_t k) const {
    return {middle_of(slopes[0][k]), middle_of(slopes[1][k]), middle_of(slopes[2][k])};
  }
};

/// Ranges of the values, in the order of `SmoothFamily`; nothing where the box is too large to decide.
using Ranges = std::array<std::optional<Interval>, 3>;

Ranges ranges_over(const PlanarHeldSlice& slices, const SlicePosture& posture, const SlicePlace& at,
                   const Interval& held) {
  return {slices.joint_value(0, posture[0], at), slices.joint_value(1, posture[1], at), held};
}

PlanarHeldSlice held_at(PlanarHeldSlice slices, const Interval& value) noexcept {
  slices.hold(value);
  return slices;
}

/// The same in the middle of a box, with the values there.
struct SmoothMiddle {
  IntervalRow values;
  SmoothFamily functions;

  static std::optional<SmoothMiddle> make(const PlanarHeldSlice& slices, const SlicePosture& posture,
                                          bool is_serial, const Box& box) {
    const Interval held(box.center(2));
    const PlanarHeldSlice slice = held_at(slices, held);
    const SlicePlace at(std::array<double, 2>{box.center(0), box.center(1)});
    const Ranges values = ranges_over(slice, posture, at, held);
    const auto legs = legs_over(slice, posture, at);
    const auto functions = legs ? SmoothFamily::make(slice, *legs, is_serial, at) : std::nullopt;
    if (!functions || !values[0] || !values[1]) return std::nullopt;
    return SmoothMiddle{{*values[0], *values[1], held}, *functions};
  }
};

Direction combined(double s, const Direction& a, double t, const Direction& b) {
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}

double dot_product(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double length_of(const Direction& a) { return std::hypot(a[0], a[1], a[2]); }

/// What of a box of a family is singular, and the strip about its image.
class SingularPart {
 public:
  SingularPart(const Box& box, const SmoothFamily& over, const SmoothMiddle& middle)
      : box_(box), over_(over), center_(middle.functions), middle_(middle.values) {}

  bool may_be_there() const {
    Interval value = center_.f.value;
    for (std::size_t k = 0; k < 3; ++k) value += over_.f.gradient[k] * box_.offset(k);
    return may_vanish(value);
  }

  ImageStrip strip(bool is_serial) const {
    ImageStrip strip;
    strip.frame = is_serial ? serial_frame() : parallel_frame();
    strip.extents[0] = extent(strip.normal(), is_serial ? multiplier_of(strip.normal()) : 0.0);
    for (std::size_t k = 1; k < 3; ++k) strip.extents[k] = extent(strip.frame[k], 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
      Direction axis{};
      axis[i] = 1.0;
      strip.range[i] = extent(axis, 0.0);
    }
    return strip;
  }

 private:
  using Frame = std::array<Direction, 3>;

  static Frame frame_across(const Direction& along, const Direction& other) {
    const Direction normal = normalized(cross(other, along));
    return {normal, along, cross(normal, along)};
  }

  /// In the image are the longer one of the first two columns, which are nearly parallel, and the third.
  Frame parallel_frame() const {
    const Direction a = center_.column(0), phi = center_.column(1);
    return frame_across(normalized(length_of(a) > length_of(phi) ? a : phi), center_.column(2));
  }

  /// In the image are what goes with phi, and with that direction in a and the held value where f stays zero.
  Frame serial_frame() const {
    const double by_a = middle_of(center_.f.gradient[0]), by_held = middle_of(center_.f.gradient[2]);
    return frame_across(normalized(center_.column(1)),
                        combined(-by_held, center_.column(0), by_a, center_.column(2)));
  }

  /// l such that n J = l grad f in the middle.
  double multiplier_of(const Direction& n) const {
    const double by_a = middle_of(center_.f.gradient[0]), by_held = middle_of(center_.f.gradient[2]);
    const std::size_t k = std::abs(by_a) > std::abs(by_held) ? 0 : 2;
    const double slope = middle_of(center_.f.gradient[k]);
    return slope == 0.0 ? 0.0 : dot_product(n, center_.column(k)) / slope;
  }

  /// Of n . q over the singular poses of the box.
  Interval extent(const Direction& n, double multiplier) const {
    const Interval l(multiplier);
    Interval sum = -(l * center_.f.value);
    for (std::size_t i = 0; i < 3; ++i) sum += Interval(n[i]) * middle_[i];
    for (std::size_t k = 0; k < 3; ++k) {
      Interval slope = -(l * over_.f.gradient[k]);
      for (std::size_t i = 0; i < 3; ++i) slope += Interval(n[i]) * over_.slopes[i][k];
      sum += slope * box_.offset(k);
    }
    return sum;
  }

  SliceCenter box_;
  const SmoothFamily &over_, &center_;
  const IntervalRow& middle_;
};

/// An angle that is continuous over a box, of ranges that are less than a turn, in the turn that it has in
/// the middle.
Interval in_turn_of(const Interval& middle, const Interval& range) noexcept {
  const double turn = std::round((middle_of(middle) - middle_of(range)) / full_turn);
  return range + Interval(2.0 * turn) * pi_enclosure();
}

/// What is there of values that are not smooth: ranges alone.
ImageStrip rectangle(const std::array<std::optional<Interval>, 3>& values) {
  ImageStrip strip;
  for (std::size_t i = 0; i < 3; ++i) strip.range[i] = values[i].value_or(all_values);
  return strip;
}

/// The same with entry k in place `to[k]`.
ImageStrip in_order(const ImageStrip& strip, const std::array<std::size_t, 3>& to) {
  ImageStrip result = strip;
  for (std::size_t k = 0; k < 3; ++k) {
    result.range[to[k]] = strip.range[k];
    for (std::size_t i = 0; i < 3; ++i) result.frame[i][to[k]] = strip.frame[i][k];
  }
  return result;
}

}  // namespace

FamilyImages::FamilyImages(const Manipulator& manipulator, const WorkingMode& mode, const ValueSpace& space)
    : SingularImages(space, smallest_family_box) {
  for (std::size_t held = 0; held < 3; ++held) moving_sizes_[held] = manipulator.leg(held).largest_entry();
  for (std::size_t held = 0; held < 3; ++held) {
    if (moving_sizes_[held] == 0.0) continue;
    add(manipulator, mode, held, false);
    add(manipulator, mode, held, true);
  }
  if (singularities_.empty()) add(manipulator, mode, 0, false);
}

void FamilyImages::add(const Manipulator& manipulator, const WorkingMode& mode, std::size_t held,
                       bool is_serial) {
  const Box& values = space().values;
  Singularity each{
      slices_of(manipulator, held, values.center(held)), held, {}, is_serial ? 0 : mode.sign(held), pi};
  if (!manipulator.leg(held).actuated_by_angle())
    each.half_turn *= std::sqrt(manipulator.leg(held).squared_distance(values.center(held)));
  for (std::size_t i = 0; i < 2; ++i) each.posture[i] = mode.sign(each.slices.leg(i));
  singularities_.push_back(each);
  const Box whole{3, {-1.0, -1.0, values.lower[held]}, {1.0, 1.0, values.upper[held]}};
  add_surface(whole, static_cast<Surface>(singularities_.size() - 1));
}

/// Whether another leg is nearer to where it is stretched or folded, all over the box: parallel singularities
/// there are covered by slices that hold its joint, over which its value need not be smooth.
bool FamilyImages::is_left_to_others(const Singularity& of, const PlanarHeldSlice& slices,
                                     const SlicePlace& place) const {
  const Interval least = square(slices.held_entry_over(place).value);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t leg = slices.leg(i);
    if (moving_sizes_[leg] == 0.0) continue;
    const Interval entry = slices.squared_b_entry(i, place) * square(Interval(moving_sizes_[of.held]));
    if (entry.upper() < (least * square(Interval(moving_sizes_[leg]))).lower()) return true;
  }
  return false;
}

/// Whether the box holds no such pose of the mode within limits, or is left to another leg.
bool FamilyImages::is_excluded(const Singularity& of, const PlanarHeldSlice& slices,
                               const std::optional<CuspLegs>& legs, const SlicePlace& place) const {
  const int held_sign = slices.held_sign(place);
  if (of.is_serial() ? held_sign != 0 : held_sign * of.held_sign < 0) return true;
  if (slices.within_limits(of.posture, place) == Verdict::fails) return true;
  if (!of.is_serial() && is_left_to_others(of, slices, place)) return true;
  if (!legs) return false;
  return is_out_of_reach(*legs) || (!of.is_serial() && !may_be_singular(*legs, place.over()));
}

std::optional<ImageStrip> FamilyImages::strip_of(const Box& box, Surface surface) const {
  const Singularity& of = singularities_[surface];
  const Interval held(box.lower[2], box.upper[2]);
  const PlanarHeldSlice slices = held_at(of.slices, held);
  const SlicePlace place = slices.place(box);
  const auto legs = legs_over(slices, of.posture, place);
  if (is_excluded(of, slices, legs, place)) return std::nullopt;
  const std::array<std::size_t, 3> order{slices.leg(0), slices.leg(1), of.held};
  if (std::max(box.width(0), box.width(1)) > largest_imaged)
    return in_order(rectangle({std::nullopt, std::nullopt, held}), order);
  const Ranges ranges = ranges_over(slices, of.posture, place, held);
  const auto over = legs ? SmoothFamily::make(slices, *legs, of.is_serial(), place) : std::nullopt;
  const auto middle = over ? SmoothMiddle::make(of.slices, of.posture, of.is_serial(), box) : std::nullopt;
  if (!middle) return in_order(rectangle(ranges), order);
  const SingularPart part(box, *over, *middle);
  if (!part.may_be_there()) return std::nullopt;
  ImageStrip strip = part.strip(of.is_serial());
  for (std::size_t i = 0; i < 3; ++i)
    if (ranges[i])
      strip.range[i] =
          intersection(strip.range[i],
                       space().are_angles[order[i]] ? in_turn_of(middle->values[i], *ranges[i]) : *ranges[i]);
  return in_order(strip, order);
}

}  // namespace parallel_aspects
