// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/yaml_values.h"

#include "urdf/description/nearest_name.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace parallel_aspects {
namespace {

using YAML::anchor_t;
using YAML::Mark;

constexpr std::size_t max_characters = 200000;  // a shipped robot has less than a thousand
constexpr std::size_t max_levels = 100;         // of lists and maps in one another

// Counts while the text is read, and stops it early. What follows a closing quote or bracket is a document of
// its own to yaml-cpp, and a stray comma begins one without end, so that LoadAll never returns.
class SizeLimit : public YAML::EventHandler {
 public:
  void OnDocumentStart(const Mark& mark) override {
    if (++documents_ > 1)
      throw YAML::ParserException(
          mark,
          "a second document begins, by '---' or by a comma or text that follows no key, and one is read");
  }
  void OnDocumentEnd() override {}

  void OnNull(const Mark& mark, anchor_t anchor) override { add(mark, anchor, 1); }
  void OnScalar(const Mark& mark, const std::string&, anchor_t anchor, const std::string& value) override {
    add(mark, anchor, 1 + value.size());
  }
  void OnAlias(const Mark& mark, anchor_t anchor) override {
    const auto meant = sizes_.find(anchor);
    if (meant == sizes_.end()) throw YAML::ParserException(mark, "an alias stands inside what it stands for");
    add(mark, {}, meant->second);
  }

  void OnSequenceStart(const Mark& mark, const std::string&, anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const Mark& mark, const std::string&, anchor_t anchor, YAML::EmitterStyle::value) override {
    open(mark, anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  struct Collection {
    anchor_t anchor;
    std::size_t before;  // of all characters
  };

  void add(const Mark& mark, anchor_t anchor, std::size_t characters) {
    characters_ += characters;
    if (characters_ > max_characters)
      throw YAML::ParserException(mark, "more than " + std::to_string(max_characters) +
                                            " characters are said, each alias counted as what it "
                                            "stands for");
    sizes_[anchor] = characters;
  }

  void open(const Mark& mark, anchor_t anchor) {
    if (open_.size() == max_levels)
      throw YAML::ParserException(
          mark, "more than " + std::to_string(max_levels) + " lists and maps lie in one another");
    open_.push_back({anchor, characters_});
    add(mark, {}, 1);
  }

  void close() {
    sizes_[open_.back().anchor] = characters_ - open_.back().before;
    open_.pop_back();
  }

  std::size_t documents_ = 0, characters_ = 0;
  std::vector<Collection> open_;
  std::unordered_map<anchor_t, std::size_t> sizes_;  // of what has an anchor; all else is 0
};

}  // namespace

YAML::Node yaml_document(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  SizeLimit limit;
  while (parser.HandleNextDocument(limit)) {
  }
  return YAML::Load(text);
}

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
