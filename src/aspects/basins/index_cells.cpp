// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/basins/index_cells.h"

#include "aspects/batches/box_requests.h"
#include "interval/interval.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>

namespace parallel_aspects {
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

/// Pending ones, unless the cell is inside: then they are, too.
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
