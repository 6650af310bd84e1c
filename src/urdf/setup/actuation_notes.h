// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_ACTUATION_NOTES_H
#define PARALLEL_ASPECTS_URDF_SETUP_ACTUATION_NOTES_H

#include "urdf/setup/actuation_candidates.h"
#include "urdf/setup/body_graph.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

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

/// The joints that more speaks for than for those that were taken, but that a <mimic> rules out; nothing
/// where there are none.
std::optional<ActuationCandidate> ruled_out_by_mimic(const TakenActuation& taken);

/// The sentence on these.
std::string note_on_mimic(const Tree& tree, const ActuationCandidate& ruled_out,
                          const std::string& urdf_name);

/// The URDF without the <mimic> of these joints.
std::string without_mimic(const std::string& urdf_text, const Tree& tree,
                          const std::vector<std::size_t>& variables);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_ACTUATION_NOTES_H
