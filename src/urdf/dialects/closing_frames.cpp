// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/closure_dialects.h"

#include <regex>

namespace parallel_aspects::dialects {

DescribedLoops closing_frames(const LoopSource& source, Problems& problems) {
  static const std::regex first("(closing_.+)_(1|A)");
  DescribedLoops loops;
  for (std::size_t link = 0; link < source.tree.links.size(); ++link) {
    std::smatch parts;
    if (!std::regex_match(source.tree.links[link], parts, first)) continue;
    const std::string other = parts[1].str() + (parts[2] == "1" ? "_2" : "_B");
    const auto found = source.tree.link_named(other);
    if (found) {
      loops.closures.push_back({parts[1], {LinkFrame{link}, LinkFrame{*found}}, ClosureType::automatic});
    } else {
      problems.push_back(source.files.urdf + " has the closing frame '" + source.tree.links[link] +
                         "' but no '" + other + "'; add it, or list the closures in " + source.files.config +
                         ".");
    }
  }
  return loops;
}

}  // namespace parallel_aspects::dialects
