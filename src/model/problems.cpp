// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/problems.h"

#include <utility>

namespace parallel_aspects {
namespace {

std::string one_per_line(const Problems& problems) {
  std::string text;
  for (const std::string& problem : problems) text += (text.empty() ? "" : "\n") + problem;
  return text;
}

Problems at_least_one(Problems problems) {
  if (problems.empty())
    problems.emplace_back(
        "The description is refused, and no reason was found; please report this as an error.");
  return problems;
}

}  // namespace

InvalidDescription::InvalidDescription(Problems problems)
    : std::runtime_error(one_per_line(at_least_one(problems))),
      problems_(at_least_one(std::move(problems))) {}

}  // namespace parallel_aspects
