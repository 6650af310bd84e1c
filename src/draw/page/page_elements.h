// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_PAGE_PAGE_ELEMENTS_H
#define PARALLEL_ASPECTS_DRAW_PAGE_PAGE_ELEMENTS_H

#include "draw/plane/palette.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace parallel_aspects {

/// From the upper left corner of a page, to the right and down [px].
using PagePoint = Eigen::Vector2d;
using PageLine = std::vector<PagePoint>;

/// What closed lines bound: all points that they wind around.
struct PageArea {
  std::vector<PageLine> loops;
  Rgb color = 0;
  std::string title;  ///< what it is, for who points at it; empty for none
};

/// Lines, open or closed.
struct PageCurves {
  std::vector<PageLine> lines;
  Rgb color = 0;
  double width = 1.0;  ///< [px]
  bool dashed = false;
  std::string title;
};

/// Where the point of a text is in it.
enum class TextAnchor { start, middle, end };

/// A line of text.
struct PageText {
  PagePoint at = PagePoint::Zero();  ///< on its base line
  TextAnchor anchor = TextAnchor::start;
  double size = 11.0;  ///< of the font [px]
  std::string text;
  Rgb color = ink_color;
  bool bold = false;
  std::optional<Rgb> halo{};  ///< colour of a rim, over lines
};

/// A picture of points, stretched over a rectangle.
struct PageImage {
  PagePoint corner = PagePoint::Zero(), size = PagePoint::Zero();  ///< upper left [px]
  std::size_t width = 0;                                           ///< points in a row
  std::vector<Rgb> points;                                         ///< row by row from the top
};

using PageElement = std::variant<PageArea, PageCurves, PageText, PageImage>;

/// What is drawn, in this order, on white.
struct PagePicture {
  double width = 0.0, height = 0.0;  ///< [px]
  std::vector<PageElement> elements;
};

/// At least as wide as the text is in the usual fonts [px].
double text_width(const std::string& text, double size);

/// The contents of an SVG file.
std::string as_svg(const PagePicture& picture);

/// The contents of a PNG file, with so many of its points for one px.
std::string as_png(const PagePicture& picture, double scale);

}  // namespace parallel_aspects

/// Parts of pictures as SVG. Lengths on the page [px].
namespace parallel_aspects::svg {

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

}  // namespace parallel_aspects::svg

#endif  // PARALLEL_ASPECTS_DRAW_PAGE_PAGE_ELEMENTS_H
