// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/pose_graph.h"

#include "motion/plan/path_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>

namespace parallel_aspects {
namespace {

constexpr std::size_t nearest_wanted = 16;
constexpr int most_searches = 60;  // of which a segment is not proved

}  // namespace

PoseGraph::PoseGraph(const PoseRoadmap& roadmap, const RoadmapSide& side, const Pose& from, const Pose& to,
                     const SegmentsInMode& segments)
    : segments_(segments), poses_{from, to} {
  for (const std::uint32_t pose : side.poses) poses_.push_back(roadmap.poses()[pose]);
  for (const Pose& pose : poses_) {
    points_.push_back(anchor_point(segments.robot, pose));
    indices_.push_back(index_at(segments.robot, pose, segments.mode));
  }
  beside_.resize(poses_.size());
}

/// Those that have it among their nearest are left out but for the goal, which is beside all.
const std::vector<PoseGraph::Vertex>& PoseGraph::beside(Vertex vertex) {
  std::vector<Vertex>& nearest = beside_[vertex];
  if (!nearest.empty()) return nearest;
  nearest.resize(poses_.size());
  std::iota(nearest.begin(), nearest.end(), Vertex{0});
  const std::size_t count = std::min(nearest_wanted + 1, nearest.size());
  std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count), nearest.end(),
                    [&](Vertex a, Vertex b) { return distance(vertex, a) < distance(vertex, b); });
  nearest.resize(count);
  nearest.erase(std::remove(nearest.begin(), nearest.end(), vertex), nearest.end());
  if (std::find(nearest.begin(), nearest.end(), goal) == nearest.end()) nearest.push_back(goal);
  return nearest;
}

/// By falling least index, then by the distance to the goal as the crow flies.
std::vector<PoseGraph::Vertex> PoseGraph::search(double wanted_index) {
  using Open = std::tuple<double, double, Vertex>;  // width, minus the bound of the length, vertex
  const double infinite = std::numeric_limits<double>::infinity();
  std::vector<double> width(poses_.size(), -1.0), cost(poses_.size(), infinite);
  std::vector<Vertex> before(poses_.size(), start);
  std::vector<bool> is_done(poses_.size(), false);
  const auto width_at = [&](Vertex vertex) {
    return wanted_index > 0.0 ? std::floor(index_steps * std::min(1.0, indices_[vertex] / wanted_index))
                              : index_steps;
  };
  std::priority_queue<Open> open;
  width[start] = index_steps, cost[start] = 0.0;
  open.emplace(width[start], -distance(start, goal), start);
  while (!open.empty() && !is_done[goal]) {
    const Vertex at = std::get<2>(open.top());
    open.pop();
    if (is_done[at]) continue;
    is_done[at] = true;
    for (const Vertex next : beside(at)) {
      if (is_done[next] || barred_.count(std::minmax(at, next)) > 0) continue;
      const double least = std::min(width[at], width_at(next)), length = cost[at] + distance(at, next);
      if (least < width[next] || (least == width[next] && !(length < cost[next]))) continue;
      width[next] = least, cost[next] = length, before[next] = at;
      open.emplace(least, -length - distance(next, goal), next);
    }
  }
  if (!is_done[goal]) return {};
  std::vector<Vertex> path{goal};
  while (path.back() != start) path.push_back(before[path.back()]);
  std::reverse(path.begin(), path.end());
  return path;
}

bool PoseGraph::is_proved(const std::vector<Vertex>& path) {
  bool all = true;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const auto edge = std::minmax(path[i], path[i + 1]);
    if (proved_.count(edge) > 0) continue;
    const bool is_free = segments_.is_free(poses_[path[i]], poses_[path[i + 1]]);
    (is_free ? proved_ : barred_).insert(edge);
    all = all && is_free;
  }
  return all;
}

std::vector<Pose> PoseGraph::find(double wanted_index) {
  for (int i = 0; i < most_searches; ++i) {
    const std::vector<Vertex> path = search(wanted_index);
    if (path.empty()) return {};
    if (!is_proved(path)) continue;
    std::vector<Pose> poses;
    for (const Vertex vertex : path) poses.push_back(poses_[vertex]);
    return poses;
  }
  return {};
}

}  // namespace parallel_aspects
