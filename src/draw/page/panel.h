// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_PAGE_PANEL_H
#define PARALLEL_ASPECTS_DRAW_PAGE_PANEL_H

#include "draw/page/outlines.h"
#include "draw/page/page_elements.h"
#include "draw/scene/plane_scene.h"

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Writes texts into a rectangle so that none overlaps another.
class PanelLabels {
 public:
  PanelLabels(const PagePoint& corner, const PagePoint& size) : bounds_(corner, corner + size) {}

  /// On what it names where there is room, else beside it with a line to it; not at all where neither goes.
  void add(const std::string& text, const LabelPoint& point, Rgb background, PagePicture& picture);

  /// At the point on a line that is free and nearest to its middle; not at all where none is.
  void add_on_line(const std::string& text, const PageLine& line, PagePicture& picture);

 private:
  bool take(const Eigen::AlignedBox2d& box);

  Eigen::AlignedBox2d bounds_;
  std::vector<Eigen::AlignedBox2d> taken_;
};

/// A line of an image, and what is written beside it; ends from 0 to 1, to the right and down.
struct ImageAxis {
  PagePoint from, to;
  std::vector<std::string> lines;  ///< of text
};

/// What is written on an image, at a place from 0 to 1 with so much room, on this colour.
struct ImageLabel {
  std::string text;
  LabelPoint point;
  Rgb background = 0;
};

/// What is in a panel: a plane, or an image over all of it, in proportion to the axes of the plane.
struct PagePanel {
  PlaneScene plane;
  std::optional<PageImage> image{};
  std::vector<ImageAxis> image_axes{};
  std::vector<ImageLabel> image_labels{};
};

/// How large a panel is without what is written around it, in a square of this side [px].
PagePoint panel_size(const PagePanel& contents, double side);

/// Room around it [px].
inline constexpr double left_of_panel = 46.0, below_panel = 34.0;

/// Between what is above it and its corner [px].
double room_above(const PagePanel& contents);

/// Adds a panel whose upper left corner is there.
void draw_panel(const PagePanel& contents, const PagePoint& corner, double side, PagePicture& picture);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_PAGE_PANEL_H
