// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_TRACKING_CAMPAIGN_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_TRACKING_CAMPAIGN_H

#include "kinematics/direct/direct_problem.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/tracking/tracker.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <Eigen/LU>

#include "support/robots/random_robots.h"
#include "support/round_trip.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace parallel_aspects::test {

/// What became of random motions of one robot.
struct CampaignCounts {
  long steps = 0;     ///< samples given to the tracker while it followed
  long tracked = 0;   ///< of them, those after which it named a pose
  long wrong = 0;     ///< of them, those with another pose, sign of det A or working mode than the truth
  long unjudged = 0;  ///< of them, those where the truth was not found
  std::array<long, 11> ambiguous{};  ///< the others, by `Ambiguity`
  long avoidable = 0;                ///< of those, with a truth that stays off det A = 0 by a thousandth
  long crossings_made = 0, crossings_found = 0;
  std::string first_wrong;
};

/// The truth by other means than the tracker's: Newton's method on the equations of `kinematics`, in steps so
/// short against the distance to det A = 0 that no other solution is within reach. Nothing of it is a proof;
/// nothing of it is shared with the tracker.
class FineFollower {
 public:
  FineFollower(const Manipulator& robot, const Pose& pose, const JointVector& q)
      : robot_(robot), pose_(pose), q_(q), sides_(sines()) {
    for (int& side : sides_of_) side = 0;
    for (Eigen::Index j = 0; j < sides_.size(); ++j) sides_of_[static_cast<std::size_t>(j)] = sign(sides_[j]);
  }

  const Pose& pose() const { return pose_; }
  int side(std::size_t leg) const { return sides_of_[leg]; }
  double least_singular_value() const { return least_; }

  /// Sine of the angle at each elbow, or what stands for it.
  TaskVector sines() const {
    TaskVector result = inverse_diagonal(robot_, pose_, q_);
    for (Eigen::Index j = 0; j < result.size(); ++j) {
      const Leg& leg = robot_.leg(static_cast<std::size_t>(j));
      const double rod = (pose_.transform(leg.anchor) - leg.proximal_point(q_[j])).norm();
      if (const auto* elbow = std::get_if<ElbowActuation>(&leg.actuation))
        result[j] /= elbow->inner_length * elbow->outer_length;
      else if (std::holds_alternative<StrutActuation>(leg.actuation))
        result[j] /= rod;
      else
        result[j] /= rod * leg.proximal_point_derivative(q_[j]).norm();
    }
    return result;
  }

  /// Moves the actuated joints straight to `q`. False where det A = 0 is met on the path, or too nearly.
  bool go(const JointVector& q, double hysteresis, long& crossings) {
    const JointVector start = q_;
    least_ = std::numeric_limits<double>::infinity();
    double done = 0.0, length = 1.0;
    while (done < 1.0) {
      length = std::min(length, 1.0 - done);
      const double share = done + length >= 1.0 ? 1.0 : done + length;
      if (try_step(share >= 1.0 ? q : JointVector(start + share * (q - start)))) {
        done = share;
        length *= 2.0;
        count_crossings(hysteresis, crossings);
      } else if ((length *= 0.5) < 1e-9) {
        return false;
      }
    }
    return true;
  }

 private:
  static int sign(double value) { return value < 0.0 ? -1 : 1; }

  // A step of the pose far shorter than the distance to det A = 0, which the smallest singular value
  // measures.
  bool try_step(const JointVector& q) {
    const double value = smallest_singular_value_bound(robot_, pose_, q_);
    Pose next = pose_;
    double moved = 0.0;
    for (int i = 0; i < 8; ++i) {
      const TaskVector step =
          direct_matrix(robot_, next, q).partialPivLu().solve(-0.5 * residuals(robot_, next, q));
      if (!step.allFinite()) return false;
      next = displaced(robot_.motions(), next, step);
      moved = largest_motion(next) / shortest_rod();
      if (!(moved <= 0.05 * value)) return false;
      if (step.norm() < 1e-12 * robot_.size()) {
        const double sine_step = 0.2;
        const Pose before = pose_;
        const JointVector q_before = q_;
        const TaskVector sines_before = sines();
        pose_ = next;
        q_ = q;
        if ((sines() - sines_before).cwiseAbs().maxCoeff() <= sine_step) {
          least_ = std::min(least_, value);
          return true;
        }
        pose_ = before;
        q_ = q_before;
        return false;
      }
    }
    return false;
  }

