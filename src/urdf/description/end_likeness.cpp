// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/end_likeness.h"

#include "urdf/description/name_words.h"

#include <algorithm>

namespace parallel_aspects {
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

// Where there is but one link, all its words may tell.
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
