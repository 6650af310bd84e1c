// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/nearest_name.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace parallel_aspects {
namespace {

constexpr std::size_t most_letters = 200;  // that are compared
constexpr std::size_t most_suggestions = 20;
constexpr std::size_t most_listed = 12;

std::size_t edit_distance(std::string one, std::string other) {
  for (std::string* word : {&one, &other}) word->resize(std::min(word->size(), most_letters));
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

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

}  // namespace

std::string similar_name(const std::string& word, const std::vector<std::string>& known) {
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
  const bool similar =
      nearest != known.end() && 2 * edit_distance(word, *nearest) <= std::max(word.size(), nearest->size());
  return similar ? *nearest : std::string();
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                       const Problems& problems) {
  const std::string similar = problems.size() < most_suggestions ? similar_name(word, known) : std::string();
  if (!similar.empty()) return "; did you mean '" + similar + "'?";
  return known.empty() || known.size() > most_listed
             ? "; correct it."
             : (known.size() == 1 ? "; there is " : "; there are ") + listed(known) + ".";
}

std::vector<std::string> others(const std::vector<std::string>& known, const std::vector<std::string>& used) {
  std::vector<std::string> rest;
  std::copy_if(known.begin(), known.end(), std::back_inserter(rest), [&](const std::string& name) {
    return std::find(used.begin(), used.end(), name) == used.end();
  });
  return rest;
}

}  // namespace parallel_aspects
