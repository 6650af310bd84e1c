// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/roadmap_paths.h"

#include "aspects/constraints/serial_margin.h"
#include "aspects/roadmap/pose_sampler.h"
#include "motion/plan/leaf_path.h"
#include "motion/plan/path_shape.h"
#include "motion/roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/motion/check_trajectory.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

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
const std::vector<std::size_t>& PoseGraph::beside(std::size_t vertex) {
  std::vector<std::size_t>& nearest = beside_[vertex];
  if (!nearest.empty()) return nearest;
  nearest.resize(poses_.size());
  std::iota(nearest.begin(), nearest.end(), std::size_t{0});
  const std::size_t count = std::min(nearest_wanted + 1, nearest.size());
  std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count), nearest.end(),
                    [&](std::size_t a, std::size_t b) { return distance(vertex, a) < distance(vertex, b); });
  nearest.resize(count);
  nearest.erase(std::remove(nearest.begin(), nearest.end(), vertex), nearest.end());
  if (std::find(nearest.begin(), nearest.end(), goal) == nearest.end()) nearest.push_back(goal);
  return nearest;
}

/// By falling least index, then by the distance to the goal as the crow flies.
std::vector<std::size_t> PoseGraph::search(double wanted_index) {
  const auto width_at = [&](std::size_t vertex) {
    return wanted_index > 0.0 ? std::floor(index_steps * std::min(1.0, indices_[vertex] / wanted_index))
                              : index_steps;
  };
  ShortestPaths<WidthAndLength> paths;
  paths.enter(start, no_graph_node, {index_steps, 0.0});
  std::size_t at = paths.take();
  for (; at != no_graph_node && at != goal; at = paths.take()) {
    const auto [width, length] = paths.cost(at);
    for (const std::size_t next : beside(at)) {
      if (paths.is_taken(next) || edges_.is_barred(at, next)) continue;
      const WidthAndLength cost{std::min(width, width_at(next)), length + distance(at, next)};
      paths.enter(next, at, cost, {cost.width, cost.length + distance(next, goal)});
    }
  }
  return paths.path_to(at);
}

std::vector<Pose> PoseGraph::find(double wanted_index) {
  const auto prove = [this](std::size_t a, std::size_t b) { return segments_.is_free(poses_[a], poses_[b]); };
  for (int i = 0; i < most_searches; ++i) {
    const std::vector<std::size_t> path = search(wanted_index);
    if (!edges_.hold(path, prove)) continue;
    std::vector<Pose> poses;
    for (const std::size_t vertex : path) poses.push_back(poses_[vertex]);
    return poses;
  }
  return {};
}

namespace {

constexpr std::size_t bases_of_a_side = 12;  // poses that it is looked from
constexpr std::size_t targets_of_a_base = 24;
constexpr std::size_t most_proofs = 40;
constexpr int steps_of_a_look = 32, halvings_of_a_look = 30;
constexpr double share_of_outer = 0.9;  // of the way to where the leg stops reaching
constexpr double share_beyond = 1.001;  // likewise

}  // namespace

WorkingMode with_other_posture(const WorkingMode& mode, std::size_t leg) {
  WorkingMode other = mode;
  other.set_sign(leg, -mode.sign(leg));
  return other;
}

/// The start, and poses of the side that are near to it or to the goal.
std::vector<Pose> RoadmapGates::bases(const PoseInMode& from, const Pose& to, int sign) const {
  std::vector<Pose> result{from.pose};
  const Manipulator& robot = *roadmap_.certifier().manipulator();
  if (const RoadmapSide* side = roadmap_.side(from.mode, sign)) {
    std::vector<std::pair<double, std::uint32_t>> near;
    for (const std::uint32_t i : side->poses) {
      const Pose& pose = roadmap_.poses()[i];
      near.emplace_back(distance_between(robot, from.pose, pose) + distance_between(robot, pose, to), i);
    }
    std::sort(near.begin(), near.end());
    for (std::size_t i = 0; i < std::min(bases_of_a_side, near.size()); ++i)
      result.push_back(roadmap_.poses()[near[i].second]);
  }
  return result;
}

