// SPDX-License-Identifier: BSD-3-Clause
#include "motion/roadmap.h"

#include "parallel_aspects/singularity/indices.h"
#include "parallel_aspects/tracking/tracker.h"
#include "tracking/continuation.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr std::size_t neighbours_wanted = 12;

double distance(const Manipulator& manipulator, const Pose& a, const Pose& b) {
  double longest = 0.0;
  for (const Leg& leg : manipulator.legs())
    longest = std::max(longest, (a.transform(leg.anchor) - b.transform(leg.anchor)).norm());
  return longest;
}

}  // namespace

JointVector joint_change(const Manipulator& manipulator, const JointVector& from, const JointVector& to) {
  JointVector change = to - from;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    double& entry = change[static_cast<Eigen::Index>(j)];
    const Leg& leg = manipulator.leg(j);
    if (leg.actuated_by_angle() && !leg.limits.limited()) entry = std::remainder(entry, 2.0 * EIGEN_PI);
  }
  return change;
}

bool straight_motions_are_allowed(const Manipulator& manipulator) {
  ConstraintKinds kinds = manipulator.constraint_kinds();
  kinds[index_of(ConstraintKind::actuated_limits)] = false;
  return kinds.none();
}

int steps_of_one_sample() noexcept { return TrackerOptions().max_steps / 2; }

bool straight_motion_exists(const Manipulator& manipulator, const Place& from, const JointVector& change,
                            const Pose& to, int max_steps) {
  const PoseCertifier certifier(manipulator);
  CertifiedPoint start;
  if (!certify_solution(certifier, from.pose, from.q, start)) return false;
  Continuation path(certifier, start, from.q + change);
  return path.run(max_steps) == ContinuationStatus::finished &&
         distance(manipulator, path.at().pose, to) < 1e-6 * manipulator.size();
}

std::size_t Roadmap::add(const Place& place) {
  places_.push_back(place);
  const double value = singularity_indices(manipulator_, place.pose, place.q).smallest_singular_value;
  narrowness_.push_back(1.0 / std::max(value, 1e-6));
  neighbours_.clear();
  return places_.size() - 1;
}

void Roadmap::connect() {
  neighbours_.assign(places_.size(), {});
  std::vector<std::pair<double, std::size_t>> others;
  for (std::size_t a = 0; a < places_.size(); ++a) {
    others.clear();
    for (std::size_t b = 0; b < places_.size(); ++b)
      if (b != a) others.emplace_back(joint_change(manipulator_, places_[a].q, places_[b].q).norm(), b);
    const std::size_t count = std::min(neighbours_wanted, others.size());
    std::partial_sort(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(count), others.end());
    for (std::size_t i = 0; i < count; ++i) {
      neighbours_[a].push_back(others[i].second);
      neighbours_[others[i].second].push_back(a);
    }
  }
}

double Roadmap::cost(std::size_t a, std::size_t b) const {
  const double length = joint_change(manipulator_, places_[a].q, places_[b].q).norm();
  return length * (narrowness_[a] + narrowness_[b]);
}

std::vector<std::size_t> Roadmap::cheapest(std::size_t from, std::size_t to) const {
  ShortestPaths<double> paths;
  paths.enter(from, no_graph_node, 0.0);
  std::size_t at = paths.take();
  for (; at != no_graph_node && at != to; at = paths.take())
    for (const std::size_t next : neighbours_[at])
      if (!motions_.is_barred(at, next)) paths.enter(next, at, paths.cost(at) + cost(at, next));
  return paths.path_to(at);
}

bool Roadmap::is_passable(std::size_t a, std::size_t b) const {
  const JointVector change = joint_change(manipulator_, places_[a].q, places_[b].q);
  return straight_motion_exists(manipulator_, places_[a], change, places_[b].pose, max_steps_);
}

std::vector<std::size_t> Roadmap::path(std::size_t from, std::size_t to) {
  if (neighbours_.empty()) connect();
  while (true) {
    std::vector<std::size_t> path = cheapest(from, to);
    if (motions_.hold(path, [this](std::size_t a, std::size_t b) { return is_passable(a, b); })) return path;
  }
}

}  // namespace parallel_aspects
