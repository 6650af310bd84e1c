// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/dialects/closure_dialects.h"

#include <algorithm>

namespace parallel_aspects::dialects {
namespace {

// X of `closing_X_1` and `closing_X_A`, with what comes before it; empty for any other name.
std::string closing_pair(const std::string& link) {
  const std::string start = "closing_";
  const std::size_t length = link.size() - std::min<std::size_t>(link.size(), 2);
  const std::string end = link.substr(length);
  const bool is_first = end == "_1" || end == "_A";
  return is_first && length > start.size() && link.compare(0, start.size(), start) == 0
             ? link.substr(0, length)
             : std::string();
}

}  // namespace

DescribedLoops closing_frames(const LoopSource& source, Problems& problems) {
  DescribedLoops loops;
  for (std::size_t link = 0; link < source.tree.links.size(); ++link) {
    const std::string& name = source.tree.links[link];
    const std::string pair = closing_pair(name);
    if (pair.empty()) continue;
    const std::string other = pair + (name.back() == '1' ? "_2" : "_B");
    const auto found = source.tree.link_named(other);
    if (found) {
      loops.closures.push_back({pair, {LinkFrame{link}, LinkFrame{*found}}, ClosureType::automatic});
    } else {
      problems.push_back(source.files.urdf + " has the closing frame '" + name + "' but no '" + other +
                         "'; add it, or list the closures in " + source.files.config + ".");
    }
  }
  return loops;
}

}  // namespace parallel_aspects::dialects
