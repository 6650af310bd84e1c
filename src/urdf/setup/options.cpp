// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/options.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <utility>

namespace parallel_aspects {
namespace {

std::string joined(const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : " ") + value;
  return text;
}

// Without the option's name where no option has this key.
std::string option_of(const std::string& key) {
  static const std::array<std::pair<std::string, std::string>, 4> options{
      {{"base_link", "--base"},
       {"operational_point", "--platform"},
       {"actuated_joints", "--actuated"},
       {"closures", "--closures"}}};
  for (const auto& [known, option] : options)
    if (known == key) return option;
  return "";
}

// "a, b" of a list in YAML.
std::vector<std::string> names_in(std::string list) {
  std::vector<std::string> names;
  for (std::size_t comma = list.find(", "); comma != std::string::npos; comma = list.find(", ")) {
    names.push_back(list.substr(0, comma));
    list.erase(0, comma + 2);
  }
  names.push_back(list);
  return names;
}

// "{frames: [a, {link: b, xyz: [1, 0, 0], rpy: [0, 0, 0]}]}, ..." of a list in YAML as "a=b@1:0:0 ...". How
// the frames are turned matters to no type but those that setup finds out.
std::string pairs_in(std::string list) {
  static const std::regex place(
      R"(\{link: ([^,}]+), xyz: \[([^,]+), ([^,]+), ([^\]]+)\], rpy: \[[^\]]*\]\})"),
      pair(R"(\{frames: \[([^,]+), ([^\]]+)\]\}(?:, )?)");
  list = std::regex_replace(std::regex_replace(list, place, "$1@$2:$3:$4"), pair, "$1=$2 ");
  return list.substr(0, list.size() - 1);
}

std::string said_of_option(const std::smatch& found) {
  if (found[4].matched) return option_for("closures", {pairs_in(found[4])});
  if (found[1].matched) return option_for("actuated_joints", names_in(found[1]));
  if (found[2].matched) return option_of(found[2]) + " " + found[3].str();
  return found[5].matched ? option_of(found[5]) : found.str();
}

}  // namespace

std::string shell_word(const std::string& word) {
  const auto is_plain = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
           std::string("_-./=+:,@%").find(letter) != std::string::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

std::string option_for(const std::string& key, const std::vector<std::string>& values) {
  const std::string option = option_of(key);
  return option.empty() ? key : option + " " + shell_word(joined(values));
}

std::string options_for(const SetupDraft& draft) {
  std::string text;
  for (const auto& [key, candidate] :
       {std::pair<const char*, const SetupCandidate*>{"closures", &draft.closures},
        {"base_link", &draft.base_link},
        {"operational_point", &draft.operational_point},
        {"actuated_joints", &draft.actuated_joints}})
    if (!candidate->values.empty()) text += (text.empty() ? "" : " ") + option_for(key, candidate->values);
  return text;
}

std::string said_of_options(const std::string& problem, const std::string& config_name) {
  std::string text = problem;
  for (std::size_t at = 0; !config_name.empty() && (at = text.find(config_name, at)) != std::string::npos;)
    text.replace(at, config_name.size(), "this choice");
  // Names in quotation marks, as of a link 'base_link', stay as they are.
  static const std::regex keys(
      "'[^']*'|(?:mechanism\\.)?actuated_joints: \\[([^\\]]*)\\]|"
      "(?:mechanism\\.)?(base_link|operational_point): ([^ ;,]+)|"
      "mechanism\\.closures: \\[(\\{frames: .*\\]\\})\\]|"
      "(?:mechanism\\.)?\\b(base_link|operational_point|actuated_joints|closures)\\b(?:\\[\\d+\\]\\.frames)"
      "?");
  std::string said;
  std::smatch found;
  while (std::regex_search(text, found, keys)) {
    const bool is_word = found.str() == "closures";  // no key, but English
    said += found.prefix().str() + (is_word ? found.str() : said_of_option(found));
    text = found.suffix();
  }
  return said + text;
}

}  // namespace parallel_aspects
