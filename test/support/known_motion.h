// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_KNOWN_MOTION_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_KNOWN_MOTION_H

#include "motion/roadmap.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/pose.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <utility>

namespace parallel_aspects::test {

/// A seeded random motion of which the pose is known at every sample, without direct kinematics: along
/// segments of poses that interval arithmetic proves free of singularities, with the actuated joints by
/// inverse kinematics; and now and then through a serial singularity, the actuated joints moving straight
/// from one posture of a leg to the other at the same pose, which is known at both ends.
class KnownMotion {
 public:
  struct Sample {
    JointVector q;
    std::optional<Pose> pose;  ///< where it is known
    WorkingMode mode;          ///< there
  };

  KnownMotion(std::shared_ptr<const Manipulator> robot, const Pose& start, const WorkingMode& mode,
              std::uint64_t seed)
      : robot_(std::move(robot)),
        certifier_(robot_),
        engine_(seed),
        from_{start, inverse(*robot_, start, mode).q},
        mode_(mode),
        next_mode_(mode) {
    to_ = from_;
  }

  /// The next sample; no actuated joint moves by more than `longest` from one to the next [rad or m].
  Sample next(double longest) {
    if (t_ >= 1.0) plan();
    t_ = std::min(1.0, t_ + step(longest));
    if (t_ >= 1.0) {
      if (passes_) ++pass_count_;
      mode_ = next_mode_;
      last_q_ = to_.q;
      return {to_.q, to_.pose, mode_};
    }
    if (passes_) {
      last_q_ = from_.q + t_ * change_;
      return {last_q_, std::nullopt, mode_};
    }
    const Pose pose = pose_between(robot_->motions(), from_.pose, to_.pose, t_);
    last_q_ = near_last(inverse(*robot_, pose, mode_).q);
    return {last_q_, pose, mode_};
  }

  int passes() const noexcept { return pass_count_; }  ///< changes of working mode so far

 private:
  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(engine_);
  }

  // Angles that wrap go on turning.
  JointVector near_last(JointVector q) const {
    for (std::size_t j = 0; j < robot_->leg_count(); ++j) {
      const auto i = static_cast<Eigen::Index>(j);
      if (robot_->leg(j).actuated_by_angle() && last_q_.size() > 0)
        q[i] = last_q_[i] + std::remainder(q[i] - last_q_[i], 2.0 * EIGEN_PI);
    }
    return q;
  }

  double step(double longest) const { return longest / std::max(longest, largest_change_); }

  // Every third leg of the path leads near a boundary; where a leg of the robot is nearly stretched or folded
  // there, it passes to its other posture.
  void plan() {
    from_ = to_;
    if (last_q_.size() > 0) from_.q = last_q_;
    t_ = 0.0;
    passes_ = plan_pass();
    if (passes_) return;
    if (engine_() % 3 == 0 && go_to(nearly_out_of_reach())) return;
    for (double reach = 0.3; !go_to(displaced_by(reach)); reach *= 0.8) {
    }
  }

  bool plan_pass() {
    for (std::size_t leg = 0; leg < robot_->leg_count(); ++leg) {
      WorkingMode other = mode_;
      other.set_sign(leg, -mode_.sign(leg));
      if (!robot_->leg(leg).has_branch(other.sign(leg))) continue;
      const InverseSolution solution = inverse(*robot_, from_.pose, other);
      if (solution.status != InverseStatus::solved) continue;
      change_ = joint_change(*robot_, from_.q, solution.q);
      largest_change_ = change_.cwiseAbs().maxCoeff();
      if (largest_change_ > 0.5 || !straight_motion_exists(*robot_, from_, change_, from_.pose)) continue;
      to_ = {from_.pose, from_.q + change_};
      next_mode_ = other;
      return true;
    }
    return false;
  }

  Pose displaced_by(double reach) {
    TaskVector twist(static_cast<Eigen::Index>(degrees_of_freedom(robot_->task_space())));
    const auto turns = static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot_->task_space()));
    for (Eigen::Index i = 0; i < twist.size(); ++i)
      twist[i] = reach * uniform(-1.0, 1.0) * (i < turns ? 1.0 : robot_->size());
    return displaced(robot_->motions(), from_.pose, twist);
  }

  Pose nearly_out_of_reach() {
    const Pose far = displaced_by(1.0);
    const SegmentProof proof = certifier_.prove_start(from_.pose, far, mode_);
    return pose_between(robot_->motions(), from_.pose, far, std::max(0.0, proof.free_until - 1e-4));
  }

  bool go_to(const Pose& pose) {
    if (certifier_.prove(from_.pose, pose, mode_).verdict != SegmentVerdict::free) return false;
    largest_change_ = 0.0;
    JointVector before = from_.q;
    constexpr int parts = 256;  // actuated joints do not move evenly along the segment
    for (int i = 1; i <= parts; ++i) {
      const JointVector q =
          inverse(*robot_, pose_between(robot_->motions(), from_.pose, pose, i / double{parts}), mode_).q;
      largest_change_ =
          std::max(largest_change_, parts * joint_change(*robot_, before, q).cwiseAbs().maxCoeff());
      before = q;
    }
    to_ = {pose, from_.q + joint_change(*robot_, from_.q, inverse(*robot_, pose, mode_).q)};
    return true;
  }

  std::shared_ptr<const Manipulator> robot_;
  SegmentCertifier certifier_;
  std::mt19937_64 engine_;
  Place from_, to_;
  WorkingMode mode_, next_mode_;
  JointVector change_, last_q_;
  double largest_change_ = 0.0, t_ = 1.0;
  bool passes_ = false;
  int pass_count_ = 0;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_KNOWN_MOTION_H
