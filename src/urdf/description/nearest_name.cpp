// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/nearest_name.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_letters = 200;  // that are compared
constexpr std::size_t max_suggestions = 20;
constexpr std::size_t max_listed = 12;    // names in a message
constexpr std::size_t least_letters = 3;  // of a name that is a part of another

std::size_t edit_distance(std::string one, std::string other) {
  for (std::string* word : {&one, &other}) word->resize(std::min(word->size(), max_letters));
  std::vector<std::size_t> row(other.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= one.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= other.size(); ++j) {
      const std::size_t replaced = diagonal + (one[i - 1] == other[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

// A part of the other, or at most a third of the letters to change.
bool are_near(const std::string& one, const std::string& other) {
  const auto& [shorter, longer] =
      std::minmax(one, other, [](const std::string& a, const std::string& b) { return a.size() < b.size(); });
  if (shorter.size() >= least_letters && longer.find(shorter) != std::string::npos) return true;
  return 3 * edit_distance(one, other) <= longer.size();
}

std::string in_small_letters(std::string name) {
  for (char& letter : name) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return name;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

}  // namespace

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string similar_name(const std::string& word, const std::vector<std::string>& known) {
  const auto same_letters = std::find_if(known.begin(), known.end(), [&](const std::string& name) {
    return in_small_letters(name) == in_small_letters(word);
  });
  if (same_letters != known.end()) return *same_letters;
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
  if (nearest == known.end()) return {};
  if (are_near(word, *nearest)) return *nearest;
  const auto near =
      std::find_if(known.begin(), known.end(), [&](const auto& name) { return are_near(word, name); });
  return near == known.end() ? std::string() : *near;
}

std::vector<MeantName> meant_names(const std::vector<std::string>& expected,
                                   const std::vector<std::string>& written,
                                   const std::vector<std::string>& own) {
  std::vector<std::string> others;
  for (const std::string& name : written)
    if (!contains(own, name)) others.push_back(name);
  std::vector<MeantName> meant;
  for (const std::string& name : expected) {
    const std::string similar = contains(written, name) ? "" : similar_name(name, others);
    if (similar.empty()) continue;
    meant.push_back({name, similar});
    others.erase(std::find(others.begin(), others.end(), similar));
  }
  return meant;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                       const Problems& problems) {
  const std::string similar = problems.size() < max_suggestions ? similar_name(word, known) : "";
  if (!similar.empty()) return "; did you mean '" + similar + "'?";
  if (known.empty() || known.size() > max_listed) return "; correct it.";
  return "; there are " + listed(known) + ".";
}

}  // namespace parallel_aspects
