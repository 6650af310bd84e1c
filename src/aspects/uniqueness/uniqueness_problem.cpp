// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/uniqueness_problem.h"

#include "model/angles.h"
#include "parallel_aspects/aspects/held_joint.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/model/constraints.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

std::string in_quotes(const std::string& text) { return "'" + text + "'"; }

/// Constraints besides the limits of actuated joints, by name.
std::string other_constraints(const Manipulator& manipulator) {
  std::string text;
  for (const ConstraintKind kind : all_constraint_kinds)
    if (kind != ConstraintKind::actuated_limits && manipulator.constraint_kinds()[index_of(kind)])
      text += (text.empty() ? "" : ", ") + std::string(name(kind));
  return text;
}

std::string find_slice_to_hold(const Manipulator& manipulator) {
  return "In SE2 actuated values are looked at in slices; give one that holds an actuated joint, such as " +
         manipulator.leg(0).actuated_joint + ".";
}

/// Of all poses: three struts, none of which may become as long as it likes.
std::string find_problem_without_slice(const Manipulator& manipulator) {
  if (!has_struts_alone(manipulator)) return find_slice_to_hold(manipulator);
  const bool bounded = std::all_of(manipulator.legs().begin(), manipulator.legs().end(), [](const Leg& leg) {
    return std::isfinite(leg.has_branch(1) ? leg.limits.upper : leg.limits.lower);
  });
  if (manipulator.tolerance() > 0.0)
    return "Numbers of direct solutions are of a robot without tolerances, and '" + manipulator.name() +
           "' has some; leave them out.";
  if (bounded) return "";
  return "All poses of " + in_quotes(manipulator.name()) +
         " are looked at within limits of its struts, and one of these has none. Give limits, or a slice "
         "that "
         "holds an actuated joint, such as " +
         manipulator.leg(0).actuated_joint + ".";
}

std::string find_problem_of_slice(const Manipulator& manipulator, const MapSlice& slice) {
  if (!slice.joint)
    return find_slice_to_hold(manipulator) +
           (has_struts_alone(manipulator) ? " All poses are looked at without a slice." : "");
  return find_held_joint_problem(manipulator, *slice.joint);
}

/// Of what was asked for in SE2.
std::string find_constraint_problem(const Manipulator& manipulator) {
  const std::string others = other_constraints(manipulator);
  if (others.empty()) return "";
  return "Cusps and regions of actuated values are bounded by limits of actuated joints alone, but " +
         in_quotes(manipulator.name()) + " has " + others + "; leave these constraints out.";
}

std::string find_problem_in_se2(const Manipulator& manipulator, const UniquenessOptions& options) {
  const std::string problem = options.slice ? find_problem_of_slice(manipulator, *options.slice)
                                            : find_problem_without_slice(manipulator);
  return problem.empty() ? find_constraint_problem(manipulator) : problem;
}

std::string find_why_without_cusps(const Manipulator& manipulator) {
  if (!has_one_solution_a_sign(manipulator.task_space())) return "";
  return "In " + std::string(name(manipulator.task_space())) + " no three direct solutions meet, so that " +
         in_quotes(manipulator.name()) + " has no cusps.";
}

}  // namespace

bool has_one_solution_a_sign(TaskSpace space) noexcept {
  switch (space) {
    case TaskSpace::T1:
    case TaskSpace::T2:
    case TaskSpace::T3:
      return true;
    case TaskSpace::SE2:
    case TaskSpace::SO3:
    case TaskSpace::SE3:
      return false;
  }
  return false;
}

bool has_struts_alone(const Manipulator& manipulator) noexcept {
  return std::all_of(manipulator.legs().begin(), manipulator.legs().end(),
                     [](const Leg& leg) { return leg.kind().type == LegType::strut; });
}

bool has_elbows(const Manipulator& manipulator) noexcept {
  return std::any_of(manipulator.legs().begin(), manipulator.legs().end(),
                     [](const Leg& leg) { return leg.kind().type == LegType::elbow; });
}

std::string find_held_range_problem(const Manipulator& manipulator, const HeldRange& range) {
  const std::string none = find_why_without_cusps(manipulator);
  if (!none.empty()) return none;
  if (!std::isfinite(range.lower) || !std::isfinite(range.upper))
    return "The joint that is held has no limits on both sides; give the ends of a range.";
  if (!(range.lower < range.upper))
    return "The lower end of the range of the joint that is held is not below the upper; give two values.";
  for (const double value : {range.lower, range.upper}) {
    const std::string problem = find_held_joint_problem(manipulator, {range.leg, value, false});
    if (!problem.empty()) return problem;
  }
  if (manipulator.leg(range.leg).actuated_by_angle() && range.upper - range.lower > full_turn)
    return "The range of the joint that is held is more than a full turn; give one turn or less.";
  return find_constraint_problem(manipulator);
}

std::string find_cusps_problem(const Manipulator& manipulator, const HeldJoint& joint) {
  const std::string none = find_why_without_cusps(manipulator);
  if (!none.empty()) return none;
  if (manipulator.task_space() == TaskSpace::SE3)
    return "With one joint held the cusps of " + in_quotes(manipulator.name()) +
           " are no points, since it moves in SE3; they are listed in SE2 and SO3.";
  if (manipulator.tolerance() > 0.0)
    return "Cusps are of a robot without tolerances, and " + in_quotes(manipulator.name()) +
           " has some; leave them out.";
  const std::string problem = find_held_value_problem(manipulator, joint);
  return problem.empty() ? find_constraint_problem(manipulator) : problem;
}

std::string find_uniqueness_problem(const Manipulator& manipulator, const UniquenessOptions& options) {
  const TaskSpace space = manipulator.task_space();
  if (has_one_solution_a_sign(space))
    return options.slice ? "In " + std::string(name(space)) +
                               " every aspect is a uniqueness domain as a whole; leave the slice out."
                         : "";
  if (space == TaskSpace::SE2) return find_problem_in_se2(manipulator, options);
  return "Uniqueness domains are found in T1, T2, T3 and SE2, and " + in_quotes(manipulator.name()) +
         " moves in " + std::string(name(space)) +
         "; `aspects uniqueness` tells in which of its aspects more than one pose has the same actuated "
         "values.";
}

}  // namespace parallel_aspects
