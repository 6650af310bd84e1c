// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/grid_runs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

// Of an arrival: nothing came to the run, or it is the root.
constexpr std::size_t not_reached = ~std::size_t{0}, root = not_reached - 1;

// A line in a run keeps this distance from its ends [cells].
constexpr double run_slack = 1e-6;

GridPlace moved(const GridPlace& place, const GridPlace& by) { return {place[0] + by[0], place[1] + by[1]}; }

GridPlace from_to(const GridPlace& from, const GridPlace& to) { return {to[0] - from[0], to[1] - from[1]}; }

/// A corner of a path, with its run, both in the same turn.
struct Stop {
  GridPlace place{};
  GridRun run;

  Stop(const GridPlace& at, const GridRun& in, const GridPlace& turns) : place(moved(at, turns)), run(in) {
    run.row += turns[1];
    run.first += turns[0];
    run.end += turns[0];
  }
};

/// Whether the straight line between two stops lies in the runs of those between, which are in rows that
/// follow each other: so it can take the place of the path between them.
bool is_straight(const std::vector<Stop>& stops, std::size_t from, std::size_t to) {
  const GridPlace &a = stops[from].place, &b = stops[to].place;
  const std::ptrdiff_t sense = b[1] < a[1] ? -1 : 1;
  const auto rows = static_cast<double>(std::abs(b[1] - a[1]));
  const double slope = rows > 0.0 ? static_cast<double>(b[0] - a[0]) / rows : 0.0;
  for (std::size_t i = from; i <= to; ++i) {
    const GridRun& run = stops[i].run;
    if (i > from && run.row != stops[i - 1].run.row + sense &&
        (run.row != stops[i - 1].run.row || run.first != stops[i - 1].run.first))
      return false;
    const auto y = static_cast<double>(sense * (run.row - a[1]));
    const double x = static_cast<double>(a[0]) + 0.5;
    const double before = x + slope * std::max(0.0, y - 0.5), after = x + slope * std::min(rows, y + 0.5);
    if (!(std::min(before, after) > static_cast<double>(run.first) + run_slack &&
          std::max(before, after) < static_cast<double>(run.end) - run_slack))
      return false;
  }
  return true;
}

std::vector<GridPlace> straightened(const std::vector<Stop>& stops) {
  std::vector<GridPlace> result{stops.front().place};
  for (std::size_t at = 0; at + 1 < stops.size();) {
    std::size_t next = at + 1;
    for (std::size_t step = 2; next + 1 < stops.size(); step *= 2) {
      const std::size_t farther = std::min(at + step, stops.size() - 1);
      if (!is_straight(stops, at, farther)) break;
      next = farther;
    }
    result.push_back(stops[next].place);
    at = next;
  }
  return result;
}

}  // namespace

GridRuns::GridRuns(const ValueGrid& grid) : grid_(grid) {
  find_runs();
  const std::ptrdiff_t rows = grid_.cells_an_axis();
  for (std::ptrdiff_t row = 0; row < rows; ++row) {
    link_within(row);
    if (row + 1 < rows || grid_.is_periodic(1)) link_rows(row, row + 1);
  }
  links_of_.resize(runs_.size());
  for (std::size_t i = 0; i < links_.size(); ++i)
    for (const std::size_t run : {links_[i].from, links_[i].to}) links_of_[run].push_back(i);
  arrivals_.assign(runs_.size(), not_reached);
  for (std::size_t set = 0; set < grid_.sets().size(); ++set) grow_tree(set);
}

void GridRuns::find_runs() {
  const std::ptrdiff_t cells = grid_.cells_an_axis();
  for (std::ptrdiff_t row = 0; row < cells; ++row) {
    row_begins_.push_back(runs_.size());
    for (std::ptrdiff_t x = 0, end = 0; x < cells; x = end) {
      const auto set = grid_.set_at({x, row});
      for (end = x + 1; end < cells && grid_.set_at({end, row}) == set; ++end) {
      }
      if (set) add_run({*set, row, x, end});
    }
  }
  row_begins_.push_back(runs_.size());
}

// A row of an angle with all values is a circle; half of it is not.
void GridRuns::add_run(const GridRun& run) {
  const std::ptrdiff_t cells = grid_.cells_an_axis();
  if (run.end - run.first < cells || !grid_.is_periodic(0)) {
    runs_.push_back(run);
    return;
  }
  runs_.push_back({run.set, run.row, 0, cells / 2});
  runs_.push_back({run.set, run.row, cells / 2, cells});
}

void GridRuns::link_within(std::ptrdiff_t row) {
  const auto y = static_cast<std::size_t>(row);
  const std::size_t begin = row_begins_[y], end = row_begins_[y + 1];
  const std::ptrdiff_t cells = grid_.cells_an_axis();
  for (std::size_t i = begin; i + 1 < end; ++i)
    if (runs_[i].end == runs_[i + 1].first && runs_[i].set == runs_[i + 1].set)
      links_.push_back({i, i + 1, {runs_[i].end - 1, row}, {runs_[i].end, row}});
  if (end - begin < 2 || !grid_.is_periodic(0)) return;
  const GridRun &first = runs_[begin], &last = runs_[end - 1];
  if (first.first == 0 && last.end == cells && first.set == last.set)
    links_.push_back({end - 1, begin, {cells - 1, row}, {cells, row}});
}

