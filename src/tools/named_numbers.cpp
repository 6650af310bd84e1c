// SPDX-License-Identifier: BSD-3-Clause
#include "tools/arguments.h"
#include "tools/numbers.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace parallel_aspects::tools {
namespace {

/// The name and the numbers behind it, with colons between them; nothing, with a message, for another text.
std::optional<std::pair<std::string, std::vector<double>>> named_numbers(const std::string& option,
                                                                         const std::string& word,
                                                                         std::size_t count,
                                                                         const std::string& example,
                                                                         Problems& problems) {
  const std::size_t equals = word.find('=');
  const auto parts = split_at(':', equals == std::string::npos ? "" : word.substr(equals + 1));
  if (equals == std::string::npos || equals == 0 || parts.size() != count) {
    problems.push_back(option + " has '" + word + "'; give " + example + ".");
    return std::nullopt;
  }
  const std::size_t known = problems.size();
  std::vector<double> numbers;
  for (const std::string& part : parts)
    for (const double number : parse_numbers(option, part, {word.substr(0, equals)}, problems))
      numbers.push_back(number);
  if (problems.size() > known) {  // told already; what follows says no more of it
    numbers.resize(count);
    std::iota(numbers.begin(), numbers.end(), 0.0);
  }
  return std::pair{word.substr(0, equals), std::move(numbers)};
}

}  // namespace

std::vector<double> parse_ratio(const std::string& option, std::string text, Problems& problems) {
  std::replace(text.begin(), text.end(), ':', ' ');
  std::vector<double> numbers;
  for (const std::string& word : split_words(text))
    for (const double number : parse_numbers(option, word, {"number"}, problems)) numbers.push_back(number);
  return numbers;
}

std::vector<HeldCoordinate> parse_values(const std::string& option, const std::string& text,
                                         Problems& problems) {
  std::vector<HeldCoordinate> values;
  for (const std::string& word : words_of_list(text))
    if (auto found = named_numbers(option, word, 1, "names with their values, such as \"x=0.5\"", problems))
      values.push_back({std::move(found->first), found->second[0]});
  return values;
}

std::vector<ask::NamedRange> parse_ranges(const std::string& option, const std::string& text,
                                          Problems& problems, const std::string& example) {
  std::vector<ask::NamedRange> ranges;
  for (const std::string& word : words_of_list(text))
    if (auto found = named_numbers(option, word, 2, example, problems))
      ranges.push_back({std::move(found->first), found->second[0], found->second[1]});
  return ranges;
}

}  // namespace parallel_aspects::tools
