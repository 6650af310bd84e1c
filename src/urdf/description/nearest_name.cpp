// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/nearest_name.h"

#include <algorithm>
#include <numeric>

namespace parallel_aspects {
namespace {

constexpr std::size_t most_letters = 200;  // that are compared
constexpr std::size_t most_suggestions = 20;

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

}  // namespace

std::string nearest_name(const std::string& word, const std::vector<std::string>& known) {
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
  return nearest == known.end() ? std::string() : *nearest;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                       const Problems& problems) {
  return problems.size() < most_suggestions ? "; did you mean '" + nearest_name(word, known) + "'?"
                                            : "; correct it.";
}

std::string similar_name(const std::string& word, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(word, known);
  return 2 * edit_distance(word, nearest) <= std::max(word.size(), nearest.size()) ? nearest : std::string();
}

}  // namespace parallel_aspects
