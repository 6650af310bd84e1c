// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/actuated_space.h"

#include "aspects/solutions/cell_slab.h"
#include "aspects/tree/pose_tree.h"
#include "interval/scalar_range.h"
#include "model/angles.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <random>
#include <utility>

namespace parallel_aspects {
namespace {

// Images are divided until they are no longer than a cell is wide.
constexpr double longest_strip = 1.0;

constexpr std::size_t cells_between_reports = 1024;

constexpr double smallest_cell_share = 0x1p-20;  // of the whole

// A strip and a cell that together are narrower meet in one turn at most: the middles of both are half a turn
// apart in the others.
constexpr double widest_in_one_turn = full_turn * (1.0 - 1e-9);

double longest_side(const ValueBox& values) {
  double longest = 0.0;
  for (const Interval& each : values) longest = std::max(longest, each.upper() - each.lower());
  return longest;
}

/// Whether the strip is no longer than the cell: of values, along each axis, since some may be lengths and
/// others angles.
bool is_short(const ImageStrip& strip, const ValueBox& cell, const ValueSpace& space) {
  if (space.of_half_squares) return longest_side(strip.range) <= longest_strip * longest_side(cell);
  for (std::size_t i = 0; i < space.values.dimension; ++i)
    if (!(strip.range[i].upper() - strip.range[i].lower() <=
          longest_strip * (cell[i].upper() - cell[i].lower())))
      return false;
  return true;
}

/// n . values in the middle of the cell.
Interval at_middle(const Box& cell, const std::array<double, 3>& n) noexcept {
  Interval sum;
  for (std::size_t i = 0; i < cell.dimension; ++i) sum += Interval(n[i]) * Interval(cell.center(i));
  return sum;
}

/// What counts as one along each axis: of values the edges of the cell, since some may be lengths and others
/// angles.
std::array<double, 3> sides_of(const Box& cell, const ValueSpace& space) noexcept {
  std::array<double, 3> sides{1.0, 1.0, 1.0};
  for (std::size_t i = 0; i < cell.dimension && !space.of_half_squares; ++i) sides[i] = cell.width(i);
  return sides;
}

/// Of normals that point either way.
std::array<double, 3> mean_normal(const std::vector<ImageStrip>& strips, const std::array<double, 3>& sides) {
  std::array<double, 3> sum{};
  for (const ImageStrip& strip : strips) {
    const auto& normal = strip.normal();
    const auto n = normalized({normal[0] * sides[0], normal[1] * sides[1], normal[2] * sides[2]});
    const double along = n[0] * sum[0] + n[1] * sum[1] + n[2] * sum[2];
    for (std::size_t i = 0; i < 3; ++i) sum[i] += along < 0.0 ? -n[i] : n[i];
  }
  return {sum[0] / sides[0], sum[1] / sides[1], sum[2] / sides[2]};
}

void leave_unknown(SpaceCell& cell) noexcept {
  cell.slope = {};
  cell.slab = {-1.0, 1.0};
}

bool may_hold(const Box& box, const LengthRanges& lengths) noexcept {
  for (std::size_t i = 0; i < 3; ++i)
    if (lengths[i].upper() < box.lower[i] || box.upper[i] < lengths[i].lower()) return false;
  return true;
}

}  // namespace

bool holds_all(const Box& box, const LengthRanges& lengths) noexcept {
  for (std::size_t i = 0; i < 3; ++i)
    if (!(box.lower[i] <= lengths[i].lower() && lengths[i].upper() <= box.upper[i])) return false;
  return true;
}

ValueBox half_squares(const Box& lengths) noexcept {
  ValueBox values;
  for (std::size_t i = 0; i < lengths.dimension; ++i)
    values[i] = Interval(0.5) * square(Interval(lengths.lower[i], lengths.upper[i]));
  return values;
}

ActuatedSpace::ActuatedSpace(SingularImages& images, double unknown_share, const MapControl& control,
                             std::size_t most_cells)
    : space_(images.space()), images_(images) {
  assert_rounding_upward();
  cells_.emplace_back();
  cells_.back().box = space_.values;
  classify(0, {SingularImages::root});
  divide(unknown_share, most_cells, control);
  make_pieces();
  for (SpaceCell& cell : cells_) std::vector<Node>().swap(cell.touching);
  images_.clear();
  join_inside(0);
  for (std::size_t axis = 0; axis < dimension(); ++axis)
    if (space_.are_periodic[axis]) join_across(axis, 0, 0);
}

ValueBox ActuatedSpace::values_over(const SpaceCell& cell) const noexcept {
  if (space_.of_half_squares) return half_squares(cell.box);
  ValueBox values;
  for (std::size_t i = 0; i < dimension(); ++i) values[i] = {cell.box.lower[i], cell.box.upper[i]};
  return values;
}

/// The strip in the turn where it is nearest to the cell; an angle that may meet the cell in two turns counts
/// as all angles. Nothing where the cell is too large for that.
std::optional<ImageStrip> ActuatedSpace::strip_beside(const ValueBox& cell, Node node) const {
  const ImageStrip& strip = images_.strip(node);
  ValueBox turns;
  std::array<bool, 3> takes_all{};
  bool moves = false;
  for (std::size_t i = 0; i < dimension(); ++i) {
    if (!space_.are_angles[i]) continue;
    const double width = strip.range[i].upper() - strip.range[i].lower();
    const double cell_width = cell[i].upper() - cell[i].lower();
    if (!(cell_width < widest_in_one_turn)) return std::nullopt;
    takes_all[i] = !(width + cell_width < widest_in_one_turn);
    moves = moves || takes_all[i];
    if (takes_all[i]) continue;
    const double turn = std::round((middle_of(cell[i]) - middle_of(strip.range[i])) / full_turn);
    turns[i] = Interval(2.0 * turn) * pi_enclosure();
    moves = moves || turn != 0.0;
  }
  if (!moves) return strip;
  ImageStrip result = strip.moved(turns);
  for (std::size_t i = 0; i < 3; ++i)
    if (takes_all[i]) result.take_all(i);
  return result;
}

// The cells with the most unknown first.
void ActuatedSpace::divide(double unknown_share, std::size_t most_cells, const MapControl& control) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry> queue;
  queue.emplace(cells_[0].unknown, 0);
  unknown_ = cells_[0].unknown;
  const double enough = unknown_share * cells_[0].box.measure();
  const double smallest = smallest_cell_share * cells_[0].box.width(0);
  while (!queue.empty() && unknown_ > enough && cells_.size() < most_cells && !is_cancelled(control)) {
    const auto [unknown, cell] = queue.top();
    queue.pop();
    if (control.progress && cells_.size() % cells_between_reports == 1)
      control.progress(
          std::max(enough / unknown_, static_cast<double>(cells_.size()) / static_cast<double>(most_cells)));
    if (!(cells_[cell].box.width(0) > smallest)) continue;
    const auto first = static_cast<std::uint32_t>(cells_.size());
    const std::vector<Node> touching = std::move(cells_[cell].touching);
    const std::uint32_t parts = 1U << dimension();
    for (std::uint32_t rank = 0; rank < parts; ++rank) {
      const Box part = part_of(cells_[cell].box, rank);
      cells_.emplace_back();
      cells_.back().box = part;
    }
    cells_[cell].first_child = first;
    unknown_ -= unknown;
    for (std::uint32_t child = first; child < first + parts; ++child) {
      classify(child, touching);
      unknown_ += cells_[child].unknown;
      if (cells_[child].unknown > 0.0) queue.emplace(cells_[child].unknown, child);
    }
  }
}

