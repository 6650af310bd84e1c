// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_JACOBIAN_H
#define PARALLEL_ASPECTS_ASK_JACOBIAN_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects::ask {

/// How the platform and the actuated joints move each other.
struct JacobianQuestion {
  std::optional<Pose> pose{};           ///< in the task frame, or
  std::optional<JointVector> joints{};  ///< in the order of the legs: each direct solution is examined
  std::optional<WorkingMode> mode{};    ///< by default every one
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, JacobianQuestion& question) {
  visit({"pose", "\"x y\"", "Pose of the platform; lengths [m]"}, question.pose);
  visit({"joints", "\"q1 q2\"",
         "In place of a pose: values of the actuated joints in the order of the legs [rad or m]; each direct "
         "solution is answered"},
        question.joints);
  visit({"mode", "\"(+,-)\"", "Working mode, as signs of B_jj; by default every one"}, question.mode);
}

/// What is known of a configuration.
enum class JacobianStatus { regular, parallel_singularity, serial_singularity, both, out_of_reach };

/// "regular", "parallel singularity", "serial singularity", "parallel and serial singularity" or "out of
/// reach".
const char* name(JacobianStatus status) noexcept;

/// The velocity model A t = B q' of a configuration, in floating point. t = (w, v) is the twist of the
/// platform: its angular velocity and the velocity of its operational point, along the axes of the task
/// frame, of each what the task space has; q' are the rates of the actuated joints. A matrix that needs the
/// inverse of one that is singular to rounding is not there.
struct JacobianAt {
  Pose pose;                                             ///< of the platform
  std::optional<WorkingMode> mode;                       ///< none where the sign of a B_jj is rounding
  JointVector q;                                         ///< empty where out of reach
  bool within_limits = false;                            ///< whether these values are
  JacobianStatus status = JacobianStatus::out_of_reach;  ///< whether A and B have inverses
  std::string reason;                                    ///< unless regular
  std::optional<TaskMatrix> a;                           ///< as of `direct_matrix`; none where out of reach
  std::optional<TaskVector> b;                           ///< as of `inverse_diagonal`; likewise
  std::optional<TaskMatrix> jacobian;                    ///< A^-1 B: t = jacobian q'
  std::optional<TaskMatrix> inverse_jacobian;            ///< B^-1 A: q' = inverse_jacobian t
  std::optional<TaskMatrix> force_transmission;  ///< its transpose: wrench = force_transmission efforts

  /// Of the Jacobian, decreasing, where twists are measured by how fast anchors move (root mean square, as in
  /// `anchor_distance`): [m/s] for rates of norm 1. Not there where actuated joints are angles and lengths.
  std::optional<TaskVector> singular_values;
  std::optional<double> condition_number;  ///< the largest over the smallest of these, where that is not 0
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const JacobianAt& answer) {
  visit({"pose", "", "of the platform"}, answer.pose);
  visit({"working_mode", "", "signs of B_jj; null for a direct solution at a serial singularity"},
        answer.mode);
  visit(
      {"joints", "rad or m", "joint values in the order of the legs; null, as the rest, where out of reach"},
      only_if(answer.q.size() > 0, answer.q));
  visit({"within_limits", "", "whether these values are"}, answer.within_limits);
  visit({"status", "",
         "`regular`, `parallel singularity`, `serial singularity`, `parallel and serial singularity` or `out "
         "of reach`. A is singular where the smallest singular value of the homogenised A is below 1e-6, B "
         "where the sine between rod and crank, or rod and normal of the rail, is"},
        answer.status);
  visit({"reason", "", "what is singular or out of reach, a message; null where regular"},
        only_if(!answer.reason.empty(), answer.reason));
  visit({"a", "m, rotational columns m^2",
         "A, a list of rows: one a leg, by columns `twist`; for spherical links on the sphere of radius 1"},
        answer.a);
  visit({"b_jj", "m^2/rad or m", "diagonal of B, in the order of the legs; likewise"}, answer.b);
  visit({"jacobian", "`twist_units` over `rate_units`",
         "A^-1 B: twist = jacobian rates, by rows `twist`, one column a leg; null where A is singular"},
        answer.jacobian);
  visit({"inverse_jacobian", "`rate_units` over `twist_units`",
         "B^-1 A: rates = inverse_jacobian twist, one row a leg, by columns `twist`; null where B is "
         "singular"},
        answer.inverse_jacobian);
  visit({"force_transmission", "`wrench_units` over `effort_units`",
         "(B^-1 A)^T: wrench = force_transmission efforts, by rows `wrench`, one column a leg: what the "
         "platform exerts, at rest and without weight; null where B is singular. The efforts that hold a "
         "wrench are jacobian^T wrench"},
        answer.force_transmission);
  visit({"singular_values", "m/s, by rad/s or m/s",
         "of the Jacobian, decreasing, in the metric of distances: speeds of the anchors, root mean square, "
         "for rates of norm 1; null where A is singular, or actuated joints are angles and lengths"},
        answer.singular_values);
  visit({"condition_number", "",
         "the largest of these over the smallest; null where there is none, or B is singular"},
        answer.condition_number);
}

/// The model at a configuration. `q` must assemble with `pose`; both must be finite.
JacobianAt jacobian_at(const Manipulator& robot, const Pose& pose, const JointVector& q);

/// How they move each other, and what the entries of the matrices are.
struct JacobianAnswer {
  TaskSpace task_space = TaskSpace::T2;       ///< of the robot
  std::optional<DirectStatus> direct_status;  ///< of joint values, as of `direct`
  std::vector<std::string> twist;             ///< names of the entries of t
  std::vector<std::string> twist_units;       ///< of these
  std::vector<std::string> wrench;            ///< names of the entries of its dual
  std::vector<std::string> wrench_units;      ///< of these
  std::vector<std::string> joints;            ///< those that are actuated
  std::vector<std::string> rate_units;        ///< of their rates
  std::vector<std::string> effort_units;      ///< of their efforts
  std::vector<JacobianAt> configurations;     ///< one a working mode or direct solution
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const JacobianAnswer& answer) {
  visit({"task_space", "", "how the platform moves"}, answer.task_space);
  visit({"direct_status", "", "with {joints}: `status` of `fk`; else null"}, answer.direct_status);
  visit({"twist", "",
         "its entries: angular velocity `wx`, `wy`, `wz` of the platform, then velocity `vx`, `vy`, `vz` of "
         "its operational point, along the axes of the task frame, of each what the task space has"},
        answer.twist);
  visit({"twist_units", "", "of these"}, answer.twist_units);
  visit({"wrench", "",
         "its entries: moment `mx`, `my`, `mz` about the operational point, then force `fx`, `fy`, `fz`, "
         "likewise; passive joints bear the others"},
        answer.wrench);
  visit({"wrench_units", "", "of these"}, answer.wrench_units);
  visit({"actuated_joints", "", "one a leg: whose rates and efforts"}, answer.joints);
  visit({"rate_units", "", "of these"}, answer.rate_units);
  visit({"effort_units", "", "likewise"}, answer.effort_units);
  visit({"configurations", "", "one for every working mode or direct solution, as follows"},
        answer.configurations);
}

/// What the entries are, without configurations.
JacobianAnswer jacobian_units(const Manipulator& robot);

/// Works them out.
Outcome<JacobianAnswer> answer(Session& session, const JacobianQuestion& question,
                               const Control& control = {});

}  // namespace parallel_aspects::ask

#endif  // PARALLEL_ASPECTS_ASK_JACOBIAN_H