bool RoadmapGates::find_end(const PoseInMode& base, const Pose& target, int sign, Candidate& found) const {
  const Manipulator& robot = *roadmap_.certifier().manipulator();
  std::size_t leg = 0;
  const auto reaches = [&](double t) {
    const InverseSolution solution =
        inverse(robot, pose_between(robot.motions(), base.pose, target, t), base.mode);
    leg = solution.leg;
    return solution.status;
  };
  double good = 0.0, bad = 0.0;
  for (int k = 1; k <= steps_of_a_look && bad == 0.0; ++k) {
    const double t = static_cast<double>(k) / steps_of_a_look;
    const Pose pose = pose_between(robot.motions(), base.pose, target, t);
    const InverseSolution solution = inverse(robot, pose, base.mode);
    if (solution.status == InverseStatus::out_of_reach)
      bad = t;
    else if (!solution || !(sign * direct_determinant(robot, pose, solution.q) > 0.0))
      return false;
    else
      good = t;
  }
  if (bad == 0.0) return false;
  for (int k = 0; k < halvings_of_a_look; ++k) {
    const double middle = 0.5 * (good + bad);
    (reaches(middle) == InverseStatus::out_of_reach ? bad : good) = middle;
  }
  if (reaches(bad) != InverseStatus::out_of_reach) return false;
  found.leg = leg;
  found.outer = pose_between(robot.motions(), base.pose, target, share_of_outer * bad);
  found.beyond = pose_between(robot.motions(), base.pose, target, std::min(1.0, share_beyond * bad));
  return true;
}

/// A leg that passes B_jj = 0 with no other, as the check of trajectories proves it.
bool RoadmapGates::passes(const Pose& inner, const WorkingMode& before, const WorkingMode& after,
                          std::size_t leg) const {
  const SegmentCertifier& certifier = roadmap_.certifier();
  const Manipulator& robot = *certifier.manipulator();
  const InverseSolution first = inverse(robot, inner, before), last = inverse(robot, inner, after);
  if (!first || !last) return false;
  const JointVector change = joint_change(robot, first.q, last.q);
  if (!straight_motion_exists(robot, {inner, first.q}, change, inner)) return false;
  TrajectoryCheckOptions options;
  options.pass_serial = true;
  const TrajectoryCheck check = check_trajectory(
      certifier, {{0.0, first.q, {}, {}}, {1.0, first.q + change, {}, {}}}, {inner, 0}, options);
  return check.answer == TrajectoryAnswer::safe && check.crossings.size() == 1 &&
         check.crossings[0].leg == leg && check.crossings[0].mode == after;
}

bool RoadmapGates::prove(const Candidate& candidate, const WorkingMode& mode, RoadmapGate& gate) const {
  const WorkingMode other = with_other_posture(mode, candidate.leg);
  double share = 1.0;
  for (const WorkingMode& each : {mode, other}) {
    const SegmentProof proof = roadmap_.certifier().prove_to_violation(candidate.outer, candidate.beyond,
                                                                       each, width_of_turning_points);
    if (proof.violation != Violation::out_of_reach) return false;  // a constraint ends it before the leg does
    share = std::min(share, proof.free_until);
  }
  if (!(share > 0.0)) return false;
  gate = {
      candidate.leg, candidate.outer,
      pose_between(roadmap_.certifier().manipulator()->motions(), candidate.outer, candidate.beyond, share)};
  return roadmap_.certifier().prove(gate.outer, gate.inner, mode).verdict == SegmentVerdict::free &&
         roadmap_.certifier().prove(gate.outer, gate.inner, other).verdict == SegmentVerdict::free &&
         passes(gate.inner, mode, other, candidate.leg);
}

bool RoadmapGates::visit(const PoseInMode& from, const Pose& to, int sign,
                         const std::vector<std::size_t>& legs,
                         const std::function<bool(const RoadmapGate&)>& visitor) const {
  const RoadmapOptions& options = roadmap_.options();
  const auto robot = roadmap_.certifier().manipulator();
  if (has_serial_margin(*robot)) return false;
  PoseSampler sampler(robot, options.seed + 2, options.region, options.largest_rotation);
  std::vector<Candidate> candidates;
  for (const Pose& base : bases(from, to, sign))
    for (std::size_t i = 0; i < targets_of_a_base; ++i) {
      const auto target = sampler.draw();
      Candidate found;
      if (!target || !find_end({base, from.mode}, *target, sign, found)) continue;
      if (std::find(legs.begin(), legs.end(), found.leg) == legs.end()) continue;
      found.length =
          distance_between(*robot, from.pose, found.outer) + distance_between(*robot, found.outer, to);
      candidates.push_back(found);
    }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.length < b.length; });
  for (std::size_t i = 0; i < std::min(most_proofs, candidates.size()); ++i) {
    RoadmapGate gate;
    if (prove(candidates[i], from.mode, gate) && visitor(gate)) return true;
  }
  return false;
}

}  // namespace parallel_aspects