void ActuatedSpace::classify(std::uint32_t index, const std::vector<Node>& candidates) {
  SpaceCell& cell = cells_[index];
  std::vector<Node> touching;
  for (const Node node : candidates) collect(cell, node, touching);
  cell.touching = std::move(touching);
  if (cell.touching.empty()) return;
  find_slab(cell);
  cell.unknown = unknown_measure(cell.box, cell.slope, cell.slab);
}

void ActuatedSpace::collect(const SpaceCell& cell, Node node, std::vector<Node>& touching) {
  const ValueBox values = values_over(cell);
  const auto strip = strip_beside(values, node);
  if (strip && !strip->may_meet(values)) return;
  if (is_short(images_.strip(node), values, space_) || images_.is_smallest(node))
    return touching.push_back(node);
  const SingularImages::Parts parts = images_.parts(node);
  for (Node k = 0; k < parts.count; ++k) collect(cell, parts[k], touching);
}

void ActuatedSpace::find_slab(SpaceCell& cell) const {
  const ValueBox values = values_over(cell);
  std::vector<ImageStrip> strips;
  for (const Node node : cell.touching) {
    const auto strip = strip_beside(values, node);
    if (!strip) return leave_unknown(cell);
    strips.push_back(*strip);
  }
  const std::array<double, 3> normal = mean_normal(strips, sides_of(cell.box, space_));
  double lower = HUGE_VAL, upper = -HUGE_VAL;
  for (const ImageStrip& strip : strips) {
    const Interval along = strip.along(normal);
    lower = std::min(lower, along.lower());
    upper = std::max(upper, along.upper());
  }
  if (space_.of_half_squares) {
    const LinearOverCell linear(cell.box, normal);
    cell.slope = linear.slope;
    cell.slab = Interval(lower, upper) - linear.rest;
    return;
  }
  cell.slope = normal;
  cell.slab = Interval(lower, upper) - at_middle(cell.box, normal);
}

