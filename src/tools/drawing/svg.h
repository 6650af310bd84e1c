// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_SVG_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_SVG_H

#include <string>
#include <utility>
#include <vector>

/// Parts of pictures as SVG. Lengths on the page [px].
namespace parallel_aspects::tools::svg {

constexpr double font_size = 11.0;

/// A length.
std::string number(double value);

/// Text with the characters that mean something in SVG replaced.
std::string escaped(const std::string& text);

/// The start of a picture with a white ground; it ends with "</svg>\n".
std::string start(double width, double height);

/// Text whose "start", "middle" or "end" is there.
std::string text_at(double x, double y, const std::string& anchor, const std::string& text,
                    double size = font_size);

/// Colours and what they mean, one beside the other from there on.
std::string key(double x, double y, const std::vector<std::pair<std::string, std::string>>& entries);

}  // namespace parallel_aspects::tools::svg

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_SVG_H
