// SPDX-License-Identifier: BSD-3-Clause
#include "tools/numbers.h"

#include "tools/report/report.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <regex>
#include <sstream>

namespace parallel_aspects::tools {
namespace {

std::optional<double> finite_number(const std::string& text) {
  if (text.empty() || std::isspace(static_cast<unsigned char>(text.front())) != 0) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool whole = end == text.c_str() + text.size();
  return whole && std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

}  // namespace

std::vector<std::string> split_words(std::string text) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

bool holds_numbers(const std::string& text) {
  const std::vector<std::string> words = split_words(text);
  return !words.empty() && std::all_of(words.begin(), words.end(), [](const std::string& word) {
    return finite_number(word).has_value();
  });
}

std::vector<std::string> split_at(char separator, const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == separator)
      parts.emplace_back();
    else
      parts.back() += letter;
  }
  return parts;
}

std::vector<std::string> words_of_list(std::string text) {
  static const std::regex around_equals("\\s*=\\s*");
  return split_words(std::regex_replace(text, around_equals, "="));
}

double parse_positive(const std::string& option, const std::string& text, Problems& problems) {
  const std::optional<double> value = finite_number(text);
  if (!value || !(*value > 0.0))
    problems.push_back(option + " is '" + text + "'; give a finite number greater than zero, such as 0.05.");
  return value.value_or(0.0);
}

unsigned parse_count(const std::string& option, const std::string& text, unsigned largest, Problems& problems,
                     unsigned least) {
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  const double value = digits ? finite_number(text).value_or(largest + 1.0) : largest + 1.0;
  if (value >= least && value <= largest) return static_cast<unsigned>(value);
  problems.push_back(option + " is '" + text + "'; give a whole number from " + std::to_string(least) +
                     " to " + std::to_string(largest) + ".");
  return least;
}

namespace {

/// Numbers as answers print them, each behind its name: without the names.
std::vector<std::string> without_names(std::vector<std::string> words,
                                       const std::vector<std::string>& names) {
  if (words.size() != 2 * names.size()) return words;
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (words[2 * i] != names[i]) return words;
    numbers.push_back(words[2 * i + 1]);
  }
  return numbers;
}

}  // namespace

std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                  const std::vector<std::string>& names, Problems& problems) {
  const std::vector<std::string> given = without_names(split_words(text), names);
  if (given.size() != names.size())
    problems.push_back(option + " has " + counted(given.size(), "number") + ", but needs " +
                       std::to_string(names.size()) + ": \"" + joined(names, " ") + "\".");
  std::vector<double> values;
  for (const std::string& word : given) {
    const std::optional<double> value = finite_number(word);
    if (!value) problems.push_back(option + " has '" + word + "', which is not a finite number; give one.");
    values.push_back(value.value_or(0.0));
  }
  return values;
}

}  // namespace parallel_aspects::tools
