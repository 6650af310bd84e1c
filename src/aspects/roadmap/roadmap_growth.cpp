// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/roadmap/roadmap_growth.h"

#include "aspects/components/disjoint_sets.h"
#include "aspects/roadmap/pose_sampler.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

namespace {

constexpr std::size_t tries_to_attach = 24, tries_to_join = 3;
constexpr std::size_t draws_in_brief = 400, most_draws_at_all = 40000;
constexpr double share_kept = 0.9;  // of a way that ends at a singularity or a limit
constexpr double shortest_path = 1e-3;
constexpr int max_parts_of_a_segment = 100;

}  // namespace

PathSearch::PathSearch(const PoseRoadmap& roadmap, const WorkingMode& mode, int sign)
    : roadmap_(roadmap), mode_(mode) {
  const RoadmapSide* side = roadmap.side(mode, sign);
  if (side == nullptr) return;
  for (const std::uint32_t pose : side->poses) add(roadmap.poses()[pose]);
  links_ = side->links;
  for (Vertex a = 0; a < links_.size(); ++a)
    for (const Vertex b : links_[a]) sets_.unite(a, b);
}

PathSearch::Vertex PathSearch::add(const Pose& pose) {
  poses_.push_back(pose);
  points_.push_back(anchor_point(*roadmap_.certifier().manipulator(), pose));
  links_.emplace_back();
  return sets_.add();
}

/// The nearest vertices of the set of `of`, or of all others.
std::vector<PathSearch::Vertex> PathSearch::nearest(const AnchorPoint& point, std::size_t count, Vertex of,
                                                    bool in_its_set) {
  std::vector<std::pair<double, Vertex>> found;
  for (Vertex i = 0; i < poses_.size(); ++i)
    if (joined(i, of) == in_its_set) found.emplace_back((points_[i] - point).squaredNorm(), i);
  count = std::min(count, found.size());
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count), found.end());
  std::vector<Vertex> vertices;
  for (std::size_t i = 0; i < count; ++i) vertices.push_back(found[i].second);
  return vertices;
}

bool PathSearch::link(Vertex a, Vertex b) {
  if (joined(a, b)) return true;
  if (roadmap_.certifier().prove(poses_[a], poses_[b], mode_, max_parts_of_a_segment).verdict !=
      SegmentVerdict::free)
    return false;
  links_[a].push_back(b);
  links_[b].push_back(a);
  sets_.unite(a, b);
  return true;
}

void PathSearch::attach(Vertex vertex, std::size_t tries) {
  for (const Vertex other : nearest(points_[vertex], tries, vertex, false)) link(vertex, other);
}

/// Grows the sets of both ends in turn towards random poses, as far as the path is proved, and tries to join
/// what is new to the rest.
void PathSearch::explore(Vertex from, Vertex to, std::size_t most_draws) {
  const RoadmapOptions& options = roadmap_.options();
  const SegmentCertifier& certifier = roadmap_.certifier();
  PoseSampler sampler(certifier.manipulator(), options.seed + 1, options.region, options.largest_rotation);
  for (std::size_t i = 0; i < most_draws && !joined(from, to); ++i, std::swap(from, to)) {
    const auto target = sampler.draw();
    if (!target) continue;
    const AnchorPoint point = anchor_point(*certifier.manipulator(), *target);
    const Vertex near = nearest(point, 1, from, true).front();
    const SegmentProof proof = certifier.prove_start(poses_[near], *target, mode_, max_parts_of_a_segment);
    const double kept = proof.verdict == SegmentVerdict::free ? 1.0 : share_kept * proof.free_until;
    if (kept < shortest_path) continue;
    const Vertex reached = add(pose_between(certifier.manipulator()->motions(), poses_[near], *target, kept));
    if (link(near, reached)) attach(reached, tries_to_join);
  }
}

std::vector<PathSearch::Vertex> PathSearch::path(Vertex from, Vertex to) const {
  constexpr Vertex none = std::numeric_limits<Vertex>::max();
  std::vector<Vertex> before(poses_.size(), none), open{from};
  before[from] = from;
  for (std::size_t next = 0; next < open.size() && before[to] == none; ++next)
    for (const Vertex other : links_[open[next]])
      if (before[other] == none) {
        before[other] = open[next];
        open.push_back(other);
      }
  std::vector<Vertex> vertices{to};
  while (vertices.back() != from) vertices.push_back(before[vertices.back()]);
  std::reverse(vertices.begin(), vertices.end());
  return vertices;
}

/// Leaves out poses where the segment past them is proved.
std::vector<Pose> PathSearch::without_detours(const std::vector<Vertex>& vertices) const {
  std::vector<Pose> path{poses_[vertices.front()]};
  for (std::size_t at = 0; at + 1 < vertices.size();) {
    std::size_t next = vertices.size() - 1;
    while (next > at + 1 &&
           roadmap_.certifier()
                   .prove(poses_[vertices[at]], poses_[vertices[next]], mode_, max_parts_of_a_segment)
                   .verdict != SegmentVerdict::free)
      --next;
    path.push_back(poses_[vertices[next]]);
    at = next;
  }
  return path;
}

std::vector<Pose> PathSearch::find(const Pose& from, const Pose& to, SearchEffort effort) {
  const Vertex first = add(from), last = add(to);
  if (!link(first, last)) {
    attach(first, tries_to_attach);
    attach(last, tries_to_attach);
    explore(first, last, effort == SearchEffort::brief ? draws_in_brief : most_draws_at_all);
  }
  if (!joined(first, last)) return {};
  return without_detours(path(first, last));
}

}  // namespace parallel_aspects
