// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/gate_route.h"

#include "aspects/constraints/serial_margin.h"
#include "motion/plan/leaf_path.h"
#include "motion/shortest_paths.h"

#include <algorithm>
#include <limits>

namespace parallel_aspects {
namespace {

// The cost of a change of the working mode, over the size of the robot.
constexpr double cost_of_crossing = 0.1;

// The cost of a loss of control of the platform, likewise.
constexpr double cost_of_lost_control = 100.0;

/// A*, by the distance to the goal as the crow flies, over the places where a gate or an end lies in an
/// aspect: stretches lead from a start or from behind a gate to a goal or to before a gate.
class RouteSearch {
 public:
  RouteSearch(const AspectMap& map, const AspectGraph& graph, const std::vector<PoseInAspect>& starts,
              const std::vector<PoseInAspect>& goals, const GateChoice& choice, const BarredStretches& barred)
      : robot_(*map.manipulator()), goals_(goals), barred_(barred), ends_in_aspect_(map.aspects().size()) {
    for (std::size_t i = 0; i < starts.size(); ++i) add({starts[i], Kind::start, {i, 0}});
    for (std::size_t i = 0; i < graph.gates.size(); ++i)
      if (may_pass(graph.gates[i].crossing, choice.policy) &&
          !(graph.gates[i].crossing == Crossing::serial && has_serial_margin(robot_)))
        add_gate(map, graph.gates[i], i, choice.is_clear ? 1 : graph.gates[i].crossings.size());
    for (std::size_t i = 0; i < goals.size(); ++i) add({goals[i], Kind::goal, {i, 0}});
  }

  std::optional<GateRoute> run() {
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (places_[i].kind == Kind::start) enter(i, no_graph_node, 0.0);
    for (std::size_t at = paths_.take(); at != no_graph_node; at = paths_.take()) {
      if (places_[at].kind == Kind::goal) return route(at);
      expand(at, paths_.cost(at));
    }
    return std::nullopt;
  }

 private:
  enum class Kind { start, before_gate, behind_gate, goal };
  struct Place {
    PoseInAspect at;
    Kind kind;
    GateStep step;              // of a start or a goal, its index
    std::size_t beyond = 0;     // of a place before a gate, that behind it
    double cost_of_gate = 0.0;  // likewise
  };

  static bool may_pass(Crossing crossing, PathPolicy policy) {
    switch (policy) {
      case PathPolicy::stay:
        return false;
      case PathPolicy::serial:
        return crossing == Crossing::serial;
      case PathPolicy::any:
        break;
    }
    return true;
  }

  /// A place in either aspect for each crossing.
  void add_gate(const AspectMap& map, const Neighbours& gate, std::size_t index, std::size_t most) {
    const bool serial = gate.crossing == Crossing::serial;
    const bool first_is_positive =
        map.aspects()[static_cast<std::size_t>(gate.first - 1)].determinant_sign > 0;
    for (std::size_t i = 0; i < std::min(most, gate.crossings.size()); ++i) {
      const std::vector<Pose>& segment = gate.crossings[i].segment;
      const Pose &positive = segment.front(), &negative = serial ? segment.front() : segment.back();
      const double cost = (serial ? cost_of_crossing : cost_of_lost_control) * robot_.size();
      const PoseInAspect one{first_is_positive ? positive : negative, gate.first},
          other{first_is_positive ? negative : positive, gate.second};
      const std::size_t next = places_.size();
      add({one, Kind::before_gate, {index, i}, next + 3, cost});
      add({one, Kind::behind_gate, {index, i}});
      add({other, Kind::before_gate, {index, i}, next + 1, cost});
      add({other, Kind::behind_gate, {index, i}});
    }
  }

  void add(const Place& place) {
    if (place.kind == Kind::before_gate || place.kind == Kind::goal)
      ends_in_aspect_[static_cast<std::size_t>(place.at.aspect - 1)].push_back(places_.size());
    places_.push_back(place);
    double nearest = std::numeric_limits<double>::infinity();
    for (const PoseInAspect& goal : goals_)
      nearest = std::min(nearest, distance_between(robot_, place.at.pose, goal.pose));
    to_goal_.push_back(nearest);
  }

  void expand(std::size_t at, double cost) {
    const Place& here = places_[at];
    if (here.kind == Kind::before_gate) return enter(here.beyond, at, cost + here.cost_of_gate);
    for (const std::size_t to : ends_in_aspect_[static_cast<std::size_t>(here.at.aspect - 1)])
      if (barred_.count({at, to}) == 0)
        enter(to, at, cost + distance_between(robot_, here.at.pose, places_[to].at.pose));
  }

  void enter(std::size_t place, std::size_t before, double cost) {
    paths_.enter(place, before, cost, cost + to_goal_[place]);
  }

  GateRoute route(std::size_t goal) const {
    const std::vector<std::size_t> path = paths_.path_to(goal);
    GateRoute result;
    result.start = places_[path.front()].step.gate;
    result.goal = places_[goal].step.gate;
    for (std::size_t i = 1; i < path.size(); ++i)
      if (places_[path[i]].kind == Kind::behind_gate)
        result.steps.push_back(places_[path[i]].step);
      else
        result.stretches.emplace_back(path[i - 1], path[i]);
    return result;
  }

  const Manipulator& robot_;
  const std::vector<PoseInAspect>& goals_;
  const BarredStretches& barred_;
  std::vector<std::vector<std::size_t>> ends_in_aspect_;  // where stretches end, by id - 1
  std::vector<Place> places_;
  std::vector<double> to_goal_;  // as the crow flies
  ShortestPaths<double> paths_;
};

}  // namespace

std::optional<GateRoute> find_gate_route(const AspectMap& map, const AspectGraph& graph,
                                         const std::vector<PoseInAspect>& starts,
                                         const std::vector<PoseInAspect>& goals, const GateChoice& choice,
                                         const BarredStretches& barred) {
  return RouteSearch(map, graph, starts, goals, choice, barred).run();
}

}  // namespace parallel_aspects
