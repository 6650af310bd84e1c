// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/culprits/shared_frames.h"

#include "urdf/corrections/anchors.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>

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

// Links of one body, the other of which carries nothing, whose names differ in digits alone.
bool are_numbered_alike(const Tree& tree, std::size_t one, std::size_t other) {
  return one != other && body_of(tree, one) == body_of(tree, other) && !has_child(tree, other) &&
         without_digits(tree.links[one]) == without_digits(tree.links[other]);
}

std::string digits_of(const std::string& name) {
  std::string digits;
  for (const char letter : name)
    if (std::isdigit(static_cast<unsigned char>(letter)) != 0) digits += letter;
  return digits;
}

// A closure that holds a link which another one holds, too, and a link of that number in none.
struct WrongNumber {
  const Closure* closure = nullptr;
  std::size_t meant = 0;
};

// By the number of the other end; nothing where it tells none.
std::optional<WrongNumber> wrong_number(const Tree& tree, const std::vector<Closure>& closures,
                                        std::size_t link, const std::vector<std::size_t>& free) {
  for (const Closure& closure : closures)
    for (const std::size_t end : {0, 1})
      for (const std::size_t other : free)
        if (closure.frames[end].link == link &&
            digits_of(tree.links[closure.frames[1 - end].link]) == digits_of(tree.links[other]))
          return WrongNumber{&closure, other};
  return std::nullopt;
}

std::vector<std::string> notes_of_numbers(const Tree& tree, const std::vector<Closure>& closures) {
  std::vector<std::string> notes;
  for (std::size_t link = 0; link < tree.links.size(); ++link) {
    const auto own_frames = closures_at(link, closures);
    if (own_frames < 2) continue;
    std::vector<std::size_t> free;
    for (std::size_t other = 0; other < tree.links.size(); ++other)
      if (are_numbered_alike(tree, link, other) && closures_at(other, closures) == 0) free.push_back(other);
    if (free.empty()) continue;
    const auto wrong = wrong_number(tree, closures, link, free);
    const std::string quoted = "'" + tree.links[wrong ? wrong->meant : free.front()] + "'";
    notes.push_back("Link '" + tree.links[link] + "' is in " +
                    (own_frames == 2 ? "two" : std::to_string(own_frames)) + " closures, and " + quoted +
                    " of the same body in none; where each joint has its own link, " +
                    (wrong ? "write link " + quoted + " in the place of '" + tree.links[link] +
                                 "' in closure '" + wrong->closure->name + "'."
                           : "correct the closures."));
  }
  return notes;
}

bool is_free_frame(const Tree& tree, const ResolvedConfig& resolved, std::size_t link, std::size_t body) {
  const auto joint = tree.joint_above[link];
  return joint && !tree.joints[*joint].variable && body_of(tree, link) == body && !has_child(tree, link) &&
         link != resolved.actuated_joints.platform_link && closures_at(link, resolved.closures) == 0 &&
         !tree.joints[*joint].origin.translation().isZero();
}

// Of the body of the platform.
std::vector<std::string> notes_of_shared_joints(const Tree& tree, const ResolvedConfig& resolved) {
  std::vector<std::string> notes;
  const std::size_t body = body_of(tree, resolved.actuated_joints.platform_link);
  const auto joint = tree.joint_above[body];
  for (const Closure& closure : resolved.closures)
    for (const LinkFrame& frame : closure.frames)
      for (std::size_t other = 0; joint && other < tree.links.size(); ++other)
        if (frame.link == body && frame.in_link.translation().isZero() &&
            is_free_frame(tree, resolved, other, body)) {
          const std::string link = "'" + tree.links[body] + "'", free = "'" + tree.links[other] + "'";
          notes.push_back("Closure '" + closure.name + "' holds link " + link + " where its joint '" +
                          tree.joints[*joint].name + "' is, so that two legs share a place, and " + free +
                          " of the same body is in no closure; if that is meant, write link " + free +
                          " in the place of " + link + " in closure '" + closure.name + "'.");
          break;
        }
  return notes;
}

}  // namespace

std::vector<std::string> shared_frame_notes(const Tree& tree, const ResolvedConfig& resolved, double size) {
  std::vector<std::string> notes = notes_of_numbers(tree, resolved.closures);
  if (!legs_share_anchors(tree, resolved, size)) return notes;
  for (const std::string& note : notes_of_shared_joints(tree, resolved)) notes.push_back(note);
  return notes;
}

}  // namespace parallel_aspects
