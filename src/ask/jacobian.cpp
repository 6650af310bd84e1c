// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/jacobian.h"

#include "model/linear_algebra.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/ask/inverse_direct.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace parallel_aspects::ask {
namespace {

// As in `direct`: beyond it rounding decides, or shows in half the digits of an inverse.
constexpr double singular = 1e-6;

bool is_singular(const TaskMatrix& homogenised) {
  const TaskVector values = singular_values(homogenised);
  return !(values[values.size() - 1] >= singular);
}

/// Stretched or folded; a strut, whose B_jj is its length, has almost none.
bool is_singular(const Manipulator& robot, std::size_t leg, double entry) {
  const double largest = robot.leg(leg).largest_entry();
  return !(std::abs(entry) >= singular * (largest > 0.0 ? largest : robot.size()));
}

std::string parallel_reason() {
  return "A is singular to rounding: the platform can move while all actuated joints stand, so that their "
         "rates do not determine its twist.";
}

/// Of all legs with such a B_jj; empty where there is none.
std::string serial_reason(const Manipulator& robot, const TaskVector& b) {
  std::string legs, joints;
  for (std::size_t j = 0; j < robot.leg_count(); ++j) {
    if (!is_singular(robot, j, b[static_cast<Eigen::Index>(j)])) continue;
    legs += (legs.empty() ? "'" : ", '") + robot.leg(j).name + "'";
    joints += (joints.empty() ? "'" : ", '") + robot.leg(j).actuated_joint + "'";
  }
  if (legs.empty()) return "";
  return "B_jj is zero to rounding for " + legs +
         ": the twist of the platform does not determine the rate of " + joints +
         ", nor do efforts of the actuated joints determine the wrench.";
}

bool are_of_one_kind(const Manipulator& robot) {
  for (const Leg& leg : robot.legs())
    if (leg.actuated_by_angle() != robot.leg(0).actuated_by_angle()) return false;
  return true;
}

/// Takes a twist to the velocities of all anchors over the root of their number, so that its norm is their
/// root mean square.
Eigen::MatrixXd anchor_velocities(const Manipulator& robot, const Pose& pose) {
  const auto n = static_cast<Eigen::Index>(robot.leg_count());
  Eigen::MatrixXd result(3 * n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::Vector3d b = pose.orientation * robot.leg(static_cast<std::size_t>(j)).anchor;
    for (Eigen::Index i = 0; i < 3; ++i) {  // the row of A of a link along this axis
      auto row = result.row(3 * j + i);
      write_row(robot.task_space(), lever_at(pose, b), Eigen::Vector3d::Unit(i), row);
    }
  }
  return result / std::sqrt(static_cast<double>(n));
}

void measure(const Manipulator& robot, JacobianAt& at) {
  if (!at.jacobian || !are_of_one_kind(robot)) return;
  const TaskVector values =
      singular_values(Eigen::MatrixXd(anchor_velocities(robot, at.pose) * *at.jacobian));
  at.singular_values = values;
  if (at.inverse_jacobian) at.condition_number = values[0] / values[values.size() - 1];
}

JacobianStatus status_of(bool parallel, bool serial) {
  if (parallel) return serial ? JacobianStatus::both : JacobianStatus::parallel_singularity;
  return serial ? JacobianStatus::serial_singularity : JacobianStatus::regular;
}

JacobianAt of_inverse(const Manipulator& robot, const Pose& pose, const InverseSolution& solution) {
  JacobianAt result;
  if (solution.status == InverseStatus::out_of_reach) {
    result.pose = pose;
    result.reason = reason_of(robot, pose, solution);
  } else {
    result = jacobian_at(robot, pose, solution.q);
  }
  result.mode = solution.mode;
  return result;
}

void add_inverse(const Manipulator& robot, const JacobianQuestion& question, JacobianAnswer& result) {
  const std::vector<InverseSolution> solutions =
      question.mode ? std::vector<InverseSolution>{inverse(robot, *question.pose, *question.mode)}
                    : inverse_in_all_modes(robot, *question.pose);
  for (const InverseSolution& each : solutions)
    result.configurations.push_back(of_inverse(robot, *question.pose, each));
}

void add_direct(const Manipulator& robot, const JacobianQuestion& question, JacobianAnswer& result) {
  const DirectResult found = direct(robot, *question.joints);
  result.direct_status = found.status;
  for (const AssemblyMode& each : found.solutions) {
    JacobianAt at = jacobian_at(robot, each.pose, *question.joints);
    if (each.serially_singular) at.mode.reset();
    if (!question.mode || at.mode == question.mode) result.configurations.push_back(std::move(at));
  }
}

void check(const JacobianQuestion& question, ProblemList& problems) {
  if (!question.pose && !question.joints)
    problems.push_back(
        {ProblemKind::missing, "pose", "{pose} is required", "give the pose of the platform, or {joints}"});
  if (question.pose && question.joints)
    problems.push_back({ProblemKind::together, "joints", "{pose} and {joints} are given", "leave one out"});
}

}  // namespace

