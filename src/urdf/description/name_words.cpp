// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/name_words.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace parallel_aspects {
namespace {

using Words = std::set<std::string>;

// Bytes beyond ASCII belong to words.
enum class Letter { other, digit, small, capital };

Letter kind_of(char character) {
  const auto code = static_cast<unsigned char>(character);
  if (std::isdigit(code) != 0) return Letter::digit;
  if (std::isupper(code) != 0) return Letter::capital;
  return std::isalpha(code) != 0 || code > 127 ? Letter::small : Letter::other;
}

bool starts_word(Letter before, Letter letter) {
  return letter != before && !(before == Letter::capital && letter == Letter::small);
}

// The last of several capitals begins the word of the small letter after them: legBEnd is leg, b, end.
bool splits_capitals(Letter before, Letter letter, const std::vector<std::string>& words) {
  return before == Letter::capital && letter == Letter::small && words.back().size() > 1;
}

bool has_word(const std::string& name, const Words& known) {
  const std::vector<std::string> words = words_of(name);
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& word) { return known.count(word) > 0; });
}

// A number or a single letter, which counts legs.
bool is_index(const std::string& word) {
  return word.size() == 1 || std::all_of(word.begin(), word.end(),
                                         [](char character) { return kind_of(character) == Letter::digit; });
}

}  // namespace

std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words;
  Letter before = Letter::other;
  for (const char character : name.substr(0, name.rfind('@'))) {
    const Letter letter = kind_of(character);
    if (letter != Letter::other) {
      if (splits_capitals(before, letter, words)) {
        const std::string first(1, words.back().back());
        words.back().pop_back();
        words.push_back(first);
      }
      if (starts_word(before, letter)) words.emplace_back();
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(character)));
    }
    before = letter;
  }
  return words;
}

std::string role_of(const std::string& name) {
  std::string role;
  for (const std::string& word : words_of(name))
    role += (role.empty() ? "" : "_") + (is_index(word) ? std::string("#") : word);
  return role;
}

bool says_drive(const std::string& name) {
  static const Words words{"motor",  "mot",    "act",   "actuator", "actuated", "active",   "drive",
                           "driven", "driver", "servo", "crank",    "slider",   "carriage", "strut",
                           "piston", "biceps", "bicep", "input",    "prismatic"};
  return has_word(name, words) && !says_passive(name);
}

bool says_passive(const std::string& name) {
  static const Words words{"passive", "free", "unactuated", "undriven"};
  return has_word(name, words);
}

bool says_end(const std::string& name) {
  static const Words words{"tip", "end", "ee", "closing", "closure", "close", "loop"};
  return has_word(name, words);
}

bool says_fitting(const std::string& name) {
  static const Words words{"camera", "imu",     "sensor", "marker", "led", "light", "cover",
                           "screw",  "encoder", "laser",  "com",    "cog", "mass",  "optical",
                           "visual", "finger",  "thumb",  "jaw",    "claw"};
  return has_word(name, words);
}

int operational_point_likeness(const std::string& name) {
  static const Words tools{"tool", "tcp", "ee", "eef", "effector", "endeffector", "hand"};
  static const Words platforms{"platform", "moving",    "nacelle",   "flange",
                               "mobile",   "traveling", "travelling"};
  static const Words carriers{"gripper", "stage", "plate"};
  const int likeness = has_word(name, tools)       ? 200
                       : has_word(name, platforms) ? 100
                       : has_word(name, carriers)  ? 50
                                                   : 0;
  return likeness == 0 || says_base(name)
             ? 0
             : std::max(1, likeness - 10 * static_cast<int>(words_of(name).size()));
}

bool says_base(const std::string& name) {
  static const Words words{"base", "ground", "chassis"};
  return has_word(name, words);
}

namespace {

using Strings = std::vector<std::string>;

bool is_side(const std::string& word) {
  static const std::set<std::string> sides{"left",  "right", "front", "rear", "back",
                                           "upper", "lower", "inner", "outer"};
  return sides.count(word) > 0;
}

std::set<std::string> telling_words(const Tree& tree, std::size_t link,
                                    const std::vector<std::size_t>& members,
                                    const std::set<std::string>& common) {
  const Strings words = words_of(tree.links[link]);
  std::set<std::string> telling;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const bool of_all =
        members.size() > 1 && std::all_of(members.begin(), members.end(), [&](std::size_t other) {
          return words_of(tree.links[other])[k] == words[k];
        });
    if (is_index(words[k]) ? !of_all : common.count(words[k]) == 0) telling.insert(words[k]);
  }
  return telling;
}

// Where there is but one link, all its words may decide.
std::set<std::string> common_words(const Tree& tree, const std::vector<std::size_t>& links) {
  std::map<std::string, std::size_t> counts;
  for (const std::size_t link : links) {
    const Strings words = words_of(tree.links[link]);
    for (const std::string& word : std::set<std::string>(words.begin(), words.end())) ++counts[word];
  }
  std::set<std::string> common;
  for (const auto& [word, count] : counts)
    if (count == links.size() && links.size() > 1) common.insert(word);
  return common;
}

// The words of a name in whose place another of the names has another one, and the same ones elsewhere.
std::set<std::string> counting_words(const Tree& tree, std::size_t link,
                                     const std::vector<std::size_t>& links) {
  const Strings words = words_of(tree.links[link]);
  std::set<std::string> counting;
  for (const std::size_t other : links) {
    const Strings others = words_of(tree.links[other]);
    if (others.size() != words.size()) continue;
    const auto differ = std::mismatch(words.begin(), words.end(), others.begin());
    if (differ.first != words.end() && std::equal(differ.first + 1, words.end(), differ.second + 1))
      counting.insert(*differ.first);
  }
  return counting;
}

}  // namespace

EndLikeness::EndLikeness(const Tree& tree, const std::vector<std::size_t>& tips,
                         const std::vector<std::size_t>& anchors) {
  for (const auto* links : {&tips, &anchors}) {
    std::map<std::string, std::vector<std::size_t>> alike;
    for (const std::size_t link : *links) alike[role_of(tree.links[link])].push_back(link);
    const std::set<std::string> common = common_words(tree, *links);
    for (const std::size_t link : *links) counters_[link] = counting_words(tree, link, *links);
    for (const auto& [role, members] : alike)
      for (const std::size_t link : members) words_[link] = telling_words(tree, link, members, common);
  }
}

int EndLikeness::between(std::size_t one, std::size_t other) const {
  int likeness = 0;
  const auto counts = [&](const std::string& word) {
    return is_index(word) || is_side(word) ||
           (counters_.at(one).count(word) > 0 && counters_.at(other).count(word) > 0);
  };
  for (const std::string& word : words_.at(one))
    if (words_.at(other).count(word) > 0) likeness += counts(word) ? 3 : 1;
  return likeness;
}

}  // namespace parallel_aspects
