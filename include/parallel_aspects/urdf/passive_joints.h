// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_PASSIVE_JOINTS_H
#define PARALLEL_ASPECTS_URDF_PASSIVE_JOINTS_H

#include "parallel_aspects/tracking/tracker.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {

/// How far measured passive joints may be from those of a pose.
struct PassiveOptions {
  double angle_tolerance = 0.05;   ///< [rad], positive
  double length_tolerance = 0.01;  ///< as a share of the robot's size, positive
  double hysteresis = 0.2;         ///< a contradiction ends this share below the tolerance [0 to 1]
};

/// Every problem, a message each; empty when the options can be used.
std::vector<std::string> problems_of(const PassiveOptions& options);

/// What measured passive joints say of a pose.
struct PassiveResidual {
  std::size_t compared = 0;  ///< joints that were measured and can be compared; 0: nothing is known
  double excess = 0.0;       ///< largest difference over its tolerance; above 1 contradicts the pose
  std::size_t joint = 0;     ///< where: index into `Mechanism::joint_names()`
  double difference = 0.0;   ///< there, measured less computed [rad or m]

  /// Whether a joint is farther away than its tolerance.
  bool contradicts() const noexcept { return excess > 1.0; }
};

/// Compares measured passive joints with those that belong to a pose and joint values, in the branch that the
/// mechanism was assembled in. Its functions allocate; they are not for the hot path. Safe to share between
/// threads.
class PassiveJoints {
 public:
  /// The options have no `problems_of`.
  explicit PassiveJoints(std::shared_ptr<const Mechanism> mechanism, const PassiveOptions& options = {});

  /// How many passive joints can be compared where all are measured.
  std::size_t comparable() const noexcept { return joints_.size(); }

  /// `readings` has an entry for each of `Mechanism::joint_names()`, not a number where nothing was measured
  /// [rad or m]. Where the loops do not close, every difference is infinite.
  PassiveResidual residual(const Pose& pose, const JointVector& q, const Eigen::VectorXd& readings) const;

  /// Whether the loops close with every passive joint inside its limits.
  bool within_limits(const Pose& pose, const JointVector& q) const;

  /// Lets the tracker know: while it follows a pose, whether the readings contradict that, with hysteresis;
  /// while it has candidates, which of them fit the readings and the limits of passive joints. The residual
  /// of the pose that is followed in the end; nothing compared where there is none.
  PassiveResidual apply(const Eigen::VectorXd& readings, Tracker& tracker) const;

  /// What it was made with.
  const PassiveOptions& options() const noexcept { return options_; }

 private:
  std::shared_ptr<const Mechanism> mechanism_;
  PassiveOptions options_;
  std::vector<PassiveJoint> joints_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_PASSIVE_JOINTS_H