  double largest_motion(const Pose& next) const {
    double motion = 0.0;
    for (const Leg& leg : robot_.legs())
      motion = std::max(motion, (next.transform(leg.anchor) - pose_.transform(leg.anchor)).norm());
    return motion;
  }

  double shortest_rod() const {
    double rod = robot_.size();
    for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
      const Leg& leg = robot_.leg(j);
      const auto i = static_cast<Eigen::Index>(j);
      rod = std::min(rod, (pose_.transform(leg.anchor) - leg.proximal_point(q_[i])).norm());
    }
    return rod;
  }

  void count_crossings(double hysteresis, long& crossings) {
    const TaskVector now = sines();
    for (Eigen::Index j = 0; j < now.size(); ++j) {
      int& side = sides_of_[static_cast<std::size_t>(j)];
      if (std::abs(now[j]) < hysteresis || sign(now[j]) == side) continue;
      side = sign(now[j]);
      ++crossings;
    }
  }

  const Manipulator& robot_;
  Pose pose_;
  JointVector q_;
  TaskVector sides_;
  std::array<int, max_legs> sides_of_{};
  double least_ = 0.0;
};

/// Seeded random motions of a shipped robot: runs of up to 200 samples from a random pose, in steps whose
/// size is drawn anew for each run from 1e-6 to 1 (rad, or of the robot's size), the actuated joints going on
/// in one direction for a while.
class TrackingCampaign {
 public:
  TrackingCampaign(const Mechanism& mechanism, unsigned seed) : mechanism_(mechanism), random_(seed) {}

  CampaignCounts run(long steps) {
    while (counts_.steps < steps) one_run();
    return counts_;
  }

 private:
  static constexpr int longest_run = 200;
  static constexpr double same_pose = 1e-6;  // over the robot's size

  const Manipulator& robot() const { return *mechanism_.manipulator(); }

