// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_PLACED_FRAMES_H
#define PARALLEL_ASPECTS_URDF_SETUP_PLACED_FRAMES_H

#include "urdf/description/command_options.h"
#include "urdf/description/tree.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A place in the frame of a link that has no link of its own, written "rod_2@0.4:0:0".
struct PlacedFrame {
  std::string link;
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();  ///< in the frame of the link [m]
};

/// Nothing where the text is not written so, as the name of a link.
std::optional<PlacedFrame> placed_frame(const std::string& text);

/// Adds it to the tree as a link of that name, fixed to the link that it is in. Does nothing for any other
/// text, or where that link is missing.
void add_placed_frame(Tree& tree, const std::string& text);

/// That ends of these closures are given at a place which another like link has the other end at: a length of
/// that one, as where the plate is on the first of six pins. With the closures at the origins of the links.
std::optional<std::string> note_on_borrowed_lengths(const Tree& tree,
                                                    std::vector<std::array<std::string, 2>> closures);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_PLACED_FRAMES_H
