// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/place_across.h"

namespace parallel_aspects {
namespace {

NodePlace image(const PoseSpace& space, const Gluing& gluing, const NodePlace& place,
                bool from_first) noexcept {
  const RootFace& to = from_first ? gluing.second : gluing.first;
  const std::uint32_t last = (std::uint32_t{1} << place.level) - 1;
  NodePlace there{{}, place.level, to.root};
  for (std::size_t i = 0; i < space.dimension(); ++i) {
    const std::uint32_t cell = place.cell[from_first ? i : gluing.axis_of[i]];
    there.cell[from_first ? gluing.axis_of[i] : i] = gluing.flipped[i] ? last - cell : cell;
  }
  there.cell[to.axis] = to.upper ? last : 0;
  return there;
}

}  // namespace

std::optional<NodePlace> place_across(const PoseSpace& space, const NodePlace& place,
                                      const NodeFace& face) noexcept {
  const std::uint32_t last = (std::uint32_t{1} << place.level) - 1;
  if (place.cell[face.axis] != (face.upper ? last : 0)) {
    NodePlace there = place;
    there.cell[face.axis] += face.upper ? 1U : ~0U;
    return there;
  }
  const RootFace end{place.root, static_cast<std::uint8_t>(face.axis), face.upper};
  for (const Gluing& gluing : space.gluings())
    if (gluing.first == end || gluing.second == end) return image(space, gluing, place, gluing.first == end);
  return std::nullopt;
}

}  // namespace parallel_aspects
