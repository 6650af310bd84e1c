// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/persistence/deepest_index.h"

#include <algorithm>
#include <limits>

namespace parallel_aspects {
namespace {

/// When an owner of cells is bounded precisely enough, or has taken too much work.
struct Precision {
  double inside;         // gap of the bounds in the inside cells of an aspect, as a share of the upper one
  double undecided;      // likewise in undecided cells
  double absolute;       // or this, of the normalised index
  std::size_t halvings;  // of inside cells, for each aspect
  // Likewise, once other cells do not lower the bound: then they matter only for paths between aspects.
  std::size_t halvings_for_paths;
  std::size_t halvings_of_undecided;  // for each owner of undecided cells and round
  int rounds;                         // since groups fall apart when they are halved
  // The number of enclosures, as a share of the number of nodes, but at least the second.
  double share_of_nodes;
  std::size_t always;
};

constexpr Precision curves{0.01, 0.05, 0.002, 3000, 3000, 2000, 3, 0.5, 20000};
// With three coordinates undecided cells lie along surfaces: far more boxes than these would be needed to
// bound the index there as precisely.
constexpr Precision surfaces{0.05, 0.05, 0.01, 10000, 300, 4000, 1, 0.5, 10000};

const Precision& precision(std::size_t dimension) { return dimension <= 2 ? curves : surfaces; }

const Precision& precision(const IndexCells& cells) { return precision(cells.tree().dimension()); }

double absolute(const Precision& wanted, ParallelIndex index) {
  return index == ParallelIndex::normalised ? wanted.absolute : 0.0;
}

/// The upper bound that is precise enough where the index reaches `lower`.
double precise_enough(double lower, double share, double absolute) {
  return std::max(lower / (1.0 - share), lower + absolute);
}

}  // namespace

bool is_precise(double upper, double lower, std::size_t dimension, ParallelIndex index) {
  const Precision& wanted = precision(dimension);
  return upper <= precise_enough(lower, wanted.inside, absolute(wanted, index));
}

DeepestIndex::DeepestIndex(IndexCells& cells, const std::map<int, IndexPeak>& peaks,
                           const MapControl& control)
    : cells_(cells),
      owners_(cells),
      absolute_(absolute(precision(cells), cells.index())),
      control_(control),
      peaks_(peaks),
      most_evaluations_(precision(cells).always +
                        static_cast<std::size_t>(precision(cells).share_of_nodes *
                                                 static_cast<double>(cells.tree().node_count()))) {
  for (const auto& [id, peak] : peaks_) upper_[id] = std::numeric_limits<double>::infinity();
}

void DeepestIndex::search() {
  for (int round = 0; round < precision(cells_).rounds && !is_cancelled(control_); ++round) {
    if (round > 0) owners_.find();
    search_once();
    take_in_bounds();
    if (!has_halved_groups_ || evaluations_ >= most_evaluations_) break;
  }
}

std::map<int, IndexRange> DeepestIndex::ranges() const {
  std::map<int, IndexRange> ranges;
  for (const auto& [id, peak] : peaks_) ranges[id] = {peak.index, upper_.at(id)};
  return ranges;
}

/// Bounds of every round hold.
void DeepestIndex::take_in_bounds() {
  std::map<int, double> upper;
  for (std::size_t owner = 0; owner < progress_.size(); ++owner)
    for (const int id : owners_.all()[owner].aspects) upper[id] = std::max(upper[id], progress_[owner].upper);
  for (const auto& [id, bound] : upper) upper_[id] = std::min(upper_.at(id), bound);
}

/// Nodes come by falling bounds, and parts are bounded no higher than their wholes: what an owner has left
/// when it is settled is bounded by the node that comes first then, and need not be opened.
void DeepestIndex::search_once() {
  start();
  while (!queue_.empty() && evaluations_ < most_evaluations_ && !is_cancelled(control_)) {
    const auto [upper, node] = queue_.top();
    close(upper, node);
    queue_.pop();
    if (matters(node) && !is_lowered(upper, node)) open(upper, node);
  }
  close_rest();
}

void DeepestIndex::start() {
  has_halved_groups_ = false;
  queue_ = {};
  progress_.assign(owners_.all().size(), {});
  settled_.clear();
  for (RootIndex root = 0; root < cells_.tree().root_count(); ++root)
    if (owners_.within(root) != 0) queue_.emplace(cells_.upper(root, IndexCells::Effort::little), root);
}

/// Owners of a node that are bounded precisely enough by the highest upper bound that is left.
void DeepestIndex::close(double upper, NodeIndex node) {
  const auto close_one = [this, upper](std::size_t owner) {
    if (progress_[owner].is_open && upper <= enough(owner)) settle(owner, upper);
  };
  if (cells_.is_cell(node) && owners_.of(node) != CellOwners::none) return close_one(owners_.of(node));
  for (std::size_t owner = 0; owner < progress_.size(); ++owner)
    if ((owners_.within(node) & CellOwners::bit(owner)) != 0) close_one(owner);
}

/// The bounds of its aspects in cells of other owners need not be lowered further.
void DeepestIndex::settle(std::size_t owner, double upper) {
  progress_[owner].is_open = false;
  progress_[owner].upper = upper;
  for (const int id : owners_.all()[owner].aspects) settled_[id] = std::max(settled_[id], upper);
}

/// By the bound of what is left of each.
void DeepestIndex::close_rest() {
  for (; !queue_.empty(); queue_.pop()) {
    const auto [upper, node] = queue_.top();
    const std::uint64_t within = owners_.within(node);
    for (std::size_t owner = 0; owner < progress_.size(); ++owner)
      if (progress_[owner].is_open && (within & CellOwners::bit(owner)) != 0)
        progress_[owner].upper = std::max(progress_[owner].upper, upper);
  }
}

bool DeepestIndex::matters(NodeIndex node) const {
  if (cells_.is_cell(node))
    return owners_.of(node) != CellOwners::none && progress_[owners_.of(node)].is_open;
  const std::uint64_t within = owners_.within(node);
  for (std::size_t owner = 0; owner < progress_.size(); ++owner)
    if (progress_[owner].is_open && (within & CellOwners::bit(owner)) != 0) return true;
  return false;
}

/// Whether more effort shows that the node has its place farther behind.
bool DeepestIndex::is_lowered(double upper, NodeIndex node) {
  if (cells_.effort(node) == IndexCells::Effort::more) return false;
  ++evaluations_;
  cells_.foresee(node, queue_.heap(), [](const auto& entry) { return entry.second; });
  const double lowered = cells_.upper(node, IndexCells::Effort::more);
  if (cells_.is_cell(node) && cells_.is_inside(node))
    raise(cells_.aspect(node), cells_.lower(node), middle(node));
  if (lowered < upper) queue_.emplace(lowered, node);
  return lowered < upper;
}

void DeepestIndex::open(double upper, NodeIndex node) {
  if (cells_.is_cell(node))
    open_cell(upper, node);
  else
    open_children(upper, node);
}

void DeepestIndex::open_children(double upper, NodeIndex node) {
  const NodeIndex first = cells_.tree().first_child(node);
  std::vector<IndexCells::Question> questions;
  for (NodeIndex rank = 0; rank < cells_.tree().children_per_node(); ++rank)
    if (owners_.within(first + rank) != 0) questions.push_back({first + rank, IndexCells::Effort::little});
  cells_.bound(questions);
  for (NodeIndex child = first; child < first + cells_.tree().children_per_node(); ++child) {
    if (owners_.within(child) == 0) continue;
    ++evaluations_;
    queue_.emplace(std::min(upper, cells_.upper(child, IndexCells::Effort::little)), child);
  }
}

/// Its middle may show that it need not be halved.
void DeepestIndex::open_cell(double upper, NodeIndex cell) {
  const std::size_t owner = owners_.of(cell);
  look_at_middle(cell, owner);
  if (upper <= enough(owner) || !cells_.can_be_halved(cell) ||
      progress_[owner].halved >= most_halvings(owner, upper))
    return settle(owner, upper);
  ++progress_[owner].halved;
  has_halved_groups_ = has_halved_groups_ || !owners_.all()[owner].is_inside;
  halve(upper, cell);
}

std::size_t DeepestIndex::most_halvings(std::size_t owner, double upper) {
  const CellOwner& cells = owners_.all()[owner];
  const Precision& wanted = precision(cells_);
  if (!cells.is_inside) return wanted.halvings_of_undecided;
  return upper > settled_[*cells.aspects.begin()] ? wanted.halvings : wanted.halvings_for_paths;
}

void DeepestIndex::look_at_middle(NodeIndex cell, std::size_t owner) {
  const IndexRange range = cells_.at(middle(cell));
  ++evaluations_;
  progress_[owner].reached = std::max(progress_[owner].reached, range.lower);
  if (cells_.is_inside(cell)) raise(cells_.aspect(cell), range.lower, middle(cell));
}

void DeepestIndex::halve(double upper, NodeIndex cell) {
  const std::vector<NodeIndex> children = cells_.divide({cell});
  evaluations_ += children.size();
  for (const NodeIndex found : owners_.take_in(cell, children))
    raise(cells_.aspect(found), cells_.lower(found), middle(found));
  for (const NodeIndex child : children)
    queue_.emplace(std::min(upper, cells_.upper(child, IndexCells::Effort::little)), child);
}

void DeepestIndex::raise(int aspect, double lower, const MapPosition& at) {
  if (aspect != 0 && lower > peaks_.at(aspect).index) peaks_[aspect] = {lower, at};
}

MapPosition DeepestIndex::middle(NodeIndex node) const {
  return {cells_.tree().place(node).root, cells_.tree().box(node).middle()};
}

/// Undecided cells are bounded where they make the bound of no aspect loose, more than others do anyway or,
/// with three coordinates, where the index is nearly as high in them.
double DeepestIndex::enough(std::size_t owner) {
  const CellOwner& cells = owners_.all()[owner];
  const Precision& wanted = precision(cells_);
  const double share = cells.is_inside ? wanted.inside : wanted.undecided;
  double least = std::numeric_limits<double>::infinity();
  for (const int id : cells.aspects) {
    const double settled = cells.is_inside ? 0.0 : settled_[id];
    least = std::min(least, std::max(precise_enough(peaks_.at(id).index, share, absolute_), settled));
  }
  if (wanted.rounds > 1 || cells.is_inside) return least;
  return std::max(least, precise_enough(progress_[owner].reached, share, absolute_));
}

}  // namespace parallel_aspects
