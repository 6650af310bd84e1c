// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/yaml_document.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <sstream>
#include <unordered_map>
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

}  // namespace parallel_aspects
