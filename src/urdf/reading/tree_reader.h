// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_READING_TREE_READER_H
#define PARALLEL_ASPECTS_URDF_READING_TREE_READER_H

#include "parallel_aspects/model/problems.h"
#include "urdf/description/messages.h"
#include "urdf/description/tree.h"

#include <tinyxml2.h>

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Parses the text of a URDF. Where it holds no <robot> element: what it is, and what to do, as "is a pointer
/// of Git LFS, not the file; fetch that with 'git lfs pull'.".
std::optional<std::string> parse_robot(const std::string& text, tinyxml2::XMLDocument& document);

/// A text in Latin-1, as older editors save it, in UTF-8; nothing where it is in UTF-8 as it is.
std::optional<std::string> from_latin_1(const std::string& text);

/// Reads the tree of a URDF. What is wrong is added to `problems`, what is taken with reservations to
/// `notes`; each a message that names `file` and the joint or link. Nothing is returned when there are
/// problems.
std::optional<Tree> read_tree(const std::string& text, const std::string& file, Problems& problems,
                              Notes& notes);

/// What urdfdom does not tell: it forgets the order of the joints, takes missing limits for zero, and passes
/// over or prints to the console much that is wrong.
struct UrdfInspection {
  std::string text;                      ///< the URDF, with empty limits where urdfdom insists on some
  std::vector<std::string> joints;       ///< names, in the order of the file
  std::set<std::string> without_limits;  ///< revolute and prismatic joints that state none
  std::set<std::string> mimics;          ///< joints that follow another one
  /// Roll, pitch and yaw of the origins of joints, where one is beyond a full turn, as written [rad].
  std::map<std::string, std::array<double, 3>> wide_angles;
};

/// Looks through the text of a URDF. What is wrong is added to `problems`, what is taken with reservations to
/// `notes`; each a message that names `file` and the joint or link.
UrdfInspection inspect_urdf(const std::string& text, const std::string& file, Problems& problems,
                            Notes& notes);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_READING_TREE_READER_H
