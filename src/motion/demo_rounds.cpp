// SPDX-License-Identifier: BSD-3-Clause
#include "motion/demo_rounds.h"

#include "motion/roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int corners = 360;
constexpr double shrink = 0.8;
constexpr double margin = 0.35;  // of each index at the middle of the figure that must be left everywhere

// Whole turns of each degree of freedom in one round; all are at zero where a round begins.
constexpr std::array<int, max_legs> turns{1, 2, 3, 3, 1, 2};

class LocalPlanner {
 public:
  LocalPlanner(const Manipulator& robot, const Pose& middle, const WorkingMode& mode,
               const ConfigurationFilter& allowed)
      : robot_(robot), middle_(middle), mode_(mode), allowed_(allowed) {}

  std::vector<JointVector> plan(double widest) {
    const InverseSolution start = inverse(robot_, middle_, mode_);
    if (start.status != InverseStatus::solved || !allowed_(middle_, start.q)) return {};
    indices_ = singularity_indices(robot_, middle_, start.q);
    for (double amplitude = widest; amplitude >= narrowest_local_motion; amplitude *= shrink) {
      std::vector<JointVector> joint_values = figure({middle_, start.q}, amplitude);
      if (!joint_values.empty()) return joint_values;
    }
    return {};
  }

 private:
  std::vector<JointVector> figure(const Place& start, double amplitude) const {
    std::vector<JointVector> joint_values{start.q};
    Place at = start;
    for (int i = 1; i <= corners; ++i) {
      const auto next = place(amplitude, static_cast<double>(i) / corners);
      if (!next) return {};
      const JointVector change = joint_change(robot_, at.q, next->q);
      if (!straight_motion_exists(robot_, at, change, next->pose)) return {};
      joint_values.push_back(joint_values.back() + change);
      at = *next;
    }
    return joint_values;
  }

  std::optional<Place> place(double amplitude, double share) const {
    const auto degrees_of_freedom = static_cast<Eigen::Index>(robot_.leg_count());
    const auto rotations = static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot_.task_space()));
    TaskVector twist(degrees_of_freedom);
    for (Eigen::Index i = 0; i < degrees_of_freedom; ++i) {
      const double unit = i < rotations ? 2.0 : robot_.size();
      twist[i] = amplitude * unit * std::sin(2.0 * EIGEN_PI * turns[static_cast<std::size_t>(i)] * share);
    }
    const Pose pose = displaced(robot_.motions(), middle_, twist);
    const InverseSolution solution = inverse(robot_, pose, mode_);
    if (solution.status != InverseStatus::solved || !clear(pose, solution.q)) return std::nullopt;
    if (!allowed_(pose, solution.q)) return std::nullopt;
    return Place{pose, solution.q};
  }

  bool clear(const Pose& pose, const JointVector& q) const {
    const SingularityIndices here = singularity_indices(robot_, pose, q);
    if (here.smallest_singular_value < margin * indices_.smallest_singular_value) return false;
    for (Eigen::Index j = 0; j < here.inverse_diagonal.size(); ++j)
      if (std::abs(here.inverse_diagonal[j]) < margin * std::abs(indices_.inverse_diagonal[j])) return false;
    return true;
  }

  const Manipulator& robot_;
  const Pose middle_;
  const WorkingMode mode_;
  const ConfigurationFilter& allowed_;
  SingularityIndices indices_;  // at the middle
};

}  // namespace

std::vector<JointVector> plan_local_motion(const Manipulator& manipulator, const Pose& pose,
                                           const WorkingMode& mode, const ConfigurationFilter& allowed,
                                           double widest) {
  return LocalPlanner(manipulator, pose, mode, allowed).plan(widest);
}

namespace {

constexpr std::size_t max_places = 600;    // of one roadmap
constexpr std::size_t max_leaves = 20000;  // examined in one aspect
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

namespace {

constexpr double slowest = 8.0;  // times the duration that was asked for

// How long the actuated joints need for a straight change at least [s].
double least_time(const Manipulator& manipulator, const JointVector& change) {
  double seconds = 0.0;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    seconds = std::max(seconds,
                       std::abs(change[static_cast<Eigen::Index>(j)]) / manipulator.leg(j).limits.velocity);
  return seconds;
}

}  // namespace

SampledMotion sampled(const Manipulator& manipulator, const std::vector<JointVector>& corners,
                      double duration, double interval) {
  double length = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) length += (corners[i] - corners[i - 1]).norm();
  SampledMotion motion;
  motion.gain = corners.back() - corners.front();
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const JointVector change = corners[i] - corners[i - 1];
    if (!(change.norm() > 0.0)) continue;
    const double seconds = std::max(duration * change.norm() / length, least_time(manipulator, change));
    const double steps = std::max(1.0, std::ceil(seconds / interval));
    for (double step = 0.0; step < steps; ++step)
      motion.samples.push_back(corners[i - 1] + step / steps * change);
  }
  return motion;
}

Rehearsal::Rehearsal(std::shared_ptr<const Manipulator> manipulator, const TrackerOptions& options,
                     double interval)
    : manipulator_(std::move(manipulator)),
      tracker_(manipulator_, options),
      interval_(interval),
      offset_(JointVector::Zero(static_cast<Eigen::Index>(manipulator_->leg_count()))) {}

bool Rehearsal::start(const Pose& pose, const JointVector& q) {
  count_ = 0;
  offset_.setZero();
  tracker_.stop();
  return tracker_.start_near(0.0, q, pose, 1e-6 * manipulator_->size());
}

bool Rehearsal::play(const SampledMotion& motion) {
  Rehearsal attempt = *this;
  for (const JointVector& sample : motion.samples) {
    const double time = interval_ * static_cast<double>(++attempt.count_);
    if (!attempt.tracker_.update(time, sample + offset_).followed()) return false;
  }
  attempt.offset_ += motion.gain;
  *this = std::move(attempt);
  return true;
}

SampledMotion Rehearsal::slow_enough(const std::vector<JointVector>& corners, double duration) const {
  for (double factor = 1.0; factor <= slowest; factor *= 2.0) {
    SampledMotion motion = sampled(*manipulator_, corners, factor * duration, interval_);
    Rehearsal attempt = *this;
    if (attempt.play(motion) && attempt.play(motion)) return motion;
  }
  return {};
}

}  // namespace parallel_aspects
