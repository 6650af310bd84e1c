// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/actuated_plane.h"

#include "aspects/uniqueness/plane_slab.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace parallel_aspects {
namespace {

// The division ends at so many cells.
constexpr std::size_t most_cells = 200000;

// Images are divided until they are no longer than a cell is wide.
constexpr double longest_strip = 1.0;

constexpr double smallest_cell_share = 0x1p-20;  // of the plane

double longest_side(const ValueBox& values) {
  return std::max(values[0].upper() - values[0].lower(), values[1].upper() - values[1].lower());
}

/// Within limits, and no longer than the slice reaches.
Box plane_of(const StrutSlice& slice) {
  Box box{2, {}, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [least, most] = slice.limits(i);
    const double largest = std::min(most.upper(), slice.largest_half_square(i));
    box.lower[i] = square_root(Interval(2.0) * least).lower();
    box.upper[i] = std::max(box.lower[i], square_root(Interval(2.0) * Interval(largest)).upper());
  }
  return box;
}

std::array<Box, 4> quarters_of(const Box& box) {
  std::array<Box, 4> quarters{box, box, box, box};
  for (std::size_t rank = 0; rank < 4; ++rank)
    for (std::size_t i = 0; i < 2; ++i)
      ((rank >> i & 1U) != 0 ? quarters[rank].lower : quarters[rank].upper)[i] = box.center(i);
  return quarters;
}

}  // namespace

ValueBox half_squares(const Box& lengths) noexcept {
  ValueBox values;
  for (std::size_t i = 0; i < 2; ++i)
    values[i] = Interval(0.5) * square(Interval(lengths.lower[i], lengths.upper[i]));
  return values;
}

ActuatedPlane::ActuatedPlane(const StrutSlice& slice, SingularImages& images, double unknown_share,
                             const MapControl& control)
    : slice_(slice), images_(images) {
  assert_rounding_upward();
  cells_.emplace_back();
  cells_.back().box = plane_of(slice);
  classify(0, {SingularImages::root});
  divide(unknown_share, control);
  make_pieces();
  join_inside(0);
}

// The cells with the most unknown first.
void ActuatedPlane::divide(double unknown_share, const MapControl& control) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry> queue;
  queue.emplace(cells_[0].unknown, 0);
  unknown_ = cells_[0].unknown;
  const double enough = unknown_share * cells_[0].box.measure();
  const double smallest = smallest_cell_share * cells_[0].box.width(0);
  while (!queue.empty() && unknown_ > enough && cells_.size() < most_cells && !is_cancelled(control)) {
    const auto [unknown, cell] = queue.top();
    queue.pop();
    if (!(cells_[cell].box.width(0) > smallest)) continue;
    const auto first = static_cast<std::uint32_t>(cells_.size());
    const std::vector<Node> touching = std::move(cells_[cell].touching);
    for (const Box& quarter : quarters_of(cells_[cell].box)) {
      cells_.emplace_back();
      cells_.back().box = quarter;
    }
    cells_[cell].first_child = first;
    unknown_ -= unknown;
    for (std::uint32_t child = first; child < first + 4; ++child) {
      classify(child, touching);
      unknown_ += cells_[child].unknown;
      if (cells_[child].unknown > 0.0) queue.emplace(cells_[child].unknown, child);
    }
  }
}

void ActuatedPlane::classify(std::uint32_t index, const std::vector<Node>& candidates) {
  PlaneCell& cell = cells_[index];
  std::vector<Node> touching;
  for (const Node node : candidates) collect(cell, node, touching);
  cell.touching = std::move(touching);
  if (cell.touching.empty()) return;
  find_slab(cell);
  cell.unknown = unknown_area(cell.box, cell.slope, cell.slab);
}

void ActuatedPlane::collect(const PlaneCell& cell, Node node, std::vector<Node>& touching) {
  const ValueBox values = half_squares(cell.box);
  const ImageStrip& strip = images_.strip(node);
  if (!strip.may_meet(values)) return;
  const bool is_short = longest_side(strip.range) <= longest_strip * longest_side(values);
  if (is_short || images_.is_smallest(node)) return touching.push_back(node);
  const std::vector<Node> parts = images_.parts(node);
  for (const Node part : parts) collect(cell, part, touching);
}

