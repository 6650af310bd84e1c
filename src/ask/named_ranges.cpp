// SPDX-License-Identifier: BSD-3-Clause
#include "ask/named_ranges.h"

#include "model/number_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace parallel_aspects::ask {
namespace {

std::string text_of(const NamedRange& range) {
  return "'" + range.name + "=" + number_text(range.lower) + ":" + number_text(range.upper) + "'";
}

}  // namespace

std::string example_of_ranges(const std::vector<std::string>& names) {
  std::string text;
  bool has_angle = false;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : " ") + name + "=-1:1";
    has_angle = has_angle || (name != "x" && name != "y" && name != "z");
  }
  return "\"" + text + (has_angle ? "\", in m and rad" : "\", in m");
}

Box box_of(const std::string& field, const std::vector<std::string>& names,
           const std::vector<NamedRange>& ranges, ProblemList& problems) {
  Box box{names.size(), {}, {}};
  std::vector<bool> given(names.size(), false);
  const auto refuse = [&](const std::string& fault, const std::string& remedy) {
    problems.push_back({ProblemKind::value, field, "{" + field + "} " + fault, remedy});
  };
  const std::string example = "give " + example_of_ranges(names);
  for (const NamedRange& range : ranges) {
    const auto name = std::find(names.begin(), names.end(), range.name);
    if (name == names.end()) {
      refuse("has " + text_of(range), example);
      continue;
    }
    const auto i = static_cast<std::size_t>(name - names.begin());
    if (given[i]) refuse("names " + *name + " twice", "give one range");
    given[i] = true;
    if (!std::isfinite(range.lower) || !std::isfinite(range.upper))
      refuse("has " + text_of(range) + ", which is not finite", example);
    else if (!(range.lower < range.upper))
      refuse("has " + text_of(range) + ", whose lower end is not below the upper", example);
    box.lower[i] = range.lower;
    box.upper[i] = range.upper;
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!given[i]) refuse("does not say where " + names[i] + " may be", example);
  return box;
}

}  // namespace parallel_aspects::ask
