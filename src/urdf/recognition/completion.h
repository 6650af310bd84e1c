// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_RECOGNITION_COMPLETION_H
#define PARALLEL_ASPECTS_URDF_RECOGNITION_COMPLETION_H

#include "parallel_aspects/model/pose.h"
#include "urdf/description/closure.h"
#include "urdf/recognition/leg_recognition.h"
#include "urdf/recognition/passive_chain.h"
#include "urdf/recognition/platform_motion.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// exp(axis angle) as a matrix; `axis` a unit vector, `angle` in rad.
Eigen::Matrix3d rotation(const Eigen::Vector3d& axis, double angle);

/// Angle in (-pi, pi] that turns `from` towards `to` about the unit vector `axis`, seen along it [rad].
/// Subproblem 1 of Paden and Kahan (Murray, Li, Sastry, A Mathematical Introduction to Robotic Manipulation,
/// 1994, 3.2).
double angle_about(const Eigen::Vector3d& axis, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Angles with exp(first a) exp(second b) from = to, for unit vectors `first`, `second` that are not parallel
/// and vectors of equal length. Subproblem 2 of Paden and Kahan; of its two solutions, the one where the
/// vector between the two turns lies on the side `branch` (1 or -1) of the plane of the axes. Where it does
/// not reach, the closest. Nothing for parallel axes.
std::optional<std::array<double, 2>> angles_about(const Eigen::Vector3d& first, const Eigen::Vector3d& second,
                                                  const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                                  int branch);

/// Finds the passive joints that belong to a pose and joint values, leg by leg and in closed form: with the
/// two ends of a rod known, the pivots at each end are a subproblem of Paden and Kahan. Idle joints stay
/// where the assembled configuration has them.
class Completion {
 public:
  /// `reference` are all joint values of the assembled configuration that everything else belongs to.
  Completion(ClosureSystem system, Eigen::VectorXd reference, const PlatformMotion& motion,
             std::vector<RecognisedLeg> legs, std::vector<PassiveChain> passive_chains,
             std::vector<std::size_t> actuated_variables);

  /// Pose of the assembled configuration.
  const Pose& reference_pose() const noexcept { return reference_pose_; }

  /// Joint values of the assembled configuration [rad or m].
  JointVector reference_joints() const;

  /// All joint values [rad or m]; `pose` in the task frame. They close the loops where the legs assemble;
  /// check `residual`.
  Eigen::VectorXd joint_values(const Pose& pose, const JointVector& q) const;

  /// Largest entry of the closure residual over the size of the robot.
  double residual(const Eigen::VectorXd& values) const;

  const ClosureSystem& system() const noexcept { return system_; }

  /// Index of the joint value of each actuated joint.
  const std::vector<std::size_t>& actuated_variables() const noexcept { return actuated_variables_; }

 private:
  Eigen::Isometry3d solve(const SplitChain& chain, double joint_step,
                          const Eigen::Isometry3d& platform_motion, Eigen::VectorXd& values) const;
  void follow(const PassiveChain& chain, const Eigen::Isometry3d& platform_motion,
              Eigen::VectorXd& values) const;
  void set(const Pivot& pivot, double step, Eigen::VectorXd& values) const;

  ClosureSystem system_;
  Eigen::VectorXd reference_;
  Eigen::Isometry3d task_frame_;
  Pose reference_pose_;
  bool point_platform_;
  std::vector<RecognisedLeg> legs_;
  std::vector<PassiveChain> passive_chains_;
  std::vector<std::size_t> actuated_variables_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_RECOGNITION_COMPLETION_H
