// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/basins_report.h"

#include "tools/report/report.h"
#include "tools/report/reports.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

constexpr int bar_width = 40;
constexpr std::size_t max_pairs = 12;  // that are listed by themselves

/// From the saddle to the depth, on a scale from 0 to `largest`.
std::string bar(const Basin& basin, double largest) {
  const auto place = [largest](double index) {
    return largest > 0.0 ? static_cast<std::size_t>(std::lround(bar_width * std::min(1.0, index / largest)))
                         : 0U;
  };
  const std::size_t from = basin.deeper ? place(basin.saddle.upper) : 0, to = place(basin.depth.lower);
  return std::string(from, ' ') + std::string(std::max<std::size_t>(1, to > from ? to - from : 1), '#');
}

/// Whether an upper bound says something: the normalised index is 1 at most anyway.
bool is_bounded(const MapBasins& basins, const IndexRange& bottleneck) {
  return basins.index == ParallelIndex::normalised ? bottleneck.upper < 1.0 : std::isfinite(bottleneck.upper);
}

std::string pair_text(const std::pair<int, int>& pair, const MapBasins& basins, const IndexRange& range) {
  return "  " + std::to_string(pair.first) + " and " + std::to_string(pair.second) +
         ": no path between them keeps a larger " + index_name(basins.index) + " than " +
         shown_bound(range.upper, Side::above) + "\n";
}

/// Places of the unresolved pairs, those of large aspects first.
std::vector<std::size_t> by_falling_size(const AspectMap& map) {
  const auto size = [&map](std::size_t i) {
    const auto [one, other] = map.unresolved()[i];
    return std::min(map.aspects()[static_cast<std::size_t>(one - 1)].measure,
                    map.aspects()[static_cast<std::size_t>(other - 1)].measure);
  };
  std::vector<std::size_t> places(map.unresolved().size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::stable_sort(places.begin(), places.end(),
                   [&size](std::size_t a, std::size_t b) { return size(a) > size(b); });
  return places;
}

}  // namespace

std::string shown_range(const IndexRange& range) {
  return shown_bound(range.lower, Side::below) + " to " + shown_bound(range.upper, Side::above);
}

std::string index_name(ParallelIndex index) {
  return index == ParallelIndex::normalised ? "parallel index" : "|det A|";
}

std::string persistence_text(const AspectMap& map, const MapBasins& basins) {
  double largest = 0.0;
  for (const Basin& basin : basins.basins) largest = std::max(largest, basin.depth.upper);
  TextTable table({">basin", ">aspect", "largest " + index_name(basins.index), ">merges into", "at",
                   "pose of the largest", "0 to " + shown_briefly(largest)});
  for (std::size_t i = 0; i < basins.basins.size(); ++i) {
    const Basin& basin = basins.basins[i];
    table.add({std::to_string(i + 1), std::to_string(basin.aspect), shown_range(basin.depth),
               basin.deeper ? std::to_string(*basin.deeper + 1) : "-",
               basin.deeper ? shown_range(basin.saddle) : "-",
               to_string(map.manipulator()->task_space(), basin.deepest), bar(basin, largest)});
  }
  return "\nbasins: parts of aspects that a larger margin separates, and the index at which they merge\n" +
         table.text();
}

std::string pairs_text(const AspectMap& map, const MapBasins& basins) {
  std::string text;
  std::size_t listed = 0, unbounded = 0;
  for (const std::size_t i : by_falling_size(map))
    if (!is_bounded(basins, basins.bottlenecks[i]))
      ++unbounded;
    else if (listed++ < max_pairs)
      text += pair_text(map.unresolved()[i], basins, basins.bottlenecks[i]);
  if (listed > max_pairs)
    text += "  and " + counted(listed - max_pairs, "more pair") + "; --json lists all\n";
  if (unbounded > 0)
    text += "  " + counted(unbounded, "pair") + (listed > 0 ? " more" : "") + ": no useful bound of the " +
            index_name(basins.index) + "\n";
  return text;
}

std::string bottleneck_text(ParallelIndex index, const Bottleneck& bottleneck) {
  if (bottleneck.status != BottleneckStatus::found) return bottleneck.message;
  const BottleneckPrecision aim;
  const double absolute = index == ParallelIndex::normalised ? aim.absolute : 0.0;
  const double width = bottleneck.index.upper - bottleneck.index.lower;
  return "the largest " + index_name(index) + " that a path can keep is " + shown_range(bottleneck.index) +
         (width > std::max(aim.relative * bottleneck.index.upper, absolute)
              ? ", where the search came to its limit; a finer --resolution may decide more"
              : "");
}

}  // namespace parallel_aspects::tools
