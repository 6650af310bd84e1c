// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/culprits/loops_through_base.h"

#include "urdf/corrections/anchors.h"

#include <array>
#include <optional>

namespace parallel_aspects {

bool passes_base(const Tree& tree, std::size_t base, const Closure& closure) {
  const std::size_t body = body_of(tree, base);
  std::array<std::optional<std::size_t>, 2> starts;
  for (const std::size_t end : {0, 1})
    for (std::size_t at = body_of(tree, closure.frames[end].link); at != body;) {
      const auto joint = tree.joint_above[at];
      if (!joint) return false;
      starts.at(end) = joint;
      at = body_of(tree, tree.joints[*joint].parent);
    }
  return starts[0] != starts[1];
}

}  // namespace parallel_aspects