void ActuatedPlane::find_slab(PlaneCell& cell) const {
  std::array<double, 2> normal{};
  for (const Node node : cell.touching) {
    const auto& n = images_.strip(node).normal;
    const double sign = n[0] * normal[0] + n[1] * normal[1] < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i < 2; ++i) normal[i] += sign * n[i];
  }
  double lower = HUGE_VAL, upper = -HUGE_VAL;
  for (const Node node : cell.touching) {
    const Interval along = images_.strip(node).along(normal);
    lower = std::min(lower, along.lower());
    upper = std::max(upper, along.upper());
  }
  const LinearOverCell linear(cell.box, normal);
  cell.slope = linear.slope;
  cell.slab = Interval(lower, upper) - linear.rest;
}

void ActuatedPlane::make_pieces() {
  for (std::uint32_t index = 0; index < cells_.size(); ++index) {
    PlaneCell& cell = cells_[index];
    if (cell.first_child != 0) continue;
    const auto add = [&](int side, double area) {
      cell.pieces[static_cast<std::size_t>(side + 1)] = sets_.add();
      pieces_.push_back({index, side, area});
    };
    if (cell.touching.empty()) {
      add(0, area_of(cell.box).lower());
      continue;
    }
    for (const int side : {-1, 1}) {
      const double area = area_beside(cell.box, cell.slope, cell.slab, side).lower();
      if (area > 0.0) add(side, area);
    }
  }
}

void ActuatedPlane::join_inside(std::uint32_t cell) {
  const std::uint32_t first = cells_[cell].first_child;
  if (first == 0) return;
  for (std::uint32_t rank = 0; rank < 4; ++rank) join_inside(first + rank);
  for (const std::uint32_t rank : {0U, 2U}) join_across(0, first + rank, first + rank + 1);
  for (const std::uint32_t rank : {0U, 1U}) join_across(1, first + rank, first + rank + 2);
}

// Of neighbours along the axis, a at the smaller lengths.
void ActuatedPlane::join_across(std::size_t axis, std::uint32_t a, std::uint32_t b) {
  const std::uint32_t a_first = cells_[a].first_child, b_first = cells_[b].first_child;
  const std::uint32_t along = axis == 0 ? 1 : 2, beside = axis == 0 ? 2 : 1;
  if (a_first != 0 || b_first != 0) {
    for (const std::uint32_t rank : {0U, beside})
      join_across(axis, a_first != 0 ? a_first + along + rank : a, b_first != 0 ? b_first + rank : b);
    return;
  }
  const Box &one = cells_[a].box, &other = cells_[b].box;
  const std::size_t across = 1 - axis;
  Point at{};
  at[axis] = one.upper[axis];
  for (const double end :
       {std::max(one.lower[across], other.lower[across]), std::min(one.upper[across], other.upper[across])}) {
    at[across] = end;
    join_at(a, b, at);
  }
}

// Both are closed up to their slabs, and convex.
void ActuatedPlane::join_at(std::uint32_t a, std::uint32_t b, const Point& at) {
  const auto one = piece_at(cells_[a], at), other = piece_at(cells_[b], at);
  if (!one || !other) return;
  sets_.unite(*one, *other);
  const bool known = !links_.empty() && links_.back().first == *one && links_.back().second == *other;
  if (!known) links_.push_back({*one, *other, at});
}

std::optional<PieceIndex> ActuatedPlane::piece_at(const PlaneCell& cell, const Point& at) const {
  if (cell.touching.empty()) return cell.pieces[1];
  const Interval value = linear_at(cell.box, cell.slope, at);
  if (value.upper() < cell.slab.lower()) return cell.pieces[0];
  if (value.lower() > cell.slab.upper()) return cell.pieces[2];
  return std::nullopt;
}

std::optional<PieceIndex> ActuatedPlane::find(const Point& lengths) const {
  const MapPoint at{lengths[0], lengths[1], 0.0};
  std::uint32_t cell = 0;
  if (!cells_[cell].box.contains(at)) return std::nullopt;
  while (cells_[cell].first_child != 0) cell = cells_[cell].first_child + cells_[cell].box.rank_of(at);
  return piece_at(cells_[cell], lengths);
}

std::array<double, 2> ActuatedPlane::point_of(PieceIndex index) const {
  const Piece& piece = pieces_[index];
  const PlaneCell& cell = cells_[piece.cell];
  if (piece.side == 0) return {cell.box.center(0), cell.box.center(1)};
  return point_beside(cell.box, cell.slope, cell.slab, piece.side);
}

}  // namespace parallel_aspects
