// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_DEEPEST_INDEX_H
#define PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_DEEPEST_INDEX_H

#include "aspects/persistence/cell_owners.h"
#include "aspects/persistence/index_cells.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Whether an upper bound of the index is so close to a lower one that it need not be lowered.
bool is_precise(double upper, double lower, std::size_t dimension, ParallelIndex index);

/// Looks for the largest index in each aspect of one working mode and sign of det A by branch and bound, for
/// all of them at once: of the nodes of the tree that may hold one the one with the highest upper bound is
/// opened, from the roots down to cells, which are halved. What is left when an owner of cells is bounded
/// precisely enough, or has taken too much work, bounds it.
class DeepestIndex {
 public:
  /// The peaks are those of the mode, sign and index of the cells.
  DeepestIndex(IndexCells& cells, const std::map<int, IndexPeak>& peaks, const MapControl& control);

  void search();

  /// The largest index in each aspect, by id.
  std::map<int, IndexRange> ranges() const;
  /// Where it is no less than the lower end, by id.
  const std::map<int, IndexPeak>& peaks() const noexcept { return peaks_; }

 private:
  using Queue = OpenQueue<std::pair<double, NodeIndex>>;

  /// How far the search for one owner has come.
  struct Progress {
    bool is_open = true;
    double upper = 0.0;  // where not open
    double reached =
        0.0;  // by a pose that all legs reach in one of its cells, which may be of another aspect
    std::size_t halved = 0;
  };

  void search_once();
  void take_in_bounds();
  void start();
  void close(double upper, NodeIndex node);
  void settle(std::size_t owner, double upper);
  void close_rest();
  bool matters(NodeIndex node) const;
  bool is_lowered(double upper, NodeIndex node);
  void open(double upper, NodeIndex node);
  void open_children(double upper, NodeIndex node);
  void open_cell(double upper, NodeIndex cell);
  void look_at_middle(NodeIndex cell, std::size_t owner);
  void halve(double upper, NodeIndex cell);
  void raise(int aspect, double lower, const MapPosition& at);
  MapPosition middle(NodeIndex node) const;
  double enough(std::size_t owner);
  std::size_t most_halvings(std::size_t owner, double upper);

  IndexCells& cells_;
  CellOwners owners_;
  double absolute_;
  const MapControl& control_;
  std::map<int, IndexPeak> peaks_;  // by id
  std::map<int, double> upper_;
  std::map<int, double> settled_;  // highest bound of the owners of each that are not open
  std::vector<Progress> progress_;
  Queue queue_;
  std::size_t evaluations_ = 0, most_evaluations_;
  bool has_halved_groups_ = false;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_DEEPEST_INDEX_H