void ActuatedSpace::make_pieces() {
  for (std::uint32_t index = 0; index < cells_.size(); ++index) {
    SpaceCell& cell = cells_[index];
    if (cell.first_child != 0) continue;
    const auto add = [&](int side, double measure) {
      cell.pieces[static_cast<std::size_t>(side + 1)] = sets_.add();
      pieces_.push_back({index, side, measure});
    };
    if (cell.touching.empty()) {
      add(0, measure_of(cell.box).lower());
      continue;
    }
    for (const int side : {-1, 1}) {
      const double measure = measure_beside(cell.box, cell.slope, cell.slab, side).lower();
      if (measure > 0.0) add(side, measure);
    }
  }
}

void ActuatedSpace::join_inside(std::uint32_t cell) {
  const std::uint32_t first = cells_[cell].first_child, parts = 1U << dimension();
  if (first == 0) return;
  for (std::uint32_t rank = 0; rank < parts; ++rank) join_inside(first + rank);
  for (std::size_t axis = 0; axis < dimension(); ++axis)
    for (std::uint32_t rank = 0; rank < parts; ++rank)
      if ((rank >> axis & 1U) == 0) join_across(axis, first + rank, first + rank + (1U << axis));
}

// Of neighbours along the axis, a at the smaller lengths.
void ActuatedSpace::join_across(std::size_t axis, std::uint32_t a, std::uint32_t b) {
  const std::uint32_t a_first = cells_[a].first_child, b_first = cells_[b].first_child;
  if (a_first == 0 && b_first == 0) return join_leaves(axis, a, b);
  const std::uint32_t along = 1U << axis, parts = 1U << dimension();
  for (std::uint32_t rank = 0; rank < parts; ++rank)
    if ((rank & along) == 0)
      join_across(axis, a_first != 0 ? a_first + rank + along : a, b_first != 0 ? b_first + rank : b);
}

// At the corners of the face that they share, or of both faces, a turn apart.
void ActuatedSpace::join_leaves(std::size_t axis, std::uint32_t a, std::uint32_t b) {
  const Box &one = cells_[a].box, &other = cells_[b].box;
  const std::uint32_t corners = 1U << dimension();
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    if ((corner >> axis & 1U) != 0) continue;
    ActuatedValues at{};
    for (std::size_t i = 0; i < dimension(); ++i)
      at[i] = (corner >> i & 1U) != 0 ? std::min(one.upper[i], other.upper[i])
                                      : std::max(one.lower[i], other.lower[i]);
    std::array<ActuatedValues, 2> common{at, at};
    common[0][axis] = one.upper[axis];
    common[1][axis] = other.lower[axis];
    join_at(a, b, common);
  }
}

// Both are closed up to their slabs, and convex.
void ActuatedSpace::join_at(std::uint32_t a, std::uint32_t b, const std::array<ActuatedValues, 2>& at) {
  const double slack = at[0] == at[1] ? 0.0 : turn_slack;
  const auto one = piece_at(cells_[a], at[0], slack), other = piece_at(cells_[b], at[1], slack);
  if (!one || !other) return;
  sets_.unite(*one, *other);
  const std::array<PieceIndex, 2> pieces{*one, *other};
  if (links_.empty() || links_.back().pieces != pieces) links_.push_back({pieces, at});
}

