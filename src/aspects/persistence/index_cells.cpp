// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/persistence/index_cells.h"

#include "aspects/simd/box_requests.h"
#include "interval/interval.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr std::size_t starts = 300;                                   // leaves of an aspect
constexpr double first_step = 1.0 / 16.0, last_step = 1.0 / 65536.0;  // as a share of a root
constexpr double close_at_pose = 1e-9;  // bounds of the index, as a share of the upper one

/// Steps to all neighbours in a grid of points.
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

  /// Steps within inside leaves of the aspect.
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

namespace {

constexpr double close_enough = 0.02;  // bounds of the index in a cell, as a share of the upper one
constexpr std::size_t grain = 64;      // cells that are not worth another thread

}  // namespace

IndexCells::IndexCells(const AspectMap::Contents& map, const IndexOfMode& what)
    : map_(map), what_(what), tree_(map.tree.shared_space(), 1) {
  aspects_.assign(tree_.node_count(), 0);
  for (RootIndex root = 0; root < tree_.root_count(); ++root) copy(root, root);
  bounds_.resize(tree_.node_count());
}

/// The other sign is left out.
void IndexCells::copy(NodeIndex from, NodeIndex to) {
  const LeafState state = map_.tree.state(from, what_.mode);
  if (!state.is_divided()) {
    tree_.state(to, 0) = state.may_be(what_.sign) ? state : LeafState::outside();
    aspects_[to] = map_.leaf_aspect(from, what_.mode);
    return;
  }
  tree_.state(to, 0) = LeafState::undecided(true, true);
  const NodeIndex first = tree_.divide(to, [](std::size_t) { return true; });
  aspects_.resize(tree_.node_count(), 0);
  for (NodeIndex rank = 0; rank < tree_.children_per_node(); ++rank)
    copy(map_.tree.first_child(from) + rank, first + rank);
}

std::vector<NodeIndex> IndexCells::all() const {
  std::vector<NodeIndex> cells;
  for (NodeIndex node = 0; node < tree_.node_count(); ++node)
    if (is_cell(node)) cells.push_back(node);
  return cells;
}

const IndexCells::Bounds& IndexCells::bounds(NodeIndex node, Effort effort) const {
  Bounds& known = bounds_[node];
  if (known.effort >= effort) return known;
  const auto foreseen = effort == Effort::more ? foreseen_.find(node) : foreseen_.end();
  if (foreseen != foreseen_.end()) {
    take_in({node, effort}, foreseen->second);
    foreseen_.erase(foreseen);
  } else {
    bound({{node, effort}});
  }
  return known;
}

void IndexCells::bound(const std::vector<Question>& questions) const {
  std::vector<Question> open;
  for (const Question& each : questions)
    if (bounds_[each.node].effort < each.effort) open.push_back(each);
  const std::vector<Interval> ranges = enclose(open);
  for (std::size_t i = 0; i < open.size(); ++i) take_in(open[i], ranges[i]);
}

void IndexCells::foresee(const std::vector<NodeIndex>& nodes) const {
  std::vector<Question> questions;
  for (const NodeIndex node : nodes) questions.push_back({node, Effort::more});
  const std::vector<Interval> ranges = enclose(questions);
  for (std::size_t i = 0; i < nodes.size(); ++i) foreseen_[nodes[i]] = ranges[i];
}

std::vector<Interval> IndexCells::enclose(const std::vector<Question>& questions) const {
  const RoundingUpward rounding;
  std::vector<IndexRequest> boxes;
  for (const auto& [node, effort] : questions)
    boxes.push_back(
        {tree_.place(node).root, tree_.box(node), effort == Effort::more ? close_enough : any_index_gap});
  return enclose_index(*map_.classifier, what_.mode, what_.sign, what_.index, boxes);
}

void IndexCells::take_in(const Question& question, const Interval& range) const {
  bounds_[question.node] = {is_inside(question.node) ? range.lower() : 0.0, range.upper(), question.effort};
}

void IndexCells::bound_all() const {
  const std::vector<NodeIndex> cells = all();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells.size(), grain), [&](const auto& range) {
    std::vector<Question> questions;
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      questions.push_back({cells[i], usual_effort(cells[i])});
    bound(questions);
  });
}

std::vector<NodeIndex> IndexCells::divide(const std::vector<NodeIndex>& cells) {
  std::vector<NodeIndex> children;
  for (const NodeIndex cell : cells) {
    if (!can_be_halved(cell)) continue;
    const NodeIndex first = add_children(cell);
    for (NodeIndex rank = 0; rank < tree_.children_per_node(); ++rank) children.push_back(first + rank);
  }
  bounds_.resize(tree_.node_count());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, children.size(), grain), [&](const auto& range) {
    classify_pending(&children[range.begin()], range.size());
    std::vector<Question> questions;
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      if (is_cell(children[i])) questions.push_back({children[i], usual_effort(children[i])});
    bound(questions);
  });
  const auto is_none = [this](NodeIndex child) { return !is_cell(child); };
  children.erase(std::remove_if(children.begin(), children.end(), is_none), children.end());
  return children;
}

/// Pending children, unless the cell is inside: then the children are inside, too.
NodeIndex IndexCells::add_children(NodeIndex cell) {
  const bool inside = is_inside(cell);
  tree_.state(cell, 0) = LeafState::undecided(true, true);
  const NodeIndex first = tree_.divide(cell, [](std::size_t) { return true; });
  aspects_.resize(tree_.node_count(), aspects_[cell]);
  for (NodeIndex rank = 0; inside && rank < tree_.children_per_node(); ++rank)
    tree_.state(first + rank, 0) = LeafState::inside(what_.sign);
  return first;
}

void IndexCells::classify_pending(const NodeIndex* nodes, std::size_t count) {
  const RoundingUpward rounding;
  std::vector<NodeIndex> pending;
  std::copy_if(nodes, nodes + count, std::back_inserter(pending),
               [this](NodeIndex node) { return tree_.state(node, 0).is_pending(); });
  std::vector<LeafState> states(pending.size() * (what_.mode + 1));  // of this mode the last
  BoxRequests requests;
  for (std::size_t i = 0; i < pending.size(); ++i)
    requests.push_back({tree_.place(pending[i]).root, tree_.box(pending[i]), ModeSet{1} << what_.mode,
                        &states[i * (what_.mode + 1)]});
  parallel_aspects::classify(*map_.classifier, requests, Detail::states);
  for (std::size_t i = 0; i < pending.size(); ++i) {
    const LeafState found = requests[i].states[what_.mode];
    tree_.state(pending[i], 0) = found.may_be(what_.sign) ? found : LeafState::outside();
  }
}

}  // namespace parallel_aspects
