// SPDX-License-Identifier: BSD-3-Clause
#include "ask/named_ranges.h"
#include "tools/arguments.h"

namespace parallel_aspects::tools {

Box parse_region(const std::string& option, const std::vector<std::string>& names, const std::string& text,
                 Problems& problems) {
  const auto ranges = parse_ranges(option, text, problems, ask::example_of_ranges(names));
  ask::ProblemList found;
  const Box box = ask::box_of("region", names, ranges, found);
  for (const std::string& each : texts_of(found, [&option](const std::string&) { return option; }))
    problems.push_back(each);
  return box;
}

}  // namespace parallel_aspects::tools