// With all values that are off by so much.
std::optional<PieceIndex> ActuatedSpace::piece_at(const SpaceCell& cell, const ActuatedValues& at,
                                                  double slack) const {
  if (cell.pieces[1]) return cell.pieces[1];
  Interval value = linear_at(cell.box, cell.slope, at);
  for (const double slope : cell.slope) value += Interval(-slack, slack) * Interval(slope);
  if (value.upper() < cell.slab.lower()) return cell.pieces[0];
  if (value.lower() > cell.slab.upper()) return cell.pieces[2];
  return std::nullopt;
}

std::optional<PieceIndex> ActuatedSpace::find(const ActuatedValues& values) const {
  std::uint32_t cell = 0;
  if (!cells_[cell].box.contains(values)) return std::nullopt;
  while (cells_[cell].first_child != 0) cell = cells_[cell].first_child + cells_[cell].box.rank_of(values);
  return piece_at(cells_[cell], values);
}

std::vector<ActuatedValues> ActuatedSpace::draw_unknown(std::size_t count, std::uint64_t seed) const {
  std::vector<double> up_to;
  std::vector<const SpaceCell*> cells;
  for (const SpaceCell& cell : cells_) {
    if (cell.first_child != 0 || !(cell.unknown > 0.0)) continue;
    up_to.push_back((up_to.empty() ? 0.0 : up_to.back()) + cell.box.measure());
    cells.push_back(&cell);
  }
  std::vector<ActuatedValues> result;
  if (cells.empty()) return result;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (std::size_t tries = 0; result.size() < count && tries < 100 * count; ++tries) {
    const auto at = std::upper_bound(up_to.begin(), up_to.end() - 1, share(random) * up_to.back());
    const SpaceCell& cell = *cells[static_cast<std::size_t>(at - up_to.begin())];
    ActuatedValues values{};
    for (std::size_t i = 0; i < dimension(); ++i)
      values[i] = cell.box.lower[i] + share(random) * cell.box.width(i);
    if (!piece_at(cell, values)) result.push_back(values);
  }
  return result;
}

ActuatedValues ActuatedSpace::point_of(PieceIndex index) const {
  const Piece& piece = pieces_[index];
  const SpaceCell& cell = cells_[piece.cell];
  if (piece.side == 0) return cell.box.middle();
  return point_beside(cell.box, cell.slope, cell.slab, piece.side);
}

LengthCover ActuatedSpace::cover(const LengthRanges& lengths) const {
  LengthCover result;
  result.is_complete = holds_all(cells_.front().box, lengths);
  std::vector<std::uint32_t> left{0};
  std::size_t leaves = 0;
  while (!left.empty()) {
    const std::uint32_t index = left.back();
    left.pop_back();
    const SpaceCell& cell = cells_[index];
    if (!may_hold(cell.box, lengths)) continue;
    if (cell.first_child != 0) {
      for (std::uint32_t k = 0; k < (1U << cell.box.dimension); ++k) left.push_back(cell.first_child + k);
      continue;
    }
    result.cell = ++leaves == 1 ? std::optional<std::uint32_t>(index) : std::nullopt;
    add_to_cover(cell, lengths, result);
    if (result.pieces.size() > 2 || leaves > 64) {
      result.is_complete = false;
      break;
    }
  }
  return result;
}

// What of the cell is within these lengths.
void ActuatedSpace::add_to_cover(const SpaceCell& cell, const LengthRanges& lengths, LengthCover& cover) {
  std::optional<PieceIndex> piece = cell.pieces[1];
  if (!piece) {
    Interval value;
    for (std::size_t i = 0; i < cell.box.dimension; ++i)
      value += Interval(cell.slope[i]) * (lengths[i] - Interval(cell.box.center(i)));
    if (value.upper() < cell.slab.lower()) piece = cell.pieces[0];
    if (value.lower() > cell.slab.upper()) piece = cell.pieces[2];
  }
  if (piece)
    cover.pieces.push_back(*piece);
  else
    cover.is_complete = false;
}

}  // namespace parallel_aspects
