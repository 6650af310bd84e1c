// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/segment_proof.h"
#include "aspects/map/map_contents.h"
#include "aspects/persistence/index_cells.h"
#include "aspects/tree/neighbour_leaves.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/connectivity.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

/// Looks for the largest index that a path between two positions can keep.
///
/// From below: the path through inside cells whose least lower bound is the largest. From above: of all paths
/// through cells, inside and undecided, the largest least upper bound, since every path in S(mode, sign) can
/// be moved a little so that it goes through faces alone. Cells are halved where they stand between the two:
/// on the shortest chains of cells of which it is not known whether they can be passed at a level between.
class BottleneckSearch {
 public:
  BottleneckSearch(IndexCells& cells, const MapPosition& from, const MapPosition& to,
                   const BottleneckPrecision& precision, const MapControl& control)
      : cells_(cells), from_(from), to_(to), precision_(precision), control_(control) {}

  Bottleneck run() {
    Bottleneck result;
    result.status = BottleneckStatus::found;
    const double ends = std::min(cells_.at(from_).upper, cells_.at(to_).upper);
    while (true) {
      if (is_cancelled(control_)) return {BottleneckStatus::cancelled, "The search was cancelled.", {}, 0};
      const std::optional<double> upper = widest([this](NodeIndex cell) { return cells_.upper(cell); });
      if (!upper)
        return {BottleneckStatus::separate,
                "No path in the region of the map connects the two.",
                {},
                result.halved};
      const double lower = widest([this](NodeIndex cell) { return cells_.lower(cell); }).value_or(0.0);
      result.index = {std::max(lower, result.index.lower), std::min({*upper, ends, result.index.upper})};
      if (is_precise(result.index) || result.halved > precision_.boxes || visited_ > precision_.visits)
        return result;
      const std::vector<NodeIndex> doubtful = chains(0.5 * (result.index.lower + result.index.upper));
      if (cells_.divide(doubtful).empty()) return result;
      result.halved += doubtful.size();
    }
  }

 private:
  bool is_precise(const IndexRange& range) const {
    return range.upper - range.lower <= std::max(precision_.relative * range.upper, precision_.absolute);
  }

  NodeIndex cell_at(const MapPosition& position) const { return *cells_.tree().leaf_at(position, 0); }

  /// Cells come by falling level, so the first way to a cell is a widest one; other ways to it are left out.
  /// The largest least value along a path of cells; none where no path has a positive one, or there is none.
  template <class Value>
  std::optional<double> widest(const Value& value) const {
    const NodeIndex goal = cell_at(to_);
    std::priority_queue<std::pair<double, NodeIndex>> queue;
    std::vector<bool> is_done(cells_.tree().node_count(), false);
    queue.emplace(value(cell_at(from_)), cell_at(from_));
    while (!queue.empty()) {
      const auto [level, cell] = queue.top();
      queue.pop();
      if (!(level > 0.0)) return std::nullopt;
      if (cell == goal) return level;
      if (is_done[cell]) continue;
      is_done[cell] = true;
      ++visited_;
      for (const NodeIndex next : neighbour_leaves(cells_.tree(), 0, cell))
        if (!is_done[next]) queue.emplace(std::min(level, value(next)), next);
    }
    return std::nullopt;
  }

  /// For each cell that could be passed at the level: the least number of cells on the way, itself included,
  /// for which that is not proved.
  std::vector<std::uint32_t> unproved_on_the_way(NodeIndex start, double level) const {
    std::vector<std::uint32_t> count(cells_.tree().node_count(), unreached);
    const auto cost = [&](NodeIndex cell) { return cells_.lower(cell) > level ? 0U : 1U; };
    std::deque<NodeIndex> queue{start};
    count[start] = cost(start);
    while (!queue.empty()) {
      const NodeIndex cell = queue.front();
      queue.pop_front();
      ++visited_;
      for (const NodeIndex next : neighbour_leaves(cells_.tree(), 0, cell)) {
        const std::uint32_t through = count[cell] + cost(next);
        if (!(cells_.upper(next) > level) || through >= count[next]) continue;
        count[next] = through;
        if (cost(next) == 0)
          queue.push_front(next);
        else
          queue.push_back(next);
      }
    }
    return count;
  }

  /// The cells of the shortest chains between what is proved from either end.
  std::vector<NodeIndex> chains(double level) const {
    const std::vector<std::uint32_t> ahead = unproved_on_the_way(cell_at(from_), level),
                                     back = unproved_on_the_way(cell_at(to_), level);
    const std::uint32_t least = ahead[cell_at(to_)];
    std::vector<NodeIndex> cells;
    if (least == unreached) return cells;
    for (NodeIndex cell = 0; cell < ahead.size(); ++cell)
      if (ahead[cell] != unreached && back[cell] != unreached && !(cells_.lower(cell) > level) &&
          ahead[cell] + back[cell] <= least + 1 + detour)
        cells.push_back(cell);
    return cells;
  }

  static constexpr std::uint32_t unreached = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::uint32_t detour = 1;  // longer chains are examined in the same round

  IndexCells& cells_;
  const MapPosition from_, to_;
  const BottleneckPrecision precision_;
  const MapControl& control_;
  mutable std::size_t visited_ = 0;  // cells, over all searches
};

Bottleneck refused(const std::string& message) { return {BottleneckStatus::not_in_aspect, message, {}, 0}; }

int sign_at(const AspectMap::Contents& map, std::size_t mode, const MapPosition& position) {
  const RoundingUpward rounding;
  return proved_sign(*map.classifier, map.tree.dimension(), mode, position);
}

}  // namespace

Bottleneck find_bottleneck(const AspectMap& map, const WorkingMode& mode, const Pose& from, const Pose& to,
                           ParallelIndex index, const BottleneckPrecision& precision,
                           const MapControl& control) {
  const AspectMap::Contents& contents = map.contents();
  const auto place = mode_index(contents, mode);
  if (!place) return refused("The map does not have the working mode " + to_string(mode) + ".");
  const MapPosition start = contents.tree.space().position(from), end = contents.tree.space().position(to);
  if (!contents.tree.leaf_at(start, *place) || !contents.tree.leaf_at(end, *place))
    return refused("One of the poses lies outside the region of the map.");
  const int sign = sign_at(contents, *place, start), other = sign_at(contents, *place, end);
  if (sign == 0) return refused("The first pose is not proved to lie in an aspect.");
  if (other == 0) return refused("The second pose is not proved to lie in an aspect.");
  if (other != sign)
    return {BottleneckStatus::separate, "det A has different signs at the two poses.", {}, 0};
  IndexCells cells(contents, {*place, sign, index});
  BottleneckPrecision wanted = precision;
  if (index == ParallelIndex::determinant) wanted.absolute = 0.0;
  return BottleneckSearch(cells, start, end, wanted, control).run();
}

}  // namespace parallel_aspects
