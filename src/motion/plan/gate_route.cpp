// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/gate_route.h"

#include "motion/plan/leaf_path.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace parallel_aspects {
namespace {

// What a change of the working mode counts as, of the size of the robot.
constexpr double cost_of_crossing = 0.1;

/// Dijkstra over the places where a gate or an end lies in an aspect.
class RouteSearch {
 public:
  RouteSearch(const AspectMap& map, const AspectGraph& graph, const std::vector<PoseInAspect>& starts,
              const std::vector<PoseInAspect>& goals)
      : robot_(*map.manipulator()) {
    for (std::size_t i = 0; i < starts.size(); ++i) add({starts[i], Kind::start, i});
    for (std::size_t i = 0; i < graph.gates.size(); ++i) {
      const Neighbours& gate = graph.gates[i];
      if (!gate.proved || gate.crossing != Crossing::serial) continue;
      add({{gate.crossings.front().segment.front(), gate.first}, Kind::gate, i});
      add({{gate.crossings.front().segment.front(), gate.second}, Kind::gate, i});
    }
    for (std::size_t i = 0; i < goals.size(); ++i) add({goals[i], Kind::goal, i});
  }

  std::optional<GateRoute> run() {
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (places_[i].kind == Kind::start) reach(i, i, 0.0);
    while (!open_.empty()) {
      const auto [cost, at] = open_.top();
      open_.pop();
      if (cost > cost_[at]) continue;
      if (places_[at].kind == Kind::goal) return route(at);
      for (std::size_t to = 0; to < places_.size(); ++to)
        if (to != at) reach(to, at, cost + step(at, to));
    }
    return std::nullopt;
  }

 private:
  enum class Kind { start, gate, goal };
  struct Place {
    PoseInAspect at;
    Kind kind;
    std::size_t index;
  };
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  void add(const Place& place) {
    places_.push_back(place);
    cost_.push_back(infinite);
    before_.push_back(0);
  }

  double step(std::size_t from, std::size_t to) const {
    const Place &a = places_[from], &b = places_[to];
    if (a.kind == Kind::gate && b.kind == Kind::gate && a.index == b.index)
      return cost_of_crossing * robot_.size();
    if (a.at.aspect != b.at.aspect) return infinite;
    return distance_between(robot_, a.at.pose, b.at.pose);
  }

  void reach(std::size_t place, std::size_t before, double cost) {
    if (!(cost < cost_[place])) return;
    cost_[place] = cost;
    before_[place] = before;
    open_.push({cost, place});
  }

  GateRoute route(std::size_t goal) const {
    GateRoute result;
    result.goal = places_[goal].index;
    std::size_t at = goal;
    for (; places_[at].kind != Kind::start; at = before_[at]) {
      const Place &here = places_[at], &before = places_[before_[at]];
      if (here.kind == Kind::gate && before.kind == Kind::gate && here.index == before.index)
        result.gates.push_back(here.index);
    }
    result.start = places_[at].index;
    std::reverse(result.gates.begin(), result.gates.end());
    return result;
  }

  const Manipulator& robot_;
  std::vector<Place> places_;
  std::vector<double> cost_;
  std::vector<std::size_t> before_;
  using Open = std::pair<double, std::size_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

}  // namespace

std::optional<GateRoute> find_gate_route(const AspectMap& map, const AspectGraph& graph,
                                         const std::vector<PoseInAspect>& starts,
                                         const std::vector<PoseInAspect>& goals) {
  return RouteSearch(map, graph, starts, goals).run();
}

}  // namespace parallel_aspects
