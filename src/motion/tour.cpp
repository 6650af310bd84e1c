// SPDX-License-Identifier: BSD-3-Clause
#include "motion/tour.h"

#include "motion/roadmap.h"
#include "parallel_aspects/kinematics/inverse.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_places = 600;    // of one roadmap
constexpr std::size_t max_leaves = 20000;  // looked at in one aspect
constexpr std::size_t max_gates = 8;       // tried from one aspect to another

/// A pose on either side of a serial singularity of one leg: actuated joints q_before in one aspect, q_after
/// in the other.
struct Gate {
  int to = 0;
  Place before, after;
  double width = 0.0;  // how far the actuated joint moves [rad or m]
};

struct Country {
  std::unique_ptr<Roadmap> roads;
  std::size_t deepest = 0;
  std::vector<Gate> gates;  // at most one to each other aspect
};

class TourPlanner {
 public:
  explicit TourPlanner(const AspectMap& map) : map_(map), robot_(*map.manipulator()) {}

  Tour plan(const Pose& start, const WorkingMode& mode) {
    if (!straight_motions_are_allowed(robot_)) return {};
    const InverseSolution solution = inverse(robot_, start, mode);
    const Location location = map_.locate(start, mode);
    if (solution.status != InverseStatus::solved || location.status != LocationStatus::inside) return {};
    tour_.joint_values = {solution.q};
    const std::size_t here = country(location.aspect).roads->add({start, solution.q});
    visit(location.aspect, here);
    return std::move(tour_);
  }

 private:
  // Goes everywhere from here that was not yet visited, and comes back to `entry`.
  void visit(int aspect, std::size_t entry) {
    visited_.insert(aspect);
    tour_.aspects.push_back(aspect);
    Country& here = country(aspect);
    std::size_t at = entry;
    if (go(aspect, at, here.deepest)) at = here.deepest;
    for (const Gate& gate : here.gates) {
      if (visited_.count(gate.to) > 0) continue;
      const std::size_t exit = here.roads->add(gate.before);
      if (!go(aspect, at, exit)) continue;
      at = exit;
      pass(gate.before, gate.after);
      visit(gate.to, country(gate.to).roads->add(gate.after));
      pass(gate.after, gate.before);
      tour_.aspects.push_back(aspect);
    }
    go(aspect, at, entry);
  }

  bool go(int aspect, std::size_t from, std::size_t to) {
    Roadmap& roads = *country(aspect).roads;
    const auto path = roads.path(from, to);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) pass(roads.place(path[i]), roads.place(path[i + 1]));
    return !path.empty();
  }

  void pass(const Place& from, const Place& to) {
    tour_.joint_values.push_back(tour_.joint_values.back() + joint_change(robot_, from.q, to.q));
  }

  Country& country(int aspect) {
    Country& found = countries_[aspect];
    if (!found.roads) explore(map_.aspects()[static_cast<std::size_t>(aspect - 1)], found);
    return found;
  }

  void explore(const Aspect& aspect, Country& country) const {
    std::vector<std::pair<double, Place>> places;
    std::map<int, std::vector<Gate>> gates;
    const std::size_t stride = 1 + aspect.inside_leaves / max_leaves;
    std::size_t leaf = 0;
    map_.visit_inside_poses(aspect.id, [&](const Pose& pose, double measure) {
      if (leaf++ % stride != 0) return;
      const InverseSolution solution = inverse(robot_, pose, aspect.mode);
      if (solution.status != InverseStatus::solved) return;
      const Place place{pose, solution.q};
      places.emplace_back(measure, place);
      add_gates(place, aspect, gates);
    });
    std::stable_sort(places.begin(), places.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    if (places.size() > max_places) places.resize(max_places);
    country.roads = std::make_unique<Roadmap>(robot_);
    for (const auto& sized : places) country.roads->add(sized.second);
    country.deepest = country.roads->add({aspect.deepest, inverse(robot_, aspect.deepest, aspect.mode).q});
    for (auto& [to, candidates] : gates)
      if (const auto gate = open_gate(std::move(candidates))) country.gates.push_back(*gate);
  }

  // The same pose with one leg in its other posture.
  void add_gates(const Place& place, const Aspect& aspect, std::map<int, std::vector<Gate>>& gates) const {
    for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
      WorkingMode mode = aspect.mode;
      mode.set_sign(j, -mode.sign(j));
      if (!robot_.leg(j).has_branch(mode.sign(j))) continue;
      const Location found = map_.locate(place.pose, mode);
      if (found.status != LocationStatus::inside) continue;
      const Aspect& other = map_.aspects()[static_cast<std::size_t>(found.aspect - 1)];
      if (other.determinant_sign != aspect.determinant_sign) continue;
      const Place after{place.pose, inverse(robot_, place.pose, mode).q};
      gates[found.aspect].push_back(
          {found.aspect, place, after, joint_change(robot_, place.q, after.q).norm()});
    }
  }

  // The narrowest gate that the robot can be proved to pass.
  std::optional<Gate> open_gate(std::vector<Gate> candidates) const {
    const std::size_t count = std::min(max_gates, candidates.size());
    std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(count),
                      candidates.end(), [](const Gate& a, const Gate& b) { return a.width < b.width; });
    for (std::size_t i = 0; i < count; ++i) {
      const Gate& gate = candidates[i];
      const JointVector change = joint_change(robot_, gate.before.q, gate.after.q);
      if (straight_motion_exists(robot_, gate.before, change, gate.after.pose)) return gate;
    }
    return std::nullopt;
  }

  const AspectMap& map_;
  const Manipulator& robot_;
  std::map<int, Country> countries_;
  std::set<int> visited_;
  Tour tour_;
};

}  // namespace

Tour plan_tour(const AspectMap& map, const Pose& start, const WorkingMode& mode) {
  return TourPlanner(map).plan(start, mode);
}

}  // namespace parallel_aspects
