// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_SOURCE_NAMES_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_SOURCE_NAMES_H

#include <string>
#include <vector>

namespace parallel_aspects {

/// Names of files or parameters, for messages, and how these call what the YAML says.
struct SourceNames {
  std::string urdf;
  std::string config;
  bool as_options = false;  ///< no YAML was written: its values are those of options of a command

  /// "actuated_joints", or "--actuated".
  std::string key(const std::string& key) const;

  /// "mechanism.actuated_joints", or "--actuated".
  std::string full_key(const std::string& key) const;

  /// "base_link: a", or "--base a".
  std::string entry(const std::string& key, const std::string& value) const;

  /// "actuated_joints: [a, b]", or "--actuated 'a b'".
  std::string entry(const std::string& key, const std::vector<std::string>& values) const;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_SOURCE_NAMES_H
