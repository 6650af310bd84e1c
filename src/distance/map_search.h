// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_MAP_SEARCH_H
#define PARALLEL_ASPECTS_DISTANCE_MAP_SEARCH_H

#include "aspects/map/map_contents.h"
#include "distance/cell.h"
#include "distance/leaf_view.h"
#include "distance/local_chart.h"
#include "distance/singular_leaves.h"
#include "parallel_aspects/distance/boundary_distances.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// The parts of a map that may hold a parallel singularity, the nearest first, as cells of the coordinates of
/// a local_chart. Of one working mode. The local_chart must outlive it; its metric, too.
template <TaskSpace space>
class MapSearch {
 public:
  static constexpr std::size_t size = LocalChart<space>::size;

  explicit MapSearch(const LocalChart<space>& chart)
      : chart_(chart),
        view_(chart.metric()),
        turning_(LocalChart<space>::turns > 0 ? chart.metric().turning(Eigen::Vector3d::Zero()) : 0.0) {}

  /// Tags of cells in which all is searched for, or only what the map does not have.
  static constexpr std::size_t unmapped = 0, beyond_map = 1;

  /// Allocates.
  void use(std::shared_ptr<const DistanceMap> map) {
    queue_.reserve(map ? capacity : 0);
    map_ = std::move(map);
  }

  void set_mode(const WorkingMode& mode) noexcept {
    const auto index = map_ ? mode_index(map_->map()->contents(), mode) : std::nullopt;
    leaves_ = index && map_->leaves().complete() ? &map_->leaves().of(*index) : nullptr;
  }

  /// Whether there is a map of the mode.
  bool knows() const noexcept { return leaves_ != nullptr; }

  /// Starts at the pose of the local_chart. Needs a live `RoundingUpward`; so does all that follows.
  void start(double target) noexcept {
    queue_.clear();
    looks_ = 0;
    view_.look_from(chart_.pose(), map_->leaves().extent());
    if (leaves_->levels.empty()) return;
    const LeafBall& all = leaves_->levels.back().front();
    push(view_.least_distance(all), leaves_->levels.size(), 0, target);
  }

  /// Proved: no singularity of the map is closer, but for those in cells that were handed out.
  double bound() const noexcept {
    return queue_.empty() ? std::numeric_limits<double>::infinity() : queue_.front().bound;
  }

  bool is_exhausted() const noexcept { return looks_ >= max_looks; }

  /// Examines the nearest item. Nothing, or a cell that may hold a singularity; where no cell encloses that,
  /// `all`.
  std::optional<Cell<size>> next(double target, const Cell<size>& all) noexcept {
    const Item item = queue_.front();
    std::pop_heap(queue_.begin(), queue_.end(), later);
    queue_.pop_back();
    ++looks_;
    if (item.height == 0) return cell_of(leaves_->leaves[item.index], item.bound, all);
    const std::size_t below = item.height - 1;
    const std::size_t count = below == 0 ? leaves_->leaves.size() : leaves_->levels[below - 1].size();
    const std::size_t first = item.index * LeafTree::children;
    for (std::size_t i = first; i < std::min(count, first + LeafTree::children); ++i) {
      const double bound = below == 0 ? view_.least_distance(leaves_->leaves[i], target)
                                      : view_.least_distance(leaves_->levels[below - 1][i]);
      if (!push(std::max(bound, item.bound), below, i, target)) return whole(all, item.bound);
    }
    return std::nullopt;
  }

  /// Proved: no pose is closer that the map does not have and that may be reached.
  double distance_beyond() const noexcept {
    double least = std::numeric_limits<double>::infinity();
    const SingularLeaves::Ends& ends = map_->leaves().ends();
    for (std::size_t i = 0; i < LocalChart<space>::moves; ++i) {
      const double at = chart_.pose().position[static_cast<Eigen::Index>(i)];
      least = std::min({least, -(at - ends.upper[i]), -(ends.lower[i] - at)});
    }
    // The operational point moves by |c' - c| + turning |r| at most.
    const Interval share = reciprocal(square_root(Interval(1.0) + square(Interval(turning_))));
    return least > 0.0 ? (Interval(least) * share).lower() : 0.0;
  }

  /// Whether the map is proved to have all poses of a box of coordinates that may be reached.
  bool has(const std::array<Interval, size>& y) const noexcept {
    const auto point = chart_.operational_point(y);
    const SingularLeaves::Ends& ends = map_->leaves().ends();
    for (std::size_t i = 0; i < LocalChart<space>::moves; ++i)
      if (!(ends.lower[i] <= point[i].lower() && point[i].upper() <= ends.upper[i])) return false;
    return true;
  }

 private:
  static constexpr std::size_t capacity = 1U << 14U;
  static constexpr int max_looks = 4000;

  /// A leaf of height 0, or a ball.
  struct Item {
    double bound;
    std::uint32_t index;
    std::uint32_t height;
  };

  static bool later(const Item& a, const Item& b) noexcept { return a.bound > b.bound; }

  bool push(double bound, std::size_t height, std::size_t index, double target) noexcept {
    if (bound >= target) return true;
    if (queue_.size() == capacity) return false;
    queue_.push_back({bound, static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(height)});
    std::push_heap(queue_.begin(), queue_.end(), later);
    return true;
  }

  Cell<size> cell_of(const SingularLeaf& leaf, double bound, const Cell<size>& all) noexcept {
    const auto seen = view_.see(leaf.center);
    if (view_.is_about_half_turn(seen, leaf)) return whole(all, bound);
    Cell<size> cell = view_.cell_about(seen, leaf);
    cell.bound = std::max(0.0, bound);
    return cell;
  }

  // It holds all that is left.
  Cell<size> whole(const Cell<size>& all, double bound) noexcept {
    queue_.clear();
    Cell<size> cell = all;
    cell.tag = unmapped;
    cell.bound = std::max(0.0, bound);
    return cell;
  }

  const LocalChart<space>& chart_;
  LeafView<space> view_;
  double turning_;  // the operational point moves about the centroid by this much at most, a metre of |r|
  std::shared_ptr<const DistanceMap> map_;
  const LeafTree* leaves_ = nullptr;
  std::vector<Item> queue_;
  int looks_ = 0;
};

/// There is no map of SE3.
template <>
class MapSearch<TaskSpace::SE3> {
 public:
  static constexpr std::size_t size = 6;
  static constexpr std::size_t unmapped = 0, beyond_map = 1;
  explicit MapSearch(const LocalChart<TaskSpace::SE3>&) noexcept {}
  void use(const std::shared_ptr<const DistanceMap>&) noexcept {}
  void set_mode(const WorkingMode&) noexcept {}
  static bool knows() noexcept { return false; }
  void start(double) noexcept {}
  static double bound() noexcept { return std::numeric_limits<double>::infinity(); }
  static bool is_exhausted() noexcept { return false; }
  static std::optional<Cell<size>> next(double, const Cell<size>&) noexcept { return std::nullopt; }
  static double distance_beyond() noexcept { return 0.0; }
  static bool has(const std::array<Interval, size>&) noexcept { return false; }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_MAP_SEARCH_H
