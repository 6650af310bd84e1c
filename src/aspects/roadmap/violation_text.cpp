// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/roadmap/violation_text.h"

#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/singularity/margins.h"

namespace parallel_aspects {
namespace {

/// Which constraint does not hold, with its numbers where it is a margin.
std::string constraint_text(const Manipulator& manipulator, const PoseInMode& at, ConstraintKind failing) {
  if (failing == ConstraintKind::margins) {
    const std::string missed = missed_margins(manipulator, at.pose, inverse(manipulator, at.pose, at.mode).q);
    if (!missed.empty()) return missed + " (constraint margins)";
  }
  return "the constraint " + std::string(name(failing)) + " does not hold there";
}

}  // namespace

std::string violation_text(const Manipulator& manipulator, const PoseInMode& at,
                           const ConfigurationProof& proof) {
  const std::string leg = proof.leg ? "leg '" + manipulator.leg(*proof.leg).name + "'" : "a leg";
  switch (proof.proved_violation) {
    case Violation::out_of_reach:
      return leg + " cannot reach it";
    case Violation::joint_limit:
      return "the actuated joint of " + leg + " would be outside its limits (constraint actuated_limits)";
    case Violation::constraint:
      return constraint_text(manipulator, at, proof.failing.value_or(ConstraintKind::workspace));
    case Violation::singularity:
    case Violation::none:
      break;
  }
  return "it is singular";
}

}  // namespace parallel_aspects
