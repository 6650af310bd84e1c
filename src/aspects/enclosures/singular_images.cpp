// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/enclosures/singular_images.h"

#include "aspects/cusps/cosine_sum.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

using Direction = std::array<double, 3>;

Interval dot(const Direction& n, const ValueBox& values) noexcept {
  return Interval(n[0]) * values[0] + Interval(n[1]) * values[1] + Interval(n[2]) * values[2];
}

}  // namespace

Direction normalized(const Direction& v) noexcept {
  const double norm = std::hypot(v[0], v[1], v[2]);
  if (!(norm > 0.0) || !std::isfinite(norm)) return {};
  return {v[0] / norm, v[1] / norm, v[2] / norm};
}

Direction cross(const Direction& a, const Direction& b) noexcept {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

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

void ImageStrip::take_all(std::size_t axis) noexcept {
  range[axis] = all_values;
  frame = {};
  extents = {};
}

ImageStrip ImageStrip::moved(const ValueBox& by) const noexcept {
  ImageStrip result = *this;
  for (std::size_t i = 0; i < 3; ++i) {
    result.range[i] += by[i];
    result.extents[i] += dot(frame[i], by);
  }
  return result;
}

SingularImages::SingularImages(ValueSpace space, double smallest) : space_(space), smallest_(smallest) {
  assert_rounding_upward();
  nodes_.push_back({whole_slice(), {{}, {all_values, all_values, all_values}, {}}, 0, true, {}});
}

void SingularImages::add_surface(const Box& whole, Surface surface) {
  add(whole, surface);
  nodes_[root].parts = {root + 1, static_cast<Node>(nodes_.size() - 1)};
}

bool SingularImages::is_smallest(Node node) const noexcept {
  return !(std::max(box(node).width(0), box(node).width(1)) > smallest_);
}

SingularImages::Parts SingularImages::parts(Node node) {
  if (!nodes_[node].divided) {
    const auto first = static_cast<Node>(nodes_.size());
    const Surface surface = nodes_[node].surface;
    for (const Box& half : halves_of(Box(box(node)), surface))
      add_halves(half, surface, space_.values.dimension - 1);
    nodes_[node].parts = {first, static_cast<Node>(nodes_.size()) - first};
    nodes_[node].divided = true;
  }
  return nodes_[node].parts;
}

/// Along its longest edge.
std::array<Box, 2> SingularImages::halves_of(const Box& box, Surface surface) const {
  const double third = box.dimension == 2 ? 0.0 : box.width(2) / half_turn(surface);
  if (!(third > std::max(box.width(0), box.width(1)))) return parallel_aspects::halves_of(box);
  std::array<Box, 2> halves{box, box};
  halves[0].upper[2] = halves[1].lower[2] = box.center(2);
  return halves;
}

/// Halved so often.
void SingularImages::add_halves(const Box& box, Surface surface, std::size_t times) {
  if (times == 0) return add(box, surface);
  for (const Box& half : halves_of(box, surface)) add_halves(half, surface, times - 1);
}

void SingularImages::add(const Box& box, Surface surface) {
  if (const auto strip = strip_of(box, surface)) nodes_.push_back({box, *strip, surface, false, {}});
}

}  // namespace parallel_aspects
