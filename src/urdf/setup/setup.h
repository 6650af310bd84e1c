// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_SETUP_H
#define PARALLEL_ASPECTS_URDF_SETUP_SETUP_H

#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// What the user knows; what is empty is to be found. A link that closes a loop or is the operational point
/// may be a place in the frame of a link, "rod_2@0.4:0:0" [m], and turned, "rod_2@0.4:0:0:0:1.57:0" [rad].
/// Closures are added to those that the URDF
/// describes, unless they close the same loops.
struct SetupAnswers {
  std::string base_link;
  std::string operational_point;
  std::vector<std::string> actuated_joints;
  std::vector<std::array<std::string, 2>> closures;
};

/// One value that a key of the YAML may have, with its reason. Links of a closure have '=' between
/// them.
struct SetupCandidate {
  std::vector<std::string> values;
  std::string reason;
};

/// What was taken for a key of the YAML, and what else would do.
struct SetupChoice {
  std::string key;
  SetupCandidate taken;
  std::vector<SetupCandidate> others;
};

/// What the URDF does not state, and candidates with equal evidence; there may be none.
struct SetupQuestion {
  std::string key;
  std::string text;  ///< one sentence
  std::vector<SetupCandidate> candidates;
  std::vector<std::string> example;  ///< where there are none: what an answer looks like
};

/// When to give up, and what for. All are examined before each attempt to assemble the mechanism. Work is
/// counted and not timed, so that no answer depends on the machine or on what else it does.
struct SetupControl {
  std::size_t work = 0;  ///< attempts, each times the square of the number of joints in the loops, as counted
  std::function<bool()> cancelled = [] { return false; };
  /// By the clock on the wall, for those who wait while other programs have the processor.
  std::chrono::steady_clock::time_point latest = std::chrono::steady_clock::time_point::max();
  std::shared_ptr<std::size_t> done = std::make_shared<std::size_t>(0);  ///< of the work, by all copies

  /// What an attempt takes whatever the joints are, as closing loops that do not close, in as many joints.
  static constexpr std::size_t least_joints = 8;

  void count_attempt(std::size_t joints) const {
    const std::size_t counted = std::max(joints, least_joints);
    *done += counted * counted;
  }
  bool is_over() const { return cancelled() || *done >= work || std::chrono::steady_clock::now() > latest; }
};

/// What a bare URDF came to: a mechanism, a question, or problems.
struct SetupResult {
  std::string robot;
  std::vector<SetupChoice> choices;
  std::string config;                          ///< YAML with a comment for each guess; empty where none loads
  std::shared_ptr<const Mechanism> mechanism;  ///< what `config` makes of the URDF
  std::optional<SetupQuestion> question;
  Problems problems;
  std::vector<std::string> notes;  ///< on the URDF, a sentence each
  bool is_serial_arm = false;      ///< an open tree with one chain, of which `set_up_arm` writes the YAML
  bool cut_short = false;          ///< by the deadline, or since there are too many combinations
};

/// Looks for base, loop closures, platform and actuated joints of the URDF, and tries what it finds with
/// `load_mechanism`. It never chooses between candidates with equal evidence. The names are those of files,
/// for messages and comments.
SetupResult set_up(const std::string& urdf_text, const std::string& urdf_name, const std::string& config_name,
                   const SetupAnswers& answers, const SetupControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_SETUP_H
