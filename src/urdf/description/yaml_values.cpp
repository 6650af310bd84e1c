// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/yaml_values.h"

#include "urdf/description/nearest_name.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_set>

namespace parallel_aspects {
void YamlValues::check_keys(const YAML::Node& map, const std::vector<std::string>& known,
                            const std::string& where, const std::vector<OtherPart>& elsewhere) const {
  std::vector<std::string> keys;
  for (const auto& entry : map) keys.push_back(entry.first.IsScalar() ? entry.first.Scalar() : "");
  std::vector<std::string> unused;
  std::copy_if(known.begin(), known.end(), std::back_inserter(unused),
               [&](const std::string& key) { return !contains(keys, key); });
  std::unordered_set<std::string> seen;
  for (const std::string& key : keys) {
    const auto part = std::find_if(elsewhere.begin(), elsewhere.end(),
                                   [&](const OtherPart& other) { return contains(other.keys, key); });
    if (!contains(known, key) && part != elsewhere.end()) {
      problem("has the key '" + key + "' under " + where + "; write it under '" + part->name + "'.");
    } else if (!contains(known, key)) {
      const bool may_be_new = !similar_name(key, unused).empty();
      const std::string used = may_be_new ? "" : similar_name(key, known);
      problem("has an unknown key '" + key + "' under " + where +
              (used.empty() ? suggestion(key, may_be_new ? unused : known, problems_)
                            : "; remove it, as '" + used + "' is there."));
    }
    if (!seen.insert(key).second)
      problem("has the key '" + key + "' twice under " + where + "; keep one of them.");
  }
}

bool YamlValues::map(const YAML::Node& node, const std::string& where, const std::string& help) const {
  if (!node.IsDefined()) return false;
  if (!node.IsMap()) problem("has a " + where + " that is not a map of keys; " + help + ".");
  return node.IsMap();
}

bool YamlValues::text(const YAML::Node& node, const std::string& where, std::string& value) const {
  if (!node.IsDefined()) return false;
  if (!node.IsScalar() || node.Scalar().empty()) {
    problem("has a " + where + " that is not a text; give one name.");
    return false;
  }
  value = node.Scalar();
  return true;
}

bool YamlValues::truth(const YAML::Node& node, const std::string& where, bool& value) const {
  if (!node.IsDefined()) return false;
  if (node.IsScalar() && YAML::convert<bool>::decode(node, value)) return true;
  problem("has a " + where + " that is neither true nor false; write one of them.");
  return false;
}

bool YamlValues::number(const YAML::Node& node, const std::string& where, double& value) const {
  if (!node.IsDefined()) return false;
  double read = 0.0;
  if (node.IsScalar() && YAML::convert<double>::decode(node, read) && std::isfinite(read)) {
    value = read;
    return true;
  }
  problem("has a " + where + " that is not a finite number; give one.");
  return false;
}

bool YamlValues::numbers(const YAML::Node& node, const std::string& where,
                         std::vector<double>& values) const {
  if (!node.IsDefined()) return false;
  if (!node.IsSequence()) {
    problem("has a " + where +
            " that is not a list of numbers; write them in brackets, with commas between them.");
    return false;
  }
  bool good = true;
  std::vector<double> read(node.size());
  for (std::size_t k = 0; k < node.size(); ++k)
    good = number(node[k], where + "[" + std::to_string(k) + "]", read[k]) && good;
  if (good) values = read;
  return good;
}

}  // namespace parallel_aspects
