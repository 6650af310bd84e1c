// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_CLOSED_SEARCH_H
#define PARALLEL_ASPECTS_URDF_SETUP_CLOSED_SEARCH_H

#include "urdf/setup/actuation_candidates.h"
#include "urdf/setup/body_graph.h"
#include "urdf/setup/setup.h"
#include "urdf/setup/setup_config.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The URDF that is looked at.
struct SetupSubject {
  const Tree& tree;
  const Bodies& bodies;
  const JointEvidence& evidence;
  const std::string& urdf_text;
  const std::string& urdf_name;
  const std::string& config_name;
  const SetupAnswers& answers;
  const SetupControl& control;
};

/// What these closures came to: a mechanism, a question, or problems.
struct ClosedResult {
  SetupDraft draft;
  std::shared_ptr<const Mechanism> mechanism;
  std::optional<SetupQuestion> question;
  Problems problems;  ///< of what was tried first
  std::vector<SetupDraft>
      tried;  ///< first, and then for other platforms; empty where there was nothing to try
  std::vector<std::string> notes;  ///< on the actuated joints, a sentence each
  std::size_t joints_in_loops = 0;
  bool cut_short = false;
};

/// What is tried, for messages that name it: no file has it.
inline constexpr const char* name_of_choice = "this choice";

/// Looks for base, platform and actuated joints with these closures, and tries them. `described` is what
/// stands in the YAML for them: nothing where the URDF describes them.
ClosedResult search_closed(const SetupSubject& subject, const std::vector<Closure>& closures,
                           const SetupCandidate& described, bool adds_closures = false);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_CLOSED_SEARCH_H
