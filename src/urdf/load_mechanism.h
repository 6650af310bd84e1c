// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_LOAD_MECHANISM_H
#define PARALLEL_ASPECTS_URDF_LOAD_MECHANISM_H

#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "urdf/closing/resolved_config.h"
#include "urdf/config/mechanism_config.h"
#include "urdf/description/tree.h"

#include <functional>
#include <memory>
#include <string>

namespace parallel_aspects {

/// Thrown where it is known why a description makes no robot: its problems name edits of it that were tried
/// and make one, or why no edit can make it one.
class ExplainedDescription : public InvalidDescription {
 public:
  using InvalidDescription::InvalidDescription;
};

/// How a mechanism is searched for.
struct LoadSearch {
  /// Called before each attempt to assemble the mechanism; may throw, which ends the search.
  std::function<void()> checkpoint = [] {};
  /// Whether a refusal names what would correct the description, which takes most of its time.
  bool looks_for_remedies = true;
  /// Whether what is loaded is guessed, so that a platform on one hinge (R1) will not do.
  bool is_guess = false;
  /// Whether messages name options of a command in place of keys of the YAML; see `SourceNames`.
  bool as_options = false;
};

/// A description whose names have been looked up.
struct NamedDescription {
  std::shared_ptr<const Tree> tree;
  MechanismConfig config;  ///< of which constraints and home are not examined here
  ResolvedConfig resolved;
};

/// The mechanism that it makes, for those who try many, of which most are refused. Throws InvalidDescription.
std::unique_ptr<Mechanism::Contents> recognise_named(NamedDescription description, const SourceNames& files,
                                                     const LoadSearch& search);

/// `load_mechanism` with such a search.
SharedMechanism load_mechanism(const std::string& urdf_text, const std::string& urdf_name,
                               const std::string& config_text, const std::string& config_name,
                               const std::string& frame_prefix, const LoadSearch& search);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_LOAD_MECHANISM_H
