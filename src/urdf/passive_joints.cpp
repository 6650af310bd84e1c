// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/tracking/tracker.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <cmath>
#include <limits>
#include <utility>

namespace parallel_aspects {

std::vector<std::string> problems_of(const PassiveOptions& options) {
  std::vector<std::string> problems;
  const auto positive = [&](double value, const std::string& what) {
    if (!std::isfinite(value) || value <= 0.0)
      problems.push_back("The tolerance of passive " + what + " is " + std::to_string(value) +
                         "; it must be finite and positive.");
  };
  positive(options.angle_tolerance, "angles");
  positive(options.length_tolerance, "lengths");
  if (!(options.hysteresis >= 0.0 && options.hysteresis <= 1.0))
    problems.push_back("The hysteresis of passive joints is " + std::to_string(options.hysteresis) +
                       "; it must be from 0 to 1.");
  return problems;
}

PassiveJoints::PassiveJoints(std::shared_ptr<const Mechanism> mechanism, const PassiveOptions& options)
    : mechanism_(std::move(mechanism)), options_(options), joints_(mechanism_->determined_joints()) {
  const auto& legs = mechanism_->manipulator()->legs();
  const auto& names = mechanism_->joint_names();
  for (std::size_t i = joints_.size(); i-- > 0;)
    for (const Leg& leg : legs)
      if (names[joints_[i].index] == leg.actuated_joint) {
        joints_.erase(joints_.begin() + static_cast<std::ptrdiff_t>(i));
        break;
      }
}

PassiveResidual PassiveJoints::residual(const Pose& pose, const JointVector& q,
                                        const Eigen::VectorXd& readings) const {
  PassiveResidual result;
  const auto count = static_cast<Eigen::Index>(mechanism_->joint_names().size());
  Eigen::VectorXd computed(count);
  if (readings.size() != count) return result;
  const bool closes = mechanism_->complete(pose, q, computed);
  for (const PassiveJoint& joint : joints_) {
    const double measured = readings[static_cast<Eigen::Index>(joint.index)];
    if (!std::isfinite(measured)) continue;
    double difference = std::numeric_limits<double>::infinity();
    if (closes) difference = measured - computed[static_cast<Eigen::Index>(joint.index)];
    if (closes && joint.turns) difference = std::remainder(difference, 2.0 * EIGEN_PI);
    const double tolerance = joint.turns ? options_.angle_tolerance
                                         : options_.length_tolerance * mechanism_->manipulator()->size();
    const double excess = std::abs(difference) / tolerance;
    if (result.compared++ == 0 || excess > result.excess)
      result = {result.compared, excess, joint.index, difference};
  }
  return result;
}

bool PassiveJoints::within_limits(const Pose& pose, const JointVector& q) const {
  Eigen::VectorXd computed(static_cast<Eigen::Index>(mechanism_->joint_names().size()));
  if (!mechanism_->complete(pose, q, computed)) return false;
  const auto& limits = mechanism_->joint_limits();
  for (const PassiveJoint& joint : joints_) {
    const double value = computed[static_cast<Eigen::Index>(joint.index)];
    const double tolerance = joint.turns ? options_.angle_tolerance
                                         : options_.length_tolerance * mechanism_->manipulator()->size();
    if (value < limits[joint.index].lower - tolerance || value > limits[joint.index].upper + tolerance)
      return false;
  }
  return true;
}

PassiveResidual PassiveJoints::apply(const Eigen::VectorXd& readings, Tracker& tracker) const {
  if (!tracker.state().followed() && tracker.candidates().size() > 0)
    tracker.keep_candidates([&](const Pose& pose, const JointVector& q) {
      return !residual(pose, q, readings).contradicts() && within_limits(pose, q);
    });
  const TrackedState& state = tracker.state();
  if (!state.followed()) return {};
  const PassiveResidual found = residual(state.pose, state.q, readings);
  const double end = state.status == TrackStatus::inconsistent ? 1.0 - options_.hysteresis : 1.0;
  if (found.compared > 0) tracker.report_residual(found.excess, found.excess > end);
  return found;
}

}  // namespace parallel_aspects
