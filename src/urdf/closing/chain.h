// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_CHAIN_H
#define PARALLEL_ASPECTS_URDF_CLOSING_CHAIN_H

#include "parallel_aspects/model/problems.h"
#include "urdf/closing/assembly.h"
#include "urdf/description/closure.h"
#include "urdf/description/messages.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

enum class PivotKind { revolute, prismatic, ball };

/// A joint or a closure, met on the path from the base to the platform of an assembled mechanism.
struct Pivot {
  PivotKind kind = PivotKind::revolute;
  std::string name;                                 ///< of the joint or the closure
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on the axis, or the centre; in the base frame [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< unit vector in the base frame; unused by a ball
  std::optional<std::size_t> variable;              ///< joint value, none for a closure
  double sense = 1.0;  ///< the platform side moves along or about `sense * axis` as the joint value grows
};

/// From the base to the platform.
using Chain = std::vector<Pivot>;

/// The part of a mechanism between base and platform that one actuated joint moves; several chains where rods
/// run in parallel.
struct LegChains {
  std::size_t actuation = 0;  ///< index into the list of actuated joints
  std::vector<Chain> chains;
};

/// The part between base and platform that no actuated joint is in.
struct PassiveChains {
  std::vector<Chain> chains;
  bool restricts = false;  ///< whether the platform could move in more ways without it
  bool is_free = false;    ///< whether it lets the platform move in all six ways
};

/// All that joins the platform to the base.
struct FoundLegs {
  std::vector<LegChains> legs;  ///< in the order of the actuated joints
  std::vector<PassiveChains> passive;
  bool has_zero_length = false;  ///< of a link, which is a problem that has been named
};

/// What the mechanism is for the search of its legs.
struct ActuatedJoints {
  std::size_t platform_link = 0;
  std::vector<std::size_t> variables;  ///< actuated joint values, in the order of the legs
};

/// An assembled mechanism, as the search of its legs needs it.
struct AssembledMechanism {
  const ClosureSystem& system;
  Eigen::VectorXd values;   ///< of all joints [rad or m]
  std::vector<bool> still;  ///< joints that cannot move and are taken as fixed, for each joint value
};

/// Link and joint that are made for an operational point that is a frame without a name.
inline constexpr const char* unnamed_operational_point = "operational_point";

/// The operational point for messages: "operational_point 'LINK'", with its key as `files` have it, or as it
/// is written where it is a frame without a name.
std::string operational_point_text(const Tree& tree, std::size_t platform_link, const SourceNames& files);

/// "'a', 'b'" for messages.
std::string names_of(const Chain& chain);

/// The same without closures.
Note joint_names_of(const Chain& chain);

/// Legs and passive chains. What is wrong (a leg with two actuated joints, legs that share a link, a link of
/// a planar leg without length, a platform fixed to the base) is added to `problems`, each a message that
/// names the file.
FoundLegs find_legs(const AssembledMechanism& mechanism, const ActuatedJoints& actuated_joints,
                    const SourceNames& files, Problems& problems);

/// A part between base and platform, and by the rank of its twists in how many ways it lets the platform
/// move, though `AssembledMechanism::still` are fixed.
struct JoiningPart {
  std::vector<Chain> chains;
  Eigen::Index freedom = 6;
  bool is_actuated = false;  ///< whether an actuated joint is in it
};
std::vector<JoiningPart> joining_parts(const AssembledMechanism& mechanism,
                                       const ActuatedJoints& actuated_joints, const SourceNames& files);

/// A joint between base and platform.
struct LegJoint {
  std::size_t variable = 0;  ///< index of its joint value
  std::size_t depth = 0;     ///< how many joints and closures are between it and the base
};

/// The joints of each part between base and platform, whichever are actuated.
std::vector<std::vector<LegJoint>> joints_by_leg(const ClosureSystem& system,
                                                 const ActuatedJoints& actuated_joints,
                                                 const SourceNames& files);

/// A movable joint or closure between two rigid bodies.
struct Edge {
  std::size_t from = 0, to = 0;  ///< bodies; for a joint from parent to child
  Chain pivots;                  ///< one, or two for a universal closure
};

using TwistMatrix = Eigen::Matrix<double, 6, 6>;

/// A matrix that is zero on the twists (w, v) which these joints and closures allow the body `platform`
/// against `base`, and nothing else; lengths in units of `size` [m].
TwistMatrix held_twists(const std::vector<Edge>& edges, std::size_t base, std::size_t platform, double size);

/// How many independent twists all of these allow together.
Eigen::Index freedom_left(const std::vector<TwistMatrix>& held);

/// Whether a fully parallel robot may have so many actuated joints: one, two, three or six.
bool is_actuation_count(std::size_t count) noexcept;

/// Which of `described.variables`, of which there may be too many, can be the actuated joints: those at one
/// distance from the base in all legs, or in all but one.
std::vector<std::vector<std::size_t>> actuation_choices(const ClosureSystem& system,
                                                        const ActuatedJoints& described,
                                                        const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_CHAIN_H
