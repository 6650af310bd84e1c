// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/value_grid.h"

#include "model/angles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

// Cells that a strip comes this near to are marked, too: places in the grid are rounded by far less [cells].
constexpr double slack = 1e-6;

}  // namespace

ValueGrid::ValueGrid(const JointRanges& ranges, std::size_t cells_an_axis)
    : ranges_(ranges), cells_(cells_an_axis), set_(cells_an_axis * cells_an_axis, in_no_set) {
  for (std::size_t i = 0; i < 2; ++i) {
    lower_[i] = ranges.values().lower[i];
    steps_[i] = ranges.values().width(i) / static_cast<double>(cells_an_axis);
  }
}

std::array<std::ptrdiff_t, 2> ValueGrid::cells_meeting(std::size_t axis,
                                                       const Interval& values) const noexcept {
  const double least = std::floor((values.lower() - lower_[axis]) / steps_[axis] - slack);
  const double greatest = std::floor((values.upper() - lower_[axis]) / steps_[axis] + slack);
  const auto last = static_cast<double>(cells_ - 1);
  if (!(greatest >= 0.0 && least <= last)) return {0, -1};
  return {static_cast<std::ptrdiff_t>(std::max(0.0, least)),
          static_cast<std::ptrdiff_t>(std::min(last, greatest))};
}

bool ValueGrid::mark(const ValueStrip& strip) {
  ValueStrip each = strip;
  std::array<Interval, 2> values;
  std::array<int, 2> least{}, most{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Box& range = ranges_.values();
    values[i] = strip.values[i].value_or(Interval(range.lower[i], range.upper[i]));
    if (!strip.values[i]) each.normal = {};
    if (!strip.values[i] || !ranges_.are_angles()[i]) continue;
    least[i] = static_cast<int>(std::floor((range.lower[i] - values[i].upper()) / (2.0 * pi) - slack));
    most[i] = static_cast<int>(std::ceil((range.upper[i] - values[i].lower()) / (2.0 * pi) + slack));
  }
  for (int x = least[0]; x <= most[0]; ++x)
    for (int y = least[1]; y <= most[1]; ++y) mark_moved(values, each, {2.0 * pi * x, 2.0 * pi * y});
  return strip.values[0] || strip.values[1];
}

void ValueGrid::mark_moved(const std::array<Interval, 2>& values, const ValueStrip& strip,
                           const std::array<double, 2>& turns) {
  const auto columns = cells_meeting(0, values[0] + Interval(turns[0]));
  const auto rows = cells_meeting(1, values[1] + Interval(turns[1]));
  for (std::ptrdiff_t x = columns[0]; x <= columns[1]; ++x) mark_column(x, rows, strip, turns);
}

// Of a strip the rows with normal . (q - turns) in it.
void ValueGrid::mark_column(std::ptrdiff_t x, std::array<std::ptrdiff_t, 2> rows, const ValueStrip& strip,
                            const std::array<double, 2>& turns) {
  const double from = lower_[0] + steps_[0] * (static_cast<double>(x) - slack);
  const double to = lower_[0] + steps_[0] * (static_cast<double>(x) + 1.0 + slack);
  const Interval rest = strip.along - Interval(strip.normal[0]) * (Interval(from, to) - Interval(turns[0]));
  if (strip.normal[1] != 0.0) {
    const Interval at = rest * reciprocal(Interval(strip.normal[1])) + Interval(turns[1]);
    const auto crossed = cells_meeting(1, at);
    rows = {std::max(rows[0], crossed[0]), std::min(rows[1], crossed[1])};
  } else if (strip.normal[0] != 0.0 && (rest.positive() || rest.negative())) {
    return;
  }
  for (std::ptrdiff_t y = rows[0]; y <= rows[1]; ++y)
    set_[static_cast<std::size_t>(y) * cells_ + static_cast<std::size_t>(x)] = marked;
}

void ValueGrid::join(std::size_t least_cells) {
  for (Index cell = 0; cell < set_.size(); ++cell) {
    if (set_[cell] != in_no_set) continue;
    sets_.emplace_back();
    fill(cell, static_cast<Index>(sets_.size() - 1));
  }
  sort_sets(least_cells);
  find_insides();
  share_marked();
}