// `above` as seen from the row.
void GridRuns::link_rows(std::ptrdiff_t row, std::ptrdiff_t above) {
  const auto y = static_cast<std::size_t>(row);
  const auto next = static_cast<std::size_t>(above % grid_.cells_an_axis());
  std::size_t a = row_begins_[y], b = row_begins_[next];
  while (a < row_begins_[y + 1] && b < row_begins_[next + 1]) {
    const std::ptrdiff_t from = std::max(runs_[a].first, runs_[b].first);
    const std::ptrdiff_t to = std::min(runs_[a].end, runs_[b].end);
    if (from < to && runs_[a].set == runs_[b].set) {
      const std::ptrdiff_t x = (from + to) / 2;
      links_.push_back({a, b, {x, row}, {x, above}});
    }
    ++(runs_[a].end < runs_[b].end ? a : b);
  }
}

void GridRuns::grow_tree(std::size_t set) {
  std::deque<std::size_t> open{run_of(grid_.sets()[set].cell)};
  arrivals_[open.front()] = root;
  while (!open.empty()) {
    const std::size_t run = open.front();
    open.pop_front();
    for (const std::size_t link : links_of_[run]) {
      const std::size_t other = links_[link].from == run ? links_[link].to : links_[link].from;
      if (arrivals_[other] != not_reached) continue;
      arrivals_[other] = link;
      open.push_back(other);
    }
  }
}

std::size_t GridRuns::run_of(const GridPlace& cell) const {
  const auto y = static_cast<std::size_t>(cell[1]);
  const auto begin = runs_.begin() + static_cast<std::ptrdiff_t>(row_begins_[y]);
  const auto end = runs_.begin() + static_cast<std::ptrdiff_t>(row_begins_[y + 1]);
  const auto after = std::upper_bound(begin, end, cell[0],
                                      [](std::ptrdiff_t x, const GridRun& run) { return x < run.first; });
  assert(after != begin);
  return static_cast<std::size_t>(after - runs_.begin()) - 1;
}

/// Along the tree, from the root.
std::vector<std::size_t> GridRuns::links_to(std::size_t run) const {
  std::vector<std::size_t> result;
  while (arrivals_[run] != root) {
    const GridLink& link = links_[arrivals_[run]];
    result.push_back(arrivals_[run]);
    run = link.to == run ? link.from : link.to;
  }
  std::reverse(result.begin(), result.end());
  return result;
}

std::vector<GridPlace> GridRuns::path_to(const GridPlace& cell) const {
  const std::size_t last = run_of(cell);
  const GridPlace& start = grid_.sets()[runs_[last].set].cell;
  std::size_t run = run_of(start);
  GridPlace turns{};
  std::vector<Stop> stops{{start, runs_[run], turns}};
  for (const std::size_t i : links_to(last)) {
    const GridLink& link = links_[i];
    const GridPlace further = from_to(grid_.within(link.there), link.there);
    const bool forth = link.from == run;
    stops.emplace_back(forth ? link.here : grid_.within(link.there), runs_[run], turns);
    run = forth ? link.to : link.from;
    turns = forth ? moved(turns, further) : from_to(further, turns);
    stops.emplace_back(forth ? grid_.within(link.there) : link.here, runs_[run], turns);
  }
  stops.emplace_back(cell, runs_[run], turns);
  return straightened(stops);
}

std::vector<std::vector<GridPlace>> GridRuns::loops(std::size_t set) const {
  std::vector<std::vector<GridPlace>> result;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const GridLink& link = links_[i];
    if (runs_[link.from].set != set || arrivals_[link.from] == i || arrivals_[link.to] == i) continue;
    std::vector<GridPlace> loop = path_to(link.here), back = path_to(grid_.within(link.there));
    const GridPlace there = moved(link.there, from_to(link.here, loop.back()));
    const GridPlace turns = from_to(back.back(), there);
    for (auto place = back.rbegin(); place != back.rend(); ++place) loop.push_back(moved(*place, turns));
    result.push_back(std::move(loop));
  }
  return result;
}

std::vector<GridGap> GridRuns::gaps(std::size_t axis, std::ptrdiff_t most_cells) const {
  std::vector<GridGap> result;
  const std::ptrdiff_t cells = grid_.cells_an_axis();
  const std::ptrdiff_t end = grid_.is_periodic(axis) ? cells + most_cells + 1 : cells;
  for (std::ptrdiff_t line = 0; line < cells; ++line) {
    std::optional<std::size_t> before;
    GridPlace last{}, at{line, line};
    for (at[axis] = 0; at[axis] < end; ++at[axis]) {
      const auto set = grid_.set_at(grid_.within(at));
      if (!set) continue;
      const std::ptrdiff_t between = at[axis] - last[axis] - 1;
      if (before && *before != *set && between <= most_cells && last[axis] < cells)
        result.push_back({{*before, *set}, {last, at}});
      before = set;
      last = at;
    }
  }
  return result;
}

}  // namespace parallel_aspects
