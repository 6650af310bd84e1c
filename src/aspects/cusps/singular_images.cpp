// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/singular_images.h"

#include "interval/scalar_range.h"
#include "legs/rod_on_arc.h"
#include "model/angles.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

Direction normalized(const Direction& v) {
  const double norm = std::hypot(v[0], v[1], v[2]);
  if (!(norm > 0.0) || !std::isfinite(norm)) return {};
  return {v[0] / norm, v[1] / norm, v[2] / norm};
}

Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
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

Interval dot(const Direction& n, const ValueBox& values) noexcept {
  return Interval(n[0]) * values[0] + Interval(n[1]) * values[1] + Interval(n[2]) * values[2];
}

}  // namespace

// By the part of it along each direction of the frame, and what these leave of it.
Interval ImageStrip::along(const std::array<double, 3>& direction) const noexcept {
  Interval by_strip;
  std::array<Interval, 3> rest{direction[0], direction[1], direction[2]};
  for (std::size_t k = 0; k < 3; ++k) {
    const Direction& f = frame[k];
    const Interval part(direction[0] * f[0] + direction[1] * f[1] + direction[2] * f[2]);
    by_strip += part * extents[k];
    for (std::size_t i = 0; i < 3; ++i) rest[i] = rest[i] - part * Interval(f[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) by_strip += rest[i] * range[i];
  return intersection(by_strip, dot(direction, range));
}

bool ImageStrip::may_meet(const ValueBox& values) const noexcept {
  for (std::size_t i = 0; i < 3; ++i)
    if (are_apart(range[i], values[i])) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (are_apart(extents[k], dot(frame[k], values))) return false;
  return true;
}

SingularImages::SingularImages(const StrutSlice& slice) : slice_(slice) {
  assert_rounding_upward();
  std::vector<Node> whole;
  add(slice_.whole(), whole);
  if (whole.empty()) nodes_.push_back({});
}

bool SingularImages::is_smallest(Node node) const noexcept {
  return !(std::max(box(node).width(0), box(node).width(1)) > smallest_singular_box);
}

const std::vector<SingularImages::Node>& SingularImages::parts(Node node) {
  if (!nodes_[node].divided) {
    std::vector<Node> parts;
    for (const Box& half : halves_of(Box(box(node)))) add_halves(half, slice_.dimension() - 1, parts);
    nodes_[node].parts = std::move(parts);
    nodes_[node].divided = true;
  }
  return nodes_[node].parts;
}

/// Halved so often.
void SingularImages::add_halves(const Box& box, std::size_t times, std::vector<Node>& parts) {
  if (times == 0) return add(box, parts);
  for (const Box& half : halves_of(box)) add_halves(half, times - 1, parts);
}

// Of a family the rod counts as far as its end moves for as long an arc.
std::array<Box, 2> SingularImages::halves_of(const Box& box) const {
  if (box.dimension == 2) return parallel_aspects::halves_of(box);
  const double rod = box.width(2) / (pi * slice_.rod().upper());
  if (!(rod > std::max(box.width(0), box.width(1)))) return parallel_aspects::halves_of(box);
  std::array<Box, 2> halves{box, box};
  halves[0].upper[2] = halves[1].lower[2] = box.center(2);
  return halves;
}

void SingularImages::add(const Box& box, std::vector<Node>& parts) {
  const SliceCenter middle(box);
  const StrutSlice slices = slice_.over(box);
  const Functions over(slice_, slices, SliceTurns(ranges_of(box)));
  const Functions center(slice_, slice_.dimension() == 2 ? slices : slice_.with_rod(middle.rod),
                         SliceTurns(middle.at));
  if (!may_be_singular(over, center, middle)) return;
  parts.push_back(static_cast<Node>(nodes_.size()));
  nodes_.push_back({box, strip_of(over, center, middle, slice_.dimension()), false, {}});
}

}  // namespace parallel_aspects
