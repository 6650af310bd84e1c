// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_ACTUATION_CANDIDATES_H
#define PARALLEL_ASPECTS_URDF_SETUP_ACTUATION_CANDIDATES_H

#include "urdf/dialects/closure_dialects.h"
#include "urdf/setup/body_graph.h"
#include "urdf/setup/setup.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// What a URDF says of the effort of a joint. Limits have to say some, but for a joint that turns endlessly,
/// which needs none: there an effort is meant.
enum class StatedEffort { none, zero, by_habit, meant };

/// What a URDF says of each joint value besides how it moves.
struct JointEvidence {
  std::vector<bool> stated;  ///< by what `stated_in` names, as <transmission>
  std::vector<StatedEffort> efforts;
  std::string stated_in;
  std::vector<std::string> unknown;  ///< names in what `stated_in` names that no joint has, or a fixed one
};

JointEvidence find_joint_evidence(const LoopSource& source);

/// One joint of each leg, and the weight of the evidence for these.
struct ActuationCandidate {
  std::vector<std::size_t> variables;
  int weight = 0;
  std::string reason;
  bool is_guess = true;
};

/// Combinations of one joint of each leg that have the same place or name in all legs, or that alone have
/// evidence of an actuated joint; those with most evidence first. Where a combination is stated, there
/// are no others. Joints that mimic others are left out, unless `with_followers`.
std::vector<ActuationCandidate> actuation_candidates(const Tree& tree, const std::vector<GraphPart>& legs,
                                                     const JointEvidence& evidence,
                                                     bool with_followers = false);

/// All that the URDF states.
ActuationCandidate stated_actuation(const JointEvidence& evidence);

/// Whether all of its joints are stated.
bool is_stated(const ActuationCandidate& candidate, const JointEvidence& evidence);

/// Whether one of these joints starts a chain on the body `base` that no closure holds while others are in
/// loops, and there are as many as a robot has: then a closure is missing, and no other joint is actuated in
/// its place. What is on the platform, as a gripper, is no leg.
bool lacks_a_leg(const ActuationCandidate& stated, const Tree& tree, const Bodies& bodies, std::size_t base,
                 const std::vector<bool>& in_loop);

/// What was taken as actuated, and from what.
struct TakenActuation {
  const Tree& tree;
  const JointEvidence& evidence;
  const std::vector<bool>& in_loop;    ///< for each joint value
  const std::vector<GraphPart>& legs;  ///< empty where these are not known
  const std::vector<std::size_t>& variables;
};

/// Joints that the URDF states to be actuated and that were not taken, each with the reason, and those that
/// were taken in their place; nothing where all that are stated were taken.
std::optional<std::string> note_on_stated(const TakenActuation& taken, const std::string& urdf_name);

/// Joints with more evidence than those that were taken, but that a <mimic> rules out; nothing
/// where there are none.
std::optional<ActuationCandidate> ruled_out_by_mimic(const TakenActuation& taken);

/// The sentence on these.
std::string note_on_mimic(const Tree& tree, const ActuationCandidate& ruled_out,
                          const std::string& urdf_name);

/// A body that may be the platform.
struct Platform {
  std::size_t body = 0;
  std::vector<std::size_t> links;            ///< best operational point first
  std::vector<std::vector<GraphPart>> legs;  ///< all of them; then without one passive chain
};

/// Bodies between which and the base legs are. Those that as many legs as possible share come first, then
/// those whose names say so, then those that a closure holds.
std::vector<Platform> platform_candidates(const Tree& tree, const Bodies& bodies, const BodyGraph& graph,
                                          std::size_t base, const std::vector<Closure>& closures,
                                          const SetupAnswers& answers);

/// The one body in the loops whose names say that it is the base, where those of `base`, at which the tree
/// starts, say that it is the platform.
std::optional<std::size_t> base_by_name(const Tree& tree, const Bodies& bodies, const BodyGraph& graph,
                                        std::size_t base);

/// Whether a closure holds a link.
bool is_closed(const std::vector<Closure>& closures, std::size_t link);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_ACTUATION_CANDIDATES_H
