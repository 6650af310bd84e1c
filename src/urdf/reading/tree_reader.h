// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_READING_TREE_READER_H
#define PARALLEL_ASPECTS_URDF_READING_TREE_READER_H

#include "parallel_aspects/model/problems.h"
#include "urdf/description/note.h"
#include "urdf/description/tree.h"

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Reads the tree of a URDF. What is wrong is added to `problems`, what is taken with reservations to
/// `notes`; each a message that names `file` and the joint or link. Nothing is returned when there are
/// problems.
std::optional<Tree> read_tree(const std::string& text, const std::string& file, Problems& problems,
                              Notes& notes);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_READING_TREE_READER_H
