// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_LOAD_MECHANISM_H
#define PARALLEL_ASPECTS_URDF_LOAD_MECHANISM_H

#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <functional>
#include <string>

namespace parallel_aspects {

/// Thrown where corrections were tried that make a robot of a description; its problems name them.
class CorrectableDescription : public InvalidDescription {
 public:
  using InvalidDescription::InvalidDescription;
};

/// How a mechanism is looked for.
struct LoadSearch {
  /// Called before each attempt to assemble the mechanism; may throw, which ends the search.
  std::function<void()> checkpoint = [] {};
  /// Whether a refusal names what would correct the description, which takes most of its time.
  bool looks_for_remedies = true;
  /// Whether messages speak of the YAML as of options of a command; see `SourceNames`.
  bool as_options = false;
};

/// `load_mechanism` for those who load many, of which most are refused.
SharedMechanism load_mechanism(const std::string& urdf_text, const std::string& urdf_name,
                               const std::string& config_text, const std::string& config_name,
                               const std::string& frame_prefix, const LoadSearch& search);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_LOAD_MECHANISM_H
