// SPDX-License-Identifier: BSD-3-Clause
#include "draw/page/outlines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

namespace parallel_aspects {
namespace {

constexpr double grain = 0.01;               // of rounded points [px]
constexpr double straightness = 0.06;        // how far a point that is left out may be off the line [px]
constexpr double smallest_loop = 0.5;        // beside a larger one [px^2]
constexpr std::size_t max_candidates = 600;  // for a label

using Key = std::pair<std::int64_t, std::int64_t>;

Key key_of(const PagePoint& point) {
  return {std::llround(point.x() / grain), std::llround(point.y() / grain)};
}
PagePoint point_of(const Key& key) {
  return grain * PagePoint(static_cast<double>(key.first), static_cast<double>(key.second));
}

double distance(const PagePoint& point, const PagePoint& from, const PagePoint& to) {
  const PagePoint along = to - from;
  const double length = along.squaredNorm();
  const double share = length > 0.0 ? std::clamp((point - from).dot(along) / length, 0.0, 1.0) : 0.0;
  return (point - from - share * along).norm();
}

// Douglas and Peucker's: what is needed between two points of a line.
void add_between(const PageLine& line, std::size_t from, std::size_t to, PageLine& kept) {
  std::size_t farthest = from;
  double largest = straightness;
  for (std::size_t i = from + 1; i < to; ++i)
    if (const double off = distance(line[i], line[from], line[to]); off > largest) {
      largest = off;
      farthest = i;
    }
  if (farthest != from) {
    add_between(line, from, farthest, kept);
    add_between(line, farthest, to, kept);
  } else {
    kept.push_back(line[to]);
  }
}

PageLine straightened(const PageLine& line) {
  PageLine kept{line.front()};
  std::size_t middle = line.size() - 1;
  if (line.front() == line.back())  // a loop is halved where it is farthest from its end
    for (std::size_t i = 0; i < line.size(); ++i)
      if ((line[i] - line.front()).norm() > (line[middle] - line.front()).norm()) middle = i;
  add_between(line, 0, middle, kept);
  if (middle + 1 < line.size()) add_between(line, middle, line.size() - 1, kept);
  return kept;
}

// Loops too small to see; the largest stays.
void drop_small(std::vector<PageLine>& loops) {
  const auto size = [](const PageLine& loop) { return std::abs(area_of({loop})); };
  const auto largest =
      std::max_element(loops.begin(), loops.end(),
                       [&size](const PageLine& a, const PageLine& b) { return size(a) < size(b); });
  if (largest == loops.end()) return;
  std::iter_swap(loops.begin(), largest);
  loops.erase(std::remove_if(loops.begin() + 1, loops.end(),
                             [&size](const PageLine& loop) { return size(loop) < smallest_loop; }),
              loops.end());
}

/// Ends that are not yet used, by point.
using Ends = std::multimap<Key, Key>;

// The line from here that uses up ends for as long as there are any.
template <class Use>
PageLine walk(Ends& ends, Key at, const Use& use) {
  PageLine line{point_of(at)};
  for (auto next = ends.find(at); next != ends.end(); next = ends.find(at)) {
    const Key to = next->second;
    ends.erase(next);
    use(to, at);
    at = to;
    line.push_back(point_of(at));
  }
  return line;
}

void erase_one(Ends& ends, const Key& from, const Key& to) {
  const auto [first, last] = ends.equal_range(from);
  const auto found = std::find_if(first, last, [&to](const auto& each) { return each.second == to; });
  if (found != last) ends.erase(found);
}

}  // namespace

std::vector<PageLine> outlines_of(const std::vector<PageLine>& polygons) {
  std::map<std::pair<Key, Key>, int> sides;
  for (const PageLine& polygon : polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Key from = key_of(polygon[i]), to = key_of(polygon[(i + 1) % polygon.size()]);
      if (from == to) continue;
      if (const auto opposite = sides.find({to, from}); opposite != sides.end()) {
        if (--opposite->second == 0) sides.erase(opposite);
      } else {
        ++sides[{from, to}];
      }
    }
  Ends ends;
  for (const auto& [side, count] : sides)
    for (int k = 0; k < count; ++k) ends.emplace(side.first, side.second);
  std::vector<PageLine> loops;
  while (!ends.empty()) {
    const PageLine loop = walk(ends, ends.begin()->first, [](const Key&, const Key&) {});
    if (loop.size() > 3) loops.push_back(straightened(loop));
  }
  drop_small(loops);
  return loops;
}

std::vector<PageLine> joined_lines(const std::vector<std::pair<PagePoint, PagePoint>>& pieces) {
  Ends ends;  // both ways
  std::map<std::pair<Key, Key>, bool> known;
  for (const auto& piece : pieces) {
    const Key from = key_of(piece.first), to = key_of(piece.second);
    if (from == to || !known.emplace(std::minmax(from, to), true).second) continue;
    ends.emplace(from, to);
    ends.emplace(to, from);
  }
  const auto use = [&ends](const Key& from, const Key& to) { erase_one(ends, from, to); };
  std::vector<PageLine> lines;
  while (!ends.empty()) {
    const Key start = ends.begin()->first;
    PageLine line = walk(ends, start, use);
    const PageLine before = walk(ends, start, use);
    line.insert(line.begin(), before.rbegin(), before.rend() - 1);
    lines.push_back(straightened(line));
  }
  return lines;
}

double area_of(const std::vector<PageLine>& loops) {
  double sum = 0.0;
  for (const PageLine& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const PagePoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
      sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
  return sum;
}

std::optional<LabelPoint> label_point(const std::vector<PageLine>& polygons,
                                      const std::vector<PageLine>& outlines) {
  std::optional<LabelPoint> best;
  const std::size_t step = polygons.size() / max_candidates + 1;
  for (std::size_t i = step / 2; i < polygons.size(); i += step) {
    PagePoint center = PagePoint::Zero();
    for (const PagePoint& corner : polygons[i]) center += corner / static_cast<double>(polygons[i].size());
    double clearance = std::numeric_limits<double>::infinity();
    for (const PageLine& line : outlines)
      for (std::size_t k = 0; k + 1 < line.size(); ++k)
        clearance = std::min(clearance, distance(center, line[k], line[k + 1]));
    if (!best || clearance > best->clearance) best = LabelPoint{center, clearance};
  }
  return best;
}

}  // namespace parallel_aspects
