// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/basins/index_peaks.h"

#include "aspects/batches/box_requests.h"
#include "interval/interval.h"

#include <algorithm>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr std::size_t starts = 300;                                   // leaves of an aspect
constexpr double first_step = 1.0 / 16.0, last_step = 1.0 / 65536.0;  // as a share of a root
constexpr double close_at_pose = 1e-9;  // bounds of the index, as a share of the upper one

/// To all neighbours in a grid of points.
std::vector<MapPoint> directions(std::size_t dimension) {
  std::vector<MapPoint> result(1);
  for (std::size_t axis = 0; axis < dimension; ++axis)
    for (std::size_t i = 0, count = result.size(); i < count; ++i)
      for (const double step : {1.0, -1.0}) {
        result.push_back(result[i]);
        result.back()[axis] = step;
      }
  result.erase(result.begin());
  return result;
}

class PeakSearch {
 public:
  PeakSearch(const AspectMap::Contents& map, const IndexOfMode& what)
      : map_(map), what_(what), directions_(directions(map.tree.dimension())) {}

  std::map<int, std::vector<NodeIndex>> leaves() const {
    std::map<int, std::vector<NodeIndex>> result;
    for (NodeIndex node = 0; node < map_.tree.node_count(); ++node)
      if (const int aspect = aspect_of(node); aspect != 0) result[aspect].push_back(node);
    return result;
  }

  IndexPeak start(const std::vector<NodeIndex>& leaves) const {
    IndexPeak best{-1.0, {}};
    const std::size_t count = std::min(starts, leaves.size());
    for (std::size_t i = 0; i < count; ++i) {
      const NodeIndex leaf = leaves[i * leaves.size() / count];
      best = higher(best, peak_at({map_.tree.place(leaf).root, map_.tree.box(leaf).middle()}));
    }
    return best;
  }

  /// Within inside leaves of the aspect.
  IndexPeak climb(int aspect, IndexPeak from) const {
    for (double step = first_step; step > last_step;) {
      IndexPeak best = from;
      for (const MapPoint& direction : directions_) {
        const MapPosition next = moved(best.at, direction, step);
        const auto leaf = map_.tree.leaf_at(next, what_.mode);
        if (leaf && aspect_of(*leaf) == aspect) best = higher(best, peak_at(next));
      }
      if (!(best.index > from.index)) step *= 0.5;
      from = best;
    }
    return from;
  }

 private:
  /// 0 where it is not an inside leaf of the sign.
  int aspect_of(NodeIndex node) const {
    return map_.tree.state(node, what_.mode).is_inside(what_.sign) ? map_.leaf_aspect(node, what_.mode) : 0;
  }

  IndexPeak peak_at(const MapPosition& at) const { return {index_at(map_, what_, at).lower, at}; }

  static const IndexPeak& higher(const IndexPeak& known, const IndexPeak& other) {
    return other.index > known.index ? other : known;
  }

  MapPosition moved(MapPosition at, const MapPoint& direction, double share) const {
    const Box root = map_.tree.box(at.root);
    for (std::size_t axis = 0; axis < root.dimension; ++axis)
      at.point[axis] += share * direction[axis] * root.width(axis);
    return at;
  }

  const AspectMap::Contents& map_;
  IndexOfMode what_;
  std::vector<MapPoint> directions_;
};

}  // namespace

IndexRange index_at(const AspectMap::Contents& map, const IndexOfMode& what, const MapPosition& position) {
  const RoundingUpward rounding;
  const Box box{map.tree.dimension(), position.point, position.point};
  const Interval range =
      map.classifier->enclose_index(position.root, box, what.mode, what.sign, what.index, close_at_pose);
  return {range.lower(), range.upper()};
}

double largest_in_region(const AspectMap::Contents& map, const IndexOfMode& what) {
  const RoundingUpward rounding;
  std::vector<IndexRequest> roots;
  for (RootIndex root = 0; root < map.tree.root_count(); ++root)
    roots.push_back({root, map.tree.box(root), any_index_gap});
  double largest = 0.0;
  for (const Interval& range : enclose_index(*map.classifier, what.mode, what.sign, what.index, roots))
    largest = std::max(largest, range.upper());
  return largest;
}

std::map<int, IndexPeak> find_index_peaks(const AspectMap::Contents& map, const IndexOfMode& what,
                                          const MapControl& control) {
  const PeakSearch search(map, what);
  std::map<int, IndexPeak> peaks;
  for (const auto& [aspect, leaves] : search.leaves()) {
    if (is_cancelled(control)) break;
    peaks[aspect] = search.climb(aspect, search.start(leaves));
  }
  return peaks;
}

}  // namespace parallel_aspects
