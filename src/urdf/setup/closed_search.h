// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_CLOSED_SEARCH_H
#define PARALLEL_ASPECTS_URDF_SETUP_CLOSED_SEARCH_H

#include "urdf/setup/actuation_candidates.h"
#include "urdf/setup/body_graph.h"
#include "urdf/setup/setup.h"
#include "urdf/setup/setup_config.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The URDF that is examined.
struct SetupSubject {
  const Tree& tree;                              ///< with places of answers as links
  const std::shared_ptr<const Tree>& tree_read;  ///< without
  const Bodies& bodies;
  const JointEvidence& evidence;
  const std::string& urdf_name;
  const std::string& config_name;
  const SetupAnswers& answers;
  SetupControl control;
};

/// Closures to be tried, the first of which the URDF describes.
struct SetupClosures {
  std::vector<Closure> all;
  std::size_t described = 0;
  std::string dialect{};  ///< of those
};

/// What these closures came to: a mechanism, a question, or problems.
struct ClosedResult {
  SetupDraft draft;
  std::shared_ptr<const Mechanism> mechanism;
  std::optional<SetupQuestion> question;
  Problems problems;        ///< of what was tried first
  bool is_refused = false;  ///< by these, and not for want of time
  std::vector<SetupDraft>
      tried;  ///< first, and then for other platforms; empty where there was nothing to try
  SetupClosures closures;
  std::vector<std::string> notes;  ///< on the actuated joints, a sentence each
  std::size_t joints_in_loops = 0;
  bool cut_short = false;
};

/// The robot that a draft makes with these closures; problems where it makes none, unless there is no time.
/// `explained`: whether they are as `ExplainedDescription` has them.
std::shared_ptr<const Mechanism> tried(const SetupSubject& subject, const SetupDraft& draft,
                                       const SetupClosures& closures, std::size_t joints_in_loops,
                                       bool looks_for_remedies, Problems& problems,
                                       bool* explained = nullptr);

/// Looks for base, platform and actuated joints with these closures, and tries them. `described` is what
/// stands in the YAML for them: nothing where the URDF describes them.
ClosedResult search_closed(const SetupSubject& subject, SetupClosures closures,
                           const SetupCandidate& described);

struct Refusal {
  Problems problems;
  bool is_explained = false;  ///< whether they say what makes a robot of it, or that nothing does
};

/// Why what was tried makes no robot, in the words of the options, with what would correct it where that is
/// found in time: of what was tried first, and else of what was tried for other platforms.
Refusal refusal_of(const SetupSubject& subject, const ClosedResult& found);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_CLOSED_SEARCH_H
