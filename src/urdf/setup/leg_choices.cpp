// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/leg_choices.h"

#include "urdf/closing/actuation_choices.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

std::vector<JointMotion> motions_of(const Tree& tree, const GraphPart& part) {
  std::vector<JointMotion> motions;
  for (const std::size_t joint : part.variables) motions.push_back(tree.joint_of(joint).motion);
  return motions;
}

bool stands_out(const Tree& tree, const GraphPart& part, const std::vector<GraphPart>& others) {
  const auto motions = motions_of(tree, others.front());
  return others.size() > 1 && motions_of(tree, part) != motions &&
         std::all_of(others.begin(), others.end(),
                     [&](const GraphPart& other) { return motions_of(tree, other) == motions; });
}

}  // namespace

std::vector<std::vector<GraphPart>> leg_choices(const Tree& tree, const std::vector<GraphPart>& parts) {
  std::vector<std::vector<GraphPart>> choices;
  if (is_actuation_count(parts.size())) choices.push_back(parts);
  for (const bool closed : {false, true})
    for (std::size_t k = 0; k < parts.size(); ++k) {
      std::vector<GraphPart> others = parts;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      const bool fits = parts[k].closed == closed && is_actuation_count(others.size());
      if (fits && (!closed || stands_out(tree, parts[k], others))) choices.push_back(std::move(others));
    }
  return choices;
}

}  // namespace parallel_aspects
