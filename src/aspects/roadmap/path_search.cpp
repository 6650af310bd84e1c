// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/roadmap/path_search.h"

#include "aspects/roadmap/pose_sampler.h"

#include <algorithm>
#include <limits>

namespace parallel_aspects {
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
    const Vertex reached = add(pose_between(poses_[near], *target, kept));
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
std::vector<Pose> PathSearch::shortened(const std::vector<Vertex>& vertices) const {
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
  return shortened(path(first, last));
}

}  // namespace parallel_aspects
