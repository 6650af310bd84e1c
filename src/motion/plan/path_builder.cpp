// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/path_builder.h"

#include "model/angles.h"
#include "motion/roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr int steps_of_a_segment = 32;  // at which the actuated joints are examined

}  // namespace

PlannedPath without_path(SameAspect answer, std::string message) {
  PlannedPath path;
  path.answer = answer;
  path.message = std::move(message);
  return path;
}

void PathBuilder::go(const std::vector<Pose>& poses, const WorkingMode& mode) {
  for (const Pose& pose : poses) add(pose, mode);
}

void PathBuilder::cross_serial(std::size_t leg, int from, int to) {
  const std::size_t point = path_.points.size() - 1;
  path_.crossings.push_back({Crossing::serial, point, point + 1, leg, from, to});
}

void PathBuilder::cross_parallel(const std::vector<Pose>& poses, const WorkingMode& mode, int from, int to) {
  const std::size_t point = path_.points.size() - 1;
  go(poses, mode);
  path_.crossings.push_back({Crossing::parallel, point, path_.points.size() - 1, 0, from, to});
}

PlannedPath PathBuilder::take(std::string message) {
  path_.answer = SameAspect::yes;
  path_.message = std::move(message);
  return std::exchange(path_, {});
}

void PathBuilder::add(const Pose& pose, const WorkingMode& mode) {
  if (path_.points.empty()) {
    path_.points.push_back({pose, mode, inverse(robot_, pose, mode).q});
    look_at(pose, path_.points.back().q);
    return;
  }
  const PathPoint last = path_.points.back();
  if (last.mode == mode && last.pose.position == pose.position &&
      last.pose.orientation.coeffs() == pose.orientation.coeffs())
    return;
  JointVector q = last.q;
  Pose before = last.pose;
  for (int step = 1; step <= steps_of_a_segment; ++step) {
    const Pose at = between_(last.pose, pose, static_cast<double>(step) / steps_of_a_segment);
    q += joint_change(robot_, q, inverse(robot_, at, mode).q);
    look_at(at, q);
    path_.length += (at.position - before.position).norm();
    path_.turned += at.orientation.angularDistance(before.orientation);
    before = at;
  }
  path_.points.push_back({pose, mode, q});
}

void PathBuilder::look_at(const Pose& pose, const JointVector& q) {
  path_.least_index = std::min(path_.least_index, parallel_index(robot_, pose, q));
  path_.least_det_a = std::min(path_.least_det_a, std::abs(direct_determinant(robot_, pose, q)));
}

PlannedPath begun_at(const std::optional<JointVector>& q, const Manipulator& manipulator, PlannedPath path) {
  if (!q || path.points.empty()) return path;
  const JointVector first = path.points.front().q;
  JointVector turns = JointVector::Zero(first.size());
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const Leg& leg = manipulator.leg(j);
    const auto k = static_cast<Eigen::Index>(j);
    if (leg.actuated_by_angle() && !leg.limits.limited())
      turns[k] = full_turn * std::round(((*q)[k] - first[k]) / full_turn);
  }
  for (PathPoint& point : path.points) point.q += turns;
  return path;
}

namespace {

constexpr double rounding =
    1e-6;  // of lengths and turns that are summed along a path; angles of small turns are rough

bool look_the_same(const PlannedPath& a, const PlannedPath& b) {
  return a.points.size() == b.points.size() && a.length == b.length && a.turned == b.turned &&
         a.least_index == b.least_index && a.least_det_a == b.least_det_a;
}

}  // namespace

void BestPath::offer(PlannedPath path) {
  if (!path || (best_ && look_the_same(path, best_))) return;
  const Cost its_cost = cost(path);
  if (best_ && !(its_cost < best_cost_)) return;
  best_ = std::move(path);
  best_cost_ = its_cost;
}

BestPath::Cost BestPath::cost(const PlannedPath& path) const {
  const double length = path.length + robot_.characteristic_length() * path.turned;
  switch (wish_.prefer) {
    case PathPreference::shortest:
    case PathPreference::quick:
      return {length, 0.0};
    case PathPreference::clear:
      return {-path.least_index, length};
    case PathPreference::fast:
      break;
  }
  return {wish_.time ? wish_.time(path) : length, length};
}

bool is_straight(const PlannedPath& path) {
  if (!path || !path.crossings.empty()) return false;
  const Pose &from = path.points.front().pose, &to = path.points.back().pose;
  const double shortest = (to.position - from.position).norm(),
               least_turn = from.orientation.angularDistance(to.orientation);
  return path.length <= shortest + rounding * (shortest + from.position.norm()) &&
         path.turned <= least_turn + rounding;
}

std::vector<PathShape> shapes_for(PathPreference preference) {
  if (preference == PathPreference::quick) return {short_shape};
  return {short_shape, {true, 0.0}, {true, 0.5}, clear_shape};
}

}  // namespace parallel_aspects
