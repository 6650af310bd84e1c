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

}  // namespace

InvalidDescription::InvalidDescription(Problems problems)
    : std::runtime_error(one_per_line(problems)), problems_(std::move(problems)) {}

}  // namespace parallel_aspects
