// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/culprits/shared_frames.h"

#include "urdf/corrections/anchors.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace parallel_aspects {
namespace {

// Those that hold its origin.
std::size_t closures_at(std::size_t link, const std::vector<Closure>& closures) {
  const auto is_origin = [link](const LinkFrame& frame) {
    return frame.link == link && frame.in_link.translation().isZero();
  };
  return static_cast<std::size_t>(std::count_if(
      closures.begin(), closures.end(),
      [&](const Closure& closure) { return is_origin(closure.frames[0]) || is_origin(closure.frames[1]); }));
}

std::string without_digits(std::string name) {
  const auto is_digit = [](unsigned char letter) { return std::isdigit(letter) != 0; };
  name.erase(std::remove_if(name.begin(), name.end(), is_digit), name.end());
  return name;
}

bool has_child(const Tree& tree, std::size_t link) {
  return std::any_of(tree.joints.begin(), tree.joints.end(),
                     [link](const TreeJoint& joint) { return joint.parent == link; });
}

// Links of one body, the other of which carries nothing, whose names differ in digits alone.
bool are_numbered_alike(const Tree& tree, std::size_t one, std::size_t other) {
  return one != other && body_of(tree, one) == body_of(tree, other) && !has_child(tree, other) &&
         without_digits(tree.links[one]) == without_digits(tree.links[other]);
}

}  // namespace

std::vector<std::string> shared_frame_notes(const Tree& tree, const std::vector<Closure>& closures) {
  std::vector<std::string> notes;
  for (std::size_t link = 0; link < tree.links.size(); ++link) {
    const auto own_frames = closures_at(link, closures);
    if (own_frames < 2) continue;
    for (std::size_t other = 0; other < tree.links.size(); ++other)
      if (are_numbered_alike(tree, link, other) && closures_at(other, closures) == 0) {
        notes.push_back(
            "Link '" + tree.links[link] + "' is in " +
            (own_frames == 2 ? "two" : std::to_string(own_frames)) + " closures, and '" + tree.links[other] +
            "' of the same body in none; where each joint has its own link, correct the closures.");
        break;
      }
  }
  return notes;
}

}  // namespace parallel_aspects
