// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_READING_ROBOT_TEXT_H
#define PARALLEL_ASPECTS_URDF_READING_ROBOT_TEXT_H

#include <tinyxml2.h>

#include <optional>
#include <string>

namespace parallel_aspects {

/// Parses the text of a URDF. Where it holds no <robot> element: what it is, and what to do, as "is a pointer
/// of Git LFS, not the file; fetch that with 'git lfs pull'.".
std::optional<std::string> parse_robot(const std::string& text, tinyxml2::XMLDocument& document);

/// A text in Latin-1, as older editors save it, in UTF-8; nothing where it is in UTF-8 as it is.
std::optional<std::string> from_latin_1(const std::string& text);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_READING_ROBOT_TEXT_H