void ValueGrid::sort_sets(std::size_t least_cells) {
  std::vector<Index> order(sets_.size()), place(sets_.size(), in_no_set);
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [this](Index a, Index b) { return sets_[a].cells > sets_[b].cells; });
  std::vector<GridSet> kept;
  for (const Index set : order) {
    if (sets_[set].cells < least_cells) break;
    place[set] = static_cast<Index>(kept.size());
    kept.push_back(sets_[set]);
  }
  sets_ = std::move(kept);
  for (Index& set : set_)
    if (set < place.size()) set = place[set];
}

void ValueGrid::fill(Index start, Index set) {
  std::vector<Index> open{start};
  set_[start] = set;
  const auto enter = [&](Index cell) {
    if (set_[cell] != in_no_set) return;
    set_[cell] = set;
    open.push_back(cell);
  };
  while (!open.empty()) {
    const Index cell = open.back();
    open.pop_back();
    ++sets_[set].cells;
    for_neighbours(cell, enter);
  }
}

void ValueGrid::find_insides() {
  std::vector<std::size_t> longest(sets_.size(), 0);
  for (std::size_t y = 0; y < cells_; ++y)
    for (std::size_t x = 0, end = 0; x < cells_; x = end) {
      const Index set = set_[y * cells_ + x];
      for (end = x; end < cells_ && set_[y * cells_ + end] == set; ++end) {
      }
      if (set >= sets_.size() || end - x <= longest[set]) continue;
      longest[set] = end - x;
      sets_[set].cell = {static_cast<std::ptrdiff_t>((x + end) / 2), static_cast<std::ptrdiff_t>(y)};
      sets_[set].inside = values_at(sets_[set].cell);
    }
}

// Each goes to the sets that come to it first, in equal shares.
void ValueGrid::share_marked() {
  std::vector<Index> nearest = set_, reached;
  for (Index cell = 0; cell < set_.size(); ++cell) {
    if (set_[cell] >= sets_.size())
      ++in_none_;
    else
      reached.push_back(cell);
  }
  while (!reached.empty()) {
    std::map<Index, std::set<Index>> next;
    for (const Index cell : reached)
      for_neighbours(cell, [&](Index other) {
        if (nearest[other] >= sets_.size()) next[other].insert(nearest[cell]);
      });
    reached.clear();
    for (const auto& [cell, sets] : next) {
      for (const Index set : sets) sets_[set].cells_beside += 1.0 / static_cast<double>(sets.size());
      nearest[cell] = *sets.begin();
      reached.push_back(cell);
    }
  }
}

GridPlace ValueGrid::within(const GridPlace& place) const noexcept {
  GridPlace result = place;
  for (std::size_t i = 0; i < 2; ++i)
    if (is_periodic(i)) result[i] = (place[i] % cells_an_axis() + cells_an_axis()) % cells_an_axis();
  return result;
}

std::array<double, 2> ValueGrid::values_at(const GridPlace& place) const noexcept {
  return {lower_[0] + steps_[0] * (static_cast<double>(place[0]) + 0.5),
          lower_[1] + steps_[1] * (static_cast<double>(place[1]) + 0.5)};
}

std::optional<std::size_t> ValueGrid::set_at(const GridPlace& place) const noexcept {
  const Index set = set_[static_cast<std::size_t>(place[1]) * cells_ + static_cast<std::size_t>(place[0])];
  if (set >= sets_.size()) return std::nullopt;
  return set;
}

GridPlace ValueGrid::cell_of(const std::array<double, 2>& values) const noexcept {
  GridPlace at{};
  for (std::size_t i = 0; i < 2; ++i)
    at[i] = std::min(cells_an_axis() - 1, static_cast<std::ptrdiff_t>((values[i] - lower_[i]) / steps_[i]));
  return at;
}

std::optional<std::size_t> ValueGrid::set_of(const std::array<double, 2>& values) const noexcept {
  for (std::size_t i = 0; i < 2; ++i)
    if (!(ranges_.values().lower[i] <= values[i] && values[i] <= ranges_.values().upper[i]))
      return std::nullopt;
  return set_at(cell_of(values));
}

}  // namespace parallel_aspects
