// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_YAML_VALUES_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_YAML_VALUES_H

#include "parallel_aspects/model/problems.h"

#include <string>
#include <vector>

namespace YAML {
class Node;
}

namespace parallel_aspects {

/// The only document of a YAML file; null where it is empty. Throws YAML::ParserException where the text is
/// no YAML, holds another document, or, with each alias counted as what it stands for, says more than any
/// robot needs: a few lines of aliases can stand for gigabytes.
YAML::Node yaml_document(const std::string& text);

}  // namespace parallel_aspects

namespace YAML {
class Node;
}

namespace parallel_aspects {

/// Reads single values of a YAML file. `where` names the key for people; what is wrong becomes a message
/// that starts with the name of the file. Each is false, with the value untouched, where there is nothing of
/// use.
class YamlValues {
 public:
  YamlValues(const std::string& file, Problems& problems) : file_(file), problems_(problems) {}

  /// Adds "FILE `message`".
  void problem(const std::string& message) const { problems_.push_back(file_ + " " + message); }

  /// Keys that belong into another part of the file.
  struct OtherPart {
    std::string name;
    std::vector<std::string> keys;
  };

  /// Unknown and repeated keys, and those that belong elsewhere.
  void check_keys(const YAML::Node& map, const std::vector<std::string>& known, const std::string& where,
                  const std::vector<OtherPart>& elsewhere = {}) const;

  /// Whether it is a map; `help` says what to write.
  bool map(const YAML::Node& node, const std::string& where, const std::string& help) const;

  bool text(const YAML::Node& node, const std::string& where, std::string& value) const;
  bool truth(const YAML::Node& node, const std::string& where, bool& value) const;
  bool number(const YAML::Node& node, const std::string& where, double& value) const;
  bool numbers(const YAML::Node& node, const std::string& where, std::vector<double>& values) const;

 private:
  const std::string& file_;
  Problems& problems_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_YAML_VALUES_H
