// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_NUMBERS_H
#define PARALLEL_ASPECTS_TOOLS_NUMBERS_H

#include "parallel_aspects/model/problems.h"

#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// Each returns what `text` says; where it says nothing of use, a message that names `option` is added to
/// `problems` and the value is of no meaning.

/// A finite number greater than zero.
double parse_positive(const std::string& option, const std::string& text, Problems& problems);

/// A whole number from `least` to `largest`.
unsigned parse_count(const std::string& option, const std::string& text, unsigned largest, Problems& problems,
                     unsigned least = 0);

/// One finite number for each of `names`, separated by blanks or commas.
std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                  const std::vector<std::string>& names, Problems& problems);

/// Whether a text is one finite number or more, separated by blanks or commas.
bool holds_numbers(const std::string& text);

/// The words of a text, separated by blanks or commas.
std::vector<std::string> split_words(std::string text);

/// What stands before, between and after these separators; empty parts count, too.
std::vector<std::string> split_at(char separator, const std::string& text);

/// The words of a list such as "z=0.5 roll = 0", separated by blanks or commas, without blanks around "=".
std::vector<std::string> words_of_list(std::string text);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_NUMBERS_H
