// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/enclosures/strut_images.h"

#include "interval/scalar_range.h"
#include "legs/link_points.h"
#include "model/angles.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr double smallest_singular_box = 0x1p-26;  // [half turns]

using Direction = std::array<double, 3>;

/// Both g_i with derivatives by a and phi; by the rod of a family, too, and g_2, which is of the rod alone.
struct Functions {
  std::array<Jet<2>, 2> g;
  std::array<Jet<1>, 2> slope;
  Interval held, held_slope;

  Functions(const StrutSlice& family, const StrutSlice& slices, const SliceTurns& turns)
      : g{slices.half_square<2>(0, turns), slices.half_square<2>(1, turns)} {
    if (family.dimension() == 2) return;
    slope = {slices.slope<1>(0, turns), slices.slope<1>(1, turns)};
    held = slices.held_half_square();
    held_slope = slices.rod();
  }
};

/// Of D, the bracket of both, by the rod.
Interval determinant_slope(const Functions& f) {
  const auto product = [&](std::size_t i, std::size_t j) {
    return f.slope[i].at(1, 0) * f.g[j].at(0, 1) - f.slope[i].at(0, 1) * f.g[j].at(1, 0);
  };
  return product(0, 1) - product(1, 0);
}

bool may_be_singular(const Functions& over, const Functions& center, const SliceCenter& middle) {
  const Jet<1> d = bracket(over.g[0], over.g[1]);
  if (d.value().positive() || d.value().negative()) return false;
  const Interval at = bracket(center.g[0], center.g[1]).value();
  const Interval linear = at + d.at(1, 0) * middle.offset(0) + d.at(0, 1) * middle.offset(1) +
                          determinant_slope(over) * middle.offset(2);
  return may_vanish(linear);
}

/// The first across the image of J, the second along it: the longer one of its columns by a and phi. In one
/// slice the third is that of g_2, else it lies in the image, too.
std::array<Direction, 3> frame_of(const Functions& center, std::size_t dimension) {
  const auto column = [&](std::size_t i, std::size_t k) {
    return Direction{middle_of(center.g[0].at(i, k)), middle_of(center.g[1].at(i, k)), 0.0};
  };
  const Direction a = column(1, 0), b = column(0, 1);
  Direction along = normalized(std::hypot(a[0], a[1]) > std::hypot(b[0], b[1]) ? a : b);
  if (along == Direction{}) along = {0.0, 1.0, 0.0};
  Direction other{0.0, 0.0, 1.0};
  if (dimension == 3)
    other = {middle_of(center.slope[0].value()), middle_of(center.slope[1].value()),
             middle_of(center.held_slope)};
  const Direction normal = normalized(cross(other, along));
  return {normal, along, cross(normal, along)};
}

/// By Taylor's theorem of second order.
Interval extent(const Direction& n, const Functions& over, const Functions& center,
                const SliceCenter& middle) {
  const Interval n0(n[0]), n1(n[1]), n2(n[2]);
  const auto combined = [&](const auto& g, std::size_t i, std::size_t k) {
    return n0 * g[0].at(i, k) + n1 * g[1].at(i, k);
  };
  const Interval x = middle.offset(0), y = middle.offset(1), z = middle.offset(2), two(2.0);
  const Interval bend = combined(over.g, 2, 0) * square(x) + combined(over.g, 0, 2) * square(y) +
                        two * (combined(over.g, 1, 1) * (x * y)) +
                        two * (combined(over.slope, 1, 0) * x + combined(over.slope, 0, 1) * y) * z +
                        (n0 + n1 + n2) * square(z);
  return combined(center.g, 0, 0) + n2 * center.held + combined(center.g, 1, 0) * x +
         combined(center.g, 0, 1) * y + (combined(center.slope, 0, 0) + n2 * center.held_slope) * z +
         Interval(0.5) * bend;
}

ImageStrip strip_of(const Functions& over, const Functions& center, const SliceCenter& middle,
                    std::size_t dimension) {
  ImageStrip strip;
  strip.frame = frame_of(center, dimension);
  for (std::size_t k = 0; k < dimension; ++k) strip.extents[k] = extent(strip.frame[k], over, center, middle);
  for (std::size_t i = 0; i < 2; ++i) {
    Direction axis{};
    axis[i] = 1.0;
    strip.range[i] = intersection(over.g[i].value(), extent(axis, over, center, middle));
  }
  strip.range[2] = over.held;
  return strip;
}

/// Within limits, and no longer than the slice reaches.
ValueSpace space_of(const StrutSlice& slice) {
  ValueSpace space{{slice.dimension(), {}, {}}, {}, {}, true};
  Box& box = space.values;
  for (std::size_t i = 0; i < box.dimension; ++i) {
    const auto& [least, most] = slice.limits(i);
    const double largest = std::min(most.upper(), slice.largest_half_square(i));
    box.lower[i] = square_root(Interval(2.0) * least).lower();
    box.upper[i] = std::max(box.lower[i], square_root(Interval(2.0) * Interval(largest)).upper());
  }
  return space;
}

}  // namespace

StrutImages::StrutImages(const StrutSlice& slice)
    : SingularImages(space_of(slice), smallest_singular_box), slice_(slice) {
  add_surface(slice_.whole(), 0);
}

std::optional<ImageStrip> StrutImages::strip_of(const Box& box, Surface /*parallel*/) const {
  const SliceCenter middle(box);
  const StrutSlice slices = slice_.over(box);
  const Functions over(slice_, slices, SliceTurns(ranges_of(box)));
  const Functions center(slice_, slice_.dimension() == 2 ? slices : slice_.with_rod(middle.rod),
                         SliceTurns(middle.at));
  if (!may_be_singular(over, center, middle)) return std::nullopt;
  return parallel_aspects::strip_of(over, center, middle, slice_.dimension());
}

}  // namespace parallel_aspects
