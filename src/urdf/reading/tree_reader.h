// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_READING_TREE_READER_H
#define PARALLEL_ASPECTS_URDF_READING_TREE_READER_H

#include "parallel_aspects/model/problems.h"
#include "urdf/description/messages.h"
#include "urdf/description/tree.h"

#include <tinyxml2.h>

#include <optional>
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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_READING_TREE_READER_H
