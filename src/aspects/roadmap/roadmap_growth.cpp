// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/roadmap/roadmap_growth.h"

#include "aspects/components/disjoint_sets.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t batch_size = 64;
constexpr int max_parts_of_an_edge = 400;
constexpr std::size_t max_bridging_rounds = 10;
constexpr std::size_t bridges_tried = 12;  // of each component in a round

struct Candidate {
  double length = 0.0;
  std::uint32_t a = 0, b = 0;

  friend bool operator<(const Candidate& x, const Candidate& y) {
    return std::tie(x.length, x.a, x.b) < std::tie(y.length, y.a, y.b);
  }
};

class SideGrowth {
 public:
  SideGrowth(RoadmapSide& side, const RoadmapGround& ground, const MapControl& control)
      : side_(side), ground_(ground), control_(control), sets_(side.poses.size()) {
    side_.links.assign(side_.poses.size(), {});
  }

  void run() {
    join(nearest([](std::uint32_t, std::uint32_t) { return true; }, ground_.neighbors));
    for (std::size_t round = 0; round < max_bridging_rounds && joined_; ++round) {
      if (is_cancelled(control_)) return;
      bridge();
    }
    number_components();
  }

 private:
  std::uint32_t size() const { return static_cast<std::uint32_t>(side_.poses.size()); }

  double distance(std::uint32_t a, std::uint32_t b) const {
    return (ground_.points[side_.poses[a]] - ground_.points[side_.poses[b]]).norm();
  }

  /// For each pose, candidates to the nearest others that `wanted` allows.
  template <class Wanted>
  std::vector<Candidate> nearest(const Wanted& wanted, std::size_t count) const {
    std::vector<std::vector<Candidate>> found(side_.poses.size());
    tbb::parallel_for(std::uint32_t{0}, size(), [&](std::uint32_t a) {
      if (is_cancelled(control_)) return;
      std::vector<Candidate> all;
      for (std::uint32_t b = 0; b < size(); ++b)
        if (b != a && wanted(a, b)) all.push_back({distance(a, b), std::min(a, b), std::max(a, b)});
      const std::size_t kept = std::min(count, all.size());
      const auto end = all.begin() + static_cast<std::ptrdiff_t>(kept);
      std::partial_sort(all.begin(), end, all.end());
      found[a].assign(all.begin(), end);
    });
    std::vector<Candidate> candidates;
    for (const auto& each : found) candidates.insert(candidates.end(), each.begin(), each.end());
    return candidates;
  }

  /// Tries candidates, shortest first. Batches, so that the order of unions does not depend on threads.
  void join(std::vector<Candidate> candidates) {
    joined_ = false;
    std::sort(candidates.begin(), candidates.end());
    std::vector<Candidate> batch;
    for (const Candidate& candidate : candidates) {
      if (is_cancelled(control_)) return;
      if (sets_.find(candidate.a) == sets_.find(candidate.b)) continue;
      if (!tried_.insert({candidate.a, candidate.b}).second) continue;
      batch.push_back(candidate);
      if (batch.size() == batch_size) join_batch(batch);
    }
    join_batch(batch);
  }

  void join_batch(std::vector<Candidate>& batch) {
    std::vector<char> proved(batch.size(), 0);
    tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t i) {
      if (is_cancelled(control_)) return;
      const Pose &from = pose(batch[i].a), &to = pose(batch[i].b);
      proved[i] =
          ground_.certifier.prove(from, to, side_.mode, max_parts_of_an_edge).verdict == SegmentVerdict::free;
    });
    for (std::size_t i = 0; i < batch.size(); ++i)
      if (proved[i] != 0) unite(batch[i]);
    batch.clear();
  }

  void unite(const Candidate& link) {
    if (sets_.find(link.a) == sets_.find(link.b)) return;
    sets_.unite(link.a, link.b);
    side_.links[link.a].push_back(link.b);
    side_.links[link.b].push_back(link.a);
    joined_ = true;
  }

  /// The shortest segments not tried yet from each component to others.
  void bridge() {
    std::vector<std::uint32_t> root(size());
    for (std::uint32_t i = 0; i < size(); ++i) root[i] = sets_.find(i);
    const std::uint32_t largest = most_frequent(root);
    auto candidates = nearest(
        [&](std::uint32_t a, std::uint32_t b) {
          return root[a] != largest && root[a] != root[b] && tried_.count(std::minmax(a, b)) == 0;
        },
        bridges_tried);
    std::sort(candidates.begin(), candidates.end());
    std::vector<std::size_t> used(size(), 0);
    std::vector<Candidate> chosen;
    for (const Candidate& each : candidates) {
      const std::uint32_t small = root[each.a] == largest ? root[each.b] : root[each.a];
      if (++used[small] <= bridges_tried) chosen.push_back(each);
    }
    join(chosen);
  }

  static std::uint32_t most_frequent(const std::vector<std::uint32_t>& root) {
    std::vector<std::size_t> count(root.size(), 0);
    for (const std::uint32_t each : root) ++count[each];
    return static_cast<std::uint32_t>(std::max_element(count.begin(), count.end()) - count.begin());
  }

  void number_components() {
    std::vector<std::uint32_t> root(size());
    std::vector<std::size_t> count(size(), 0);
    for (std::uint32_t i = 0; i < size(); ++i) ++count[root[i] = sets_.find(i)];
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < size(); ++i)
      if (count[i] > 0) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return count[a] > count[b]; });
    std::vector<std::uint32_t> number(size(), 0);
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      number[order[i]] = i;
      side_.component_sizes.push_back(count[order[i]]);
    }
    side_.component.resize(size());
    for (std::uint32_t i = 0; i < size(); ++i) side_.component[i] = number[root[i]];
  }

  const Pose& pose(std::uint32_t i) const { return ground_.poses[side_.poses[i]]; }

  RoadmapSide& side_;
  const RoadmapGround& ground_;
  const MapControl& control_;
  DisjointSets sets_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> tried_;
  bool joined_ = true;
};

}  // namespace

AnchorPoint anchor_point(const Manipulator& manipulator, const Pose& pose) {
  AnchorPoint point = AnchorPoint::Zero();
  const double weight = 1.0 / std::sqrt(static_cast<double>(manipulator.leg_count()));
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    point.segment<3>(3 * static_cast<Eigen::Index>(j)) = weight * pose.transform(manipulator.leg(j).anchor);
  return point;
}

void grow(RoadmapSide& side, const RoadmapGround& ground, const MapControl& control) {
  SideGrowth(side, ground, control).run();
}

}  // namespace parallel_aspects
