// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_INVERSE_DIRECT_H
#define PARALLEL_ASPECTS_ASK_INVERSE_DIRECT_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The fields of indices.
template <class Visit>
void describe(Visit& visit, const SingularityIndices& indices) {
  visit({"det_a", "", "det A"}, indices.determinant);
  visit({"b_jj", "", "of each leg"}, indices.inverse_diagonal);
  visit({"smallest_singular_value", "", "of the homogenised A"}, indices.smallest_singular_value);
  visit({"inverse_condition_number", "", "likewise"}, indices.inverse_condition_number);
}

namespace ask {

/// Which values of the actuated joints a pose has.
struct InverseQuestion {
  std::optional<Pose> pose{};  ///< in the task frame
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, InverseQuestion& question) {
  visit({"pose", "\"x y\"", "Pose of the platform; lengths [m]"}, question.pose);
}

/// Which they are in one working mode.
struct InverseInMode {
  InverseSolution solution;                   ///< as of `inverse`
  std::string reason;                         ///< unless solved
  std::string missed_margins;                 ///< as of `missed_margins`
  std::optional<SingularityIndices> indices;  ///< unless out of reach
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const InverseInMode& answer) {
  visit({"working_mode", "", "signs of B_jj"}, answer.solution.mode);
  visit({"status", "", "`solved`, `out of reach` or `outside joint limits`"}, answer.solution.status);
  visit({"reason", "", "which leg and why, a message; null where solved"},
        only_if(!answer.reason.empty(), answer.reason));
  visit(
      {"joints", "rad or m", "joint values in the order of the legs; null, as the rest, where out of reach"},
      only_if(answer.indices.has_value(), answer.solution.q));
  visit({"missed_margins", "", "a sentence about each margin that it does not keep; null where it keeps all"},
        only_if(!answer.missed_margins.empty(), answer.missed_margins));
  visit({"indices", "",
         "`det_a`, `b_jj`, `smallest_singular_value` and `inverse_condition_number` of the homogenised A"},
        answer.indices);
}

/// Which they are.
struct InverseAnswer {
  TaskSpace task_space = TaskSpace::T2;  ///< of the robot
  Pose pose;                             ///< as asked
  std::vector<InverseInMode> solutions;  ///< one a working mode
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const InverseAnswer& answer) {
  visit({"task_space", "", "how the platform moves"}, answer.task_space);
  visit({"pose", "", "as asked"}, answer.pose);
  visit({"solutions", "", "one for every working mode, as follows"}, answer.solutions);
}

/// Solves it.
Outcome<InverseAnswer> answer(Session& session, const InverseQuestion& question, const Control& control = {});

/// "outside its limits [2, 6] by 0.1": what is beyond them by rounding looks like the limit itself.
std::string outside_text(const JointLimits& limits, double value);

/// Why an inverse problem is not solved, a sentence.
std::string reason_of(const Manipulator& robot, const Pose& pose, const InverseSolution& solution);

/// Which poses given values of the actuated joints can hold.
struct DirectQuestion {
  std::optional<JointVector> joints{};  ///< in the order of the legs
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, DirectQuestion& question) {
  visit({"joints", "\"q1 q2\"", "Joint values in the order of the legs [rad or m]"}, question.joints);
}

/// One of them.
struct DirectSolution {
  AssemblyMode assembly;            ///< as of `direct`
  std::optional<WorkingMode> mode;  ///< none at a serial singularity, where the sign of a B_jj is rounding
  SingularityIndices indices;       ///< there
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const DirectSolution& answer) {
  visit({"pose", "", "of the platform"}, answer.assembly.pose);
  visit({"working_mode", "", "signs of B_jj; null at a serial singularity"}, answer.mode);
  visit({"det_a", "",
         "det A there; unit m in T1, m^2 in T2, m^4 in SE2, m^3 in T3, m^6 in SO3, m^9 in SE3, m^2 in R1, "
         "m^4 in R2; none for spherical links"},
        answer.assembly.determinant);
  visit({"residual", "", "largest leg equation left over, relative to the squared size of the robot"},
        answer.assembly.residual);
  visit({"near_singular", "",
         "whether it is so close to det A = 0 that its count or pose may depend on rounding"},
        answer.assembly.near_singular);
  visit(
      {"serially_singular", "",
       "whether some B_jj is zero to rounding, a leg being stretched or folded: the four trivial ones of the "
       "eight solutions of the Agile Eye are such at all joint values"},
      answer.assembly.serially_singular);
  visit({"indices", "", "as for `ik`"}, answer.indices);
}

/// Which they are.
struct DirectAnswer {
  TaskSpace task_space = TaskSpace::T2;          ///< of the robot
  JointVector joints;                            ///< as asked
  bool within_limits = true;                     ///< whether these are
  DirectStatus status = DirectStatus::unsolved;  ///< as of `direct`
  std::vector<DirectSolution> assembly_modes;    ///< by falling det A
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const DirectAnswer& answer) {
  visit({"task_space", "", "how the platform moves"}, answer.task_space);
  visit({"joints", "rad or m", "as asked"}, answer.joints);
  visit({"within_limits", "", "whether these values are"}, answer.within_limits);
  visit({"status", "",
         "`solved`, `continuum` where the platform can move with the actuated joints locked, or `unsolved`"},
        answer.status);
  visit({"assembly_modes", "", "by falling det A, as follows"}, answer.assembly_modes);
}

/// Solves it.
Outcome<DirectAnswer> answer(Session& session, const DirectQuestion& question, const Control& control = {});

}  // namespace ask
}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASK_INVERSE_DIRECT_H
