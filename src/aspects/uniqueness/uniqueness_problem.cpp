// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/uniqueness_problem.h"

#include "aspects/tree/held_joint_example.h"
#include "model/angles.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/model/manipulator.h"

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
  const std::string example = example_of_held_joint(manipulator);
  if (example.empty())
    return "In SE2 actuated values are examined in slices that hold an actuated joint, and " +
           in_quotes(manipulator.name()) + " has none that can be held.";
  return "In SE2 actuated values are examined in slices; give one that holds an actuated joint, such as " +
         example + ".";
}

std::string find_tolerance_problem(const Manipulator& manipulator, const std::string& what) {
  if (manipulator.tolerance() == 0.0) return "";
  return what + " are of a robot without tolerances, and " + in_quotes(manipulator.name()) +
         " has some; leave them out.";
}

/// The struts and slides whose joint has no limits on both sides. Of a strut the lower end has one, no
/// length.
std::string lengths_without_limit(const Manipulator& manipulator) {
  std::string text;
  for (const Leg& leg : manipulator.legs()) {
    const bool is_strut = leg.kind().type == LegType::strut;
    const bool lower = std::isfinite(leg.limits.lower) || (is_strut && leg.has_branch(1));
    const bool upper = std::isfinite(leg.limits.upper) || (is_strut && leg.has_branch(-1));
    if (!leg.actuated_by_angle() && !(lower && upper))
      text += (text.empty() ? "" : ", ") + in_quotes(leg.actuated_joint);
  }
  return text;
}

/// Of all poses: no strut or slide may go as far as it likes.
std::string find_problem_without_slice(const Manipulator& manipulator) {
  if (has_elbows(manipulator)) return find_slice_to_hold(manipulator);
  const std::string unlimited = lengths_without_limit(manipulator);
  if (unlimited.empty()) return "";
  return "All poses of " + in_quotes(manipulator.name()) +
         " are examined within limits of its struts and slides, but nothing limits how far " + unlimited +
         " may go. Give limits, or a slice that holds an actuated joint, such as " +
         example_of_held_joint(manipulator) + ".";
}

std::string find_problem_of_slice(const Manipulator& manipulator, const MapSlice& slice) {
  if (!slice.joint)
    return find_slice_to_hold(manipulator) +
           (has_elbows(manipulator) ? "" : " All poses are examined without a slice.");
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
  const std::string tolerance = find_tolerance_problem(manipulator, "Numbers of direct solutions");
  if (!tolerance.empty()) return tolerance;
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
    case TaskSpace::R1:
      return true;
    case TaskSpace::SE2:
    case TaskSpace::SO3:
    case TaskSpace::R2:
    case TaskSpace::SE3:
      return false;
  }
  return false;
}

bool has_lengths_without_limit(const Manipulator& manipulator) {
  return !lengths_without_limit(manipulator).empty();
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
  if (manipulator.task_space() != TaskSpace::SE2)
    return "Curves of cusps are followed in SE2, and " + in_quotes(manipulator.name()) + " moves in " +
           std::string(name(manipulator.task_space())) + ".";
  const std::string tolerance = find_tolerance_problem(manipulator, "Cusps");
  if (!tolerance.empty()) return tolerance;
  if (range.leg < manipulator.leg_count() && !(std::isfinite(range.lower) && std::isfinite(range.upper)))
    return in_quotes(manipulator.leg(range.leg).actuated_joint) +
           " has no limits on both sides; give the ends of a range, such as " +
           example_of_held_range(manipulator, range.leg) + ".";
  if (!(range.lower < range.upper))
    return "The range of " + in_quotes(manipulator.leg(range.leg).actuated_joint) +
           " does not begin below its end; give the smaller value first, such as " +
           example_of_held_range(manipulator, range.leg) + ".";
  for (const double value : {range.lower, range.upper}) {
    const std::string problem = find_held_value_problem(manipulator, {range.leg, value, false}, "The range");
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
  const std::string tolerance = find_tolerance_problem(manipulator, "Cusps");
  if (!tolerance.empty()) return tolerance;
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
  return "Uniqueness domains are found in T1, T2, T3, R1 and SE2, and " + in_quotes(manipulator.name()) +
         " moves in " + std::string(name(space)) +
         "; `aspects uniqueness` finds in which of its aspects more than one pose has the same actuated "
         "values.";
}

}  // namespace parallel_aspects