  Pose random_pose() {
    const auto turns = static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot().task_space()));
    TaskVector step(static_cast<Eigen::Index>(robot().leg_count()));
    for (Eigen::Index k = 0; k < step.size(); ++k)
      step[k] = random_.uniform(-1.0, 1.0) * (k < turns ? 0.7 : 0.3 * robot().size());
    return displaced(robot().motions(), mechanism_.assembled().pose, step);
  }

  std::optional<std::pair<Pose, JointVector>> random_start() {
    const auto modes = working_modes(robot());
    const Pose pose = random_pose();
    const auto pick = static_cast<std::size_t>(random_.uniform(0.0, static_cast<double>(modes.size())));
    const InverseSolution solution = inverse(robot(), pose, modes[std::min(pick, modes.size() - 1)]);
    if (solution.status != InverseStatus::solved) return std::nullopt;
    if (smallest_singular_value_bound(robot(), pose, solution.q) < 1e-4) return std::nullopt;
    return std::make_pair(pose, solution.q);
  }

  TaskVector random_direction(double size) {
    TaskVector direction(static_cast<Eigen::Index>(robot().leg_count()));
    for (Eigen::Index j = 0; j < direction.size(); ++j) {
      const bool angle = robot().leg(static_cast<std::size_t>(j)).actuated_by_angle();
      direction[j] = size * random_.uniform(-1.0, 1.0) * (angle ? 1.0 : robot().size());
    }
    return direction;
  }

  // Actuated joints with limits turn back at them.
  void keep_inside(const JointVector& q, TaskVector& direction) const {
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const JointLimits& limits = robot().leg(static_cast<std::size_t>(j)).limits;
      if (!limits.contain(q[j] + direction[j])) direction[j] = -direction[j];
      if (!limits.contain(q[j] + direction[j])) direction[j] = 0.0;
    }
  }

  void one_run() {
    const auto start = random_start();
    if (!start) return;
    TrackerOptions options;
    options.samples.check_velocity = false;
    options.samples.unwrap = false;  // steps of the coarsest runs are turns of their own
    Tracker tracker(mechanism_.manipulator(), options);
    if (!tracker.start_near(0.0, start->second, start->first, 1e-6 * robot().size())) return;
    FineFollower truth(robot(), start->first, start->second);
    const double size = std::pow(10.0, random_.uniform(-6.0, 0.0));
    TaskVector direction = random_direction(size);
    JointVector q = start->second;
    for (int i = 1; i <= longest_run && tracker.state().followed(); ++i) {
      if (random_.uniform(0.0, 1.0) < 0.03) direction = random_direction(size);
      keep_inside(q, direction);
      q += direction;
      tracker.update(0.001 * i, q);
      if (!judge(tracker, truth, options.hysteresis, q)) break;
    }
  }

  // False where the run cannot go on.
  bool judge(const Tracker& tracker, FineFollower& truth, double hysteresis, const JointVector& q) {
    ++counts_.steps;
    long made = 0, found = 0;
    const bool known = truth.go(q, hysteresis, made);
    const TrackedState& state = tracker.state();
    if (!state.followed()) {
      ++counts_.ambiguous[static_cast<std::size_t>(state.ambiguity)];
      if (known && truth.least_singular_value() > 1e-3) ++counts_.avoidable;
      return false;
    }
    ++counts_.tracked;
    for (const Transition& each : tracker.transitions()) found += each.kind == TransitionKind::working_mode;
    counts_.crossings_found += found;
    if (!known) {
      ++counts_.unjudged;
      if (!agrees_with_all_solutions(state)) wrong(state, "no direct solution has this sign");
      return false;
    }
    counts_.crossings_made += made;
    if (!(pose_distance(robot(), state.pose, truth.pose()) <= same_pose)) wrong(state, "pose");
    if (state.determinant_sign * direct_determinant(robot(), truth.pose(), q) <= 0.0) wrong(state, "sign");
    const TaskVector sines = truth.sines();
    for (std::size_t j = 0; j < robot().leg_count(); ++j)
      if (std::abs(sines[static_cast<Eigen::Index>(j)]) > 1.01 * hysteresis &&
          sines[static_cast<Eigen::Index>(j)] * state.mode.sign(j) < 0.0)
        wrong(state, "working mode");
    if (closed_form() && !agrees_with_all_solutions(state)) wrong(state, "closed form");
    return true;
  }

  // Where the direct solutions are a closed form, each sign of det A has but one.
  bool closed_form() const {
    const TaskSpace space = robot().task_space();
    return space == TaskSpace::T2 || space == TaskSpace::T3;
  }

  bool agrees_with_all_solutions(const TrackedState& state) const {
    const DirectResult all = direct(robot(), state.q);
    if (all.status != DirectStatus::solved) return true;
    return std::any_of(all.solutions.begin(), all.solutions.end(), [&](const AssemblyMode& mode) {
      return mode.near_singular || (mode.determinant * state.determinant_sign > 0.0 &&
                                    pose_distance(robot(), mode.pose, state.pose) <= same_pose);
    });
  }

  void wrong(const TrackedState& state, const std::string& what) {
    if (counts_.wrong++ == 0) counts_.first_wrong = what + ": " + describe(robot(), state.pose, state.q);
  }

  const Mechanism& mechanism_;
  RandomRobots random_;
  CampaignCounts counts_;
};

inline constexpr std::array<const char*, 12> campaign_robots{
    "five_bar",     "bipod",     "three_rpr",      "three_rrr", "three_prr", "delta",
    "linear_delta", "agile_eye", "spherical_3rrr", "stewart",   "hexa",      "six_pus"};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_TRACKING_CAMPAIGN_H