const char* name(JacobianStatus status) noexcept {
  switch (status) {
    case JacobianStatus::regular:
      return "regular";
    case JacobianStatus::parallel_singularity:
      return "parallel singularity";
    case JacobianStatus::serial_singularity:
      return "serial singularity";
    case JacobianStatus::both:
      return "parallel and serial singularity";
    case JacobianStatus::out_of_reach:
      break;
  }
  return "out of reach";
}

JacobianAt jacobian_at(const Manipulator& robot, const Pose& pose, const JointVector& q) {
  JacobianAt at;
  at.pose = pose;
  at.q = q;
  at.mode = working_mode(robot, pose, q);
  at.within_limits = robot.within_limits(q);
  at.a = direct_matrix(robot, pose, q);
  at.b = inverse_diagonal(robot, pose, q);
  const bool parallel = is_singular(homogenised_matrix(robot, pose, q));
  const std::string serial = serial_reason(robot, *at.b);
  at.status = status_of(parallel, !serial.empty());
  at.reason = (parallel ? parallel_reason() : "") + (parallel && !serial.empty() ? " " : "") + serial;
  if (!parallel) at.jacobian = inverse(*at.a) * at.b->asDiagonal();
  if (serial.empty()) {
    at.inverse_jacobian = at.b->cwiseInverse().asDiagonal() * *at.a;
    at.force_transmission = at.inverse_jacobian->transpose();
  }
  measure(robot, at);
  return at;
}

JacobianAnswer jacobian_units(const Manipulator& robot) {
  JacobianAnswer result;
  result.task_space = robot.task_space();
  const TaskSpaceTraits& of = traits(result.task_space);
  const auto add = [&result](const std::string& axis, bool turns) {
    result.twist.push_back((turns ? "w" : "v") + axis);
    result.twist_units.emplace_back(turns ? "rad/s" : "m/s");
    result.wrench.push_back((turns ? "m" : "f") + axis);
    result.wrench_units.emplace_back(turns ? "N m" : "N");
  };
  if (has_hinges(result.task_space)) {
    for (const std::string& angle : coordinate_names(result.task_space)) add("_" + angle, true);
  } else {
    const std::vector<std::string> axes{"x", "y", "z"};
    for (std::size_t i = 3 - of.rotations; of.rotations > 0 && i < 3; ++i) add(axes[i], true);
    for (std::size_t i = 0; i < of.translations; ++i) add(axes[i], false);
  }
  for (const Leg& leg : robot.legs()) {
    result.joints.push_back(leg.actuated_joint);
    result.rate_units.emplace_back(leg.actuated_by_angle() ? "rad/s" : "m/s");
    result.effort_units.emplace_back(leg.actuated_by_angle() ? "N m" : "N");
  }
  return result;
}

Outcome<JacobianAnswer> answer(Session& session, const JacobianQuestion& question, const Control& control) {
  ProblemList problems;
  check(question, problems);
  if (!problems.empty()) return outcome_of(std::move(problems), control, JacobianAnswer());
  const Manipulator& robot = *session.robot();
  JacobianAnswer result = jacobian_units(robot);
  if (question.pose)
    add_inverse(robot, question, result);
  else
    add_direct(robot, question, result);
  return outcome_of({}, control, std::move(result));
}

}  // namespace parallel_aspects::ask
