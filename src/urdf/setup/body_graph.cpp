// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/body_graph.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <queue>

namespace parallel_aspects {
namespace {

constexpr std::size_t unreached = std::numeric_limits<std::size_t>::max();

}  // namespace

Bodies::Bodies(const Tree& tree) : body_(tree.links.size(), 0), links_{{0}} {
  for (const TreeJoint& joint : tree.joints) {
    if (!joint.variable) {
      body_[joint.child] = body_[joint.parent];
    } else {
      body_[joint.child] = links_.size();
      links_.emplace_back();
    }
    links_[body_[joint.child]].push_back(joint.child);
  }
}

BodyGraph::BodyGraph(const Tree& tree, const Bodies& bodies, const std::vector<Closure>& closures)
    : bodies_(bodies), in_loop_(static_cast<std::size_t>(tree.variables()), false) {
  carrier_.assign(bodies.count(), 0);
  std::vector<int> crossings(bodies.count(), 0);
  for (const TreeJoint& joint : tree.joints)
    if (joint.variable) carrier_[bodies.of(joint.child)] = bodies.of(joint.parent);
  for (const Closure& closure : closures) {
    std::fill(crossings.begin(), crossings.end(), 0);
    for (const LinkFrame& frame : closure.frames)
      for (std::size_t body = bodies.of(frame.link); body != 0; body = carrier_[body]) ++crossings[body];
    for (const TreeJoint& joint : tree.joints)
      if (joint.variable && crossings[bodies.of(joint.child)] == 1) in_loop_[*joint.variable] = true;
    edges_.push_back({bodies.of(closure.frames[0].link), bodies.of(closure.frames[1].link), std::nullopt});
  }
  for (const TreeJoint& joint : tree.joints)
    if (joint.variable && in_loop_[*joint.variable])
      edges_.push_back({bodies.of(joint.parent), bodies.of(joint.child), joint.variable});
}

bool BodyGraph::touches_loop(std::size_t body) const {
  return std::any_of(edges_.begin(), edges_.end(),
                     [body](const Edge& edge) { return edge.from == body || edge.to == body; });
}

std::optional<std::size_t> BodyGraph::base() const {
  // Bodies nearer to the root have lower numbers on each way.
  for (std::size_t body = 0; body < bodies_.count(); ++body)
    if (touches_loop(body)) return body;
  return std::nullopt;
}

std::vector<std::size_t> BodyGraph::moving_bodies(std::size_t base) const {
  std::vector<std::size_t> result;
  for (std::size_t body = 0; body < bodies_.count(); ++body)
    if (body != base && touches_loop(body)) result.push_back(body);
  return result;
}

std::vector<std::size_t> BodyGraph::depths_from(std::size_t base, std::size_t platform) const {
  std::vector<std::size_t> depths(bodies_.count(), unreached);
  std::queue<std::size_t> open({base});
  depths[base] = 0;
  for (; !open.empty(); open.pop()) {
    const std::size_t body = open.front();
    if (body == platform) continue;
    for (const Edge& edge : edges_)
      for (const auto& [from, to] : {std::pair{edge.from, edge.to}, std::pair{edge.to, edge.from}})
        if (from == body && depths[to] == unreached) {
          depths[to] = depths[body] + 1;
          open.push(to);
        }
  }
  return depths;
}

GraphPart BodyGraph::part_of(std::vector<std::size_t> edges, const std::vector<std::size_t>& depths) const {
  const auto depth = [&](std::size_t edge) {
    return std::min(depths[edges_[edge].from], depths[edges_[edge].to]);
  };
  std::stable_sort(edges.begin(), edges.end(),
                   [&](std::size_t one, std::size_t other) { return depth(one) < depth(other); });
  GraphPart part;
  for (const std::size_t edge : edges) {
    if (!edges_[edge].variable) {
      part.closed = true;
      continue;
    }
    part.variables.push_back(*edges_[edge].variable);
    part.depths.push_back(depth(edge));
  }
  return part;
}

std::vector<std::size_t> BodyGraph::marks_without(std::size_t base, std::size_t platform) const {
  std::vector<std::size_t> mark(bodies_.count());
  std::iota(mark.begin(), mark.end(), std::size_t{0});
  for (const Edge& edge : edges_)
    if (edge.from != base && edge.from != platform && edge.to != base && edge.to != platform)
      std::replace(mark.begin(), mark.end(), std::size_t{mark[edge.from]}, std::size_t{mark[edge.to]});
  return mark;
}

bool BodyGraph::any_at(const std::vector<std::size_t>& edges, std::size_t body) const {
  return std::any_of(edges.begin(), edges.end(),
                     [&](std::size_t k) { return edges_[k].from == body || edges_[k].to == body; });
}

std::vector<GraphPart> BodyGraph::parts_between(std::size_t base, std::size_t platform) const {
  const std::vector<std::size_t> mark = marks_without(base, platform);
  const auto is_end = [&](std::size_t body) { return body == base || body == platform; };
  std::map<std::size_t, std::vector<std::size_t>> edges_by_mark;
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const std::size_t inner = is_end(edges_[k].from) ? edges_[k].to : edges_[k].from;
    edges_by_mark[is_end(inner) ? bodies_.count() + k : mark[inner]].push_back(k);
  }
  const std::vector<std::size_t> depths = depths_from(base, platform);
  std::vector<GraphPart> parts;
  for (const auto& [key, edges] : edges_by_mark)
    if (any_at(edges, base) && any_at(edges, platform)) parts.push_back(part_of(edges, depths));
  // Legs in the order of the URDF.
  std::sort(parts.begin(), parts.end(),
            [](const GraphPart& one, const GraphPart& other) { return one.variables < other.variables; });
  return parts;
}

std::size_t closed_again(const Bodies& bodies, const std::vector<Closure>& closures,
                         const std::vector<Closure>& others) {
  const auto pair_of = [&](const Closure& closure) {
    return std::minmax({bodies.of(closure.frames[0].link), bodies.of(closure.frames[1].link)});
  };
  return static_cast<std::size_t>(std::count_if(closures.begin(), closures.end(), [&](const Closure& one) {
    return std::any_of(others.begin(), others.end(),
                       [&](const Closure& other) { return pair_of(one) == pair_of(other); });
  }));
}

}  // namespace parallel_aspects
