// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/roadmap/violation_text.h"

#include "aspects/roadmap/pose_segment.h"
#include "interval/path_form.h"
#include "legs/spatial_leg.h"
#include "legs/toleranced.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <array>
#include <cstddef>
#include <optional>

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

/// Whether B_jj of the leg is proved to be zero at the pose, to the last digit of the description.
bool is_exactly_singular(const Motions& motions, const Leg& leg, const Pose& pose) {
  const RoundingUpward rounding;
  PoseSegment::Placement placement;
  if (!PoseSegment(motions, pose, pose).place(PathForm(0.0), placement)) return false;
  const SpatialLeg enclosed(leg);
  const std::array<Interval, 3> anchor = toleranced_anchor(leg);
  Spatial<PathForm> d;
  for (std::size_t i = 0; i < 3; ++i)
    d[i] = placement.position[i] + dot(anchor, placement.rotation[i]) - PathForm(enclosed.base()[i]);
  const Interval entry = enclosed.form(d).squared_b_entry.center;
  return entry.lower() == 0.0 && entry.upper() == 0.0;
}

std::string reach_text(const Manipulator& manipulator, const PoseInMode& at,
                       const std::optional<std::size_t>& leg) {
  if (!leg) return "a leg cannot reach it";
  const Leg& failing = manipulator.leg(*leg);
  const std::string name = "leg '" + failing.name + "'";
  if (!failing.has_branch(at.mode.sign(*leg)))
    return name + " has no posture with that sign of B_jj (working mode " + to_string(at.mode) + ")";
  return is_exactly_singular(manipulator.motions(), failing, at.pose)
             ? name + " is stretched or folded there (B_jj = 0)"
             : name + " cannot reach it";
}

}  // namespace

std::string violation_text(const Manipulator& manipulator, const PoseInMode& at,
                           const ConfigurationProof& proof) {
  switch (proof.proved_violation) {
    case Violation::out_of_reach:
      return reach_text(manipulator, at, proof.leg);
    case Violation::joint_limit:
      return "the actuated joint of " +
             (proof.leg ? "leg '" + manipulator.leg(*proof.leg).name + "'" : std::string("a leg")) +
             " would be outside its limits (constraint actuated_limits)";
    case Violation::constraint:
      return constraint_text(manipulator, at, proof.failing.value_or(ConstraintKind::workspace));
    case Violation::singularity:
    case Violation::none:
      break;
  }
  return "it is singular";
}

}  // namespace parallel_aspects
