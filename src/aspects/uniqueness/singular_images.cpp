// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/singular_images.h"

#include "interval/scalar_range.h"
#include "legs/rod_on_arc.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double smallest_singular_box = 0x1p-26;  // [half turns]

using Direction = std::array<double, 2>;
using Pair = std::array<Jet<2>, 2>;

Pair pair_over(const StrutSlice& slice, const SliceTurns& turns) {
  return {slice.half_square<2>(0, turns), slice.half_square<2>(1, turns)};
}

bool may_be_singular(const Pair& over, const Pair& center, const SliceCenter& middle) {
  const Jet<1> d = bracket(over[0], over[1]);
  if (d.value().positive() || d.value().negative()) return false;
  const Interval at = bracket(center[0], center[1]).value();
  const Interval linear = at + d.at(1, 0) * middle.offset(0) + d.at(0, 1) * middle.offset(1);
  return !linear.positive() && !linear.negative();
}

/// Across the image of J: the longer one of both columns, turned by a right angle.
Direction normal_of(const Pair& center) {
  const auto column = [&](std::size_t i, std::size_t k) {
    return Direction{middle_of(center[0].at(i, k)), middle_of(center[1].at(i, k))};
  };
  const Direction a = column(1, 0), b = column(0, 1);
  const Direction& longer = std::hypot(a[0], a[1]) > std::hypot(b[0], b[1]) ? a : b;
  const double norm = std::hypot(longer[0], longer[1]);
  if (!(norm > 0.0) || !std::isfinite(norm)) return {1.0, 0.0};
  return {-longer[1] / norm, longer[0] / norm};
}

/// By Taylor's theorem of second order.
Interval extent(const Direction& n, const Pair& over, const Pair& center, const SliceCenter& middle) {
  const Interval n0(n[0]), n1(n[1]);
  const auto combined = [&](const Pair& g, std::size_t i, std::size_t k) {
    return n0 * g[0].at(i, k) + n1 * g[1].at(i, k);
  };
  const Interval x = middle.offset(0), y = middle.offset(1);
  const Interval bend = combined(over, 2, 0) * square(x) + combined(over, 0, 2) * square(y) +
                        Interval(2.0) * (combined(over, 1, 1) * (x * y));
  return combined(center, 0, 0) + combined(center, 1, 0) * x + combined(center, 0, 1) * y +
         Interval(0.5) * bend;
}

ImageStrip strip_of(const Pair& over, const Pair& center, const SliceCenter& middle) {
  ImageStrip strip;
  strip.normal = normal_of(center);
  strip.along_normal = extent(strip.normal, over, center, middle);
  strip.along_tangent = extent({-strip.normal[1], strip.normal[0]}, over, center, middle);
  strip.range = {intersection(over[0].value(), extent({1.0, 0.0}, over, center, middle)),
                 intersection(over[1].value(), extent({0.0, 1.0}, over, center, middle))};
  return strip;
}

}  // namespace

// With t the normal n turned, d |n|^2 = (d.n) n + (d.t) t.
Interval ImageStrip::along(const std::array<double, 2>& direction) const noexcept {
  const Interval d0(direction[0]), d1(direction[1]), n0(normal[0]), n1(normal[1]);
  const Interval by_strip = ((d0 * n0 + d1 * n1) * along_normal + (d1 * n0 - d0 * n1) * along_tangent) *
                            reciprocal(square(n0) + square(n1));
  return intersection(by_strip, d0 * range[0] + d1 * range[1]);
}

bool ImageStrip::may_meet(const ValueBox& values) const noexcept {
  if (are_apart(range[0], values[0]) || are_apart(range[1], values[1])) return false;
  const Interval n0(normal[0]), n1(normal[1]);
  return !are_apart(along_normal, n0 * values[0] + n1 * values[1]) &&
         !are_apart(along_tangent, n0 * values[1] - n1 * values[0]);
}

SingularImages::SingularImages(const StrutSlice& slice) : slice_(slice) {
  assert_rounding_upward();
  std::vector<Node> whole;
  add(whole_slice(), whole);
  if (whole.empty()) nodes_.push_back({});
}

bool SingularImages::is_smallest(Node node) const noexcept {
  return !(std::max(box(node).width(0), box(node).width(1)) > smallest_singular_box);
}

const std::vector<SingularImages::Node>& SingularImages::parts(Node node) {
  if (!nodes_[node].divided) {
    std::vector<Node> parts;
    for (const Box& half : halves_of(Box(box(node))))
      for (const Box& quarter : halves_of(half)) add(quarter, parts);
    nodes_[node].parts = std::move(parts);
    nodes_[node].divided = true;
  }
  return nodes_[node].parts;
}

void SingularImages::add(const Box& box, std::vector<Node>& parts) {
  const SliceCenter middle(box);
  const Pair over = pair_over(slice_, SliceTurns(ranges_of(box)));
  const Pair center = pair_over(slice_, SliceTurns(middle.at));
  if (!may_be_singular(over, center, middle)) return;
  parts.push_back(static_cast<Node>(nodes_.size()));
  nodes_.push_back({box, strip_of(over, center, middle), false, {}});
}

}  // namespace parallel_aspects
