// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_PAGE_PANEL_H
#define PARALLEL_ASPECTS_DRAW_PAGE_PANEL_H

#include <Eigen/Geometry>

#include "draw/page/outlines.h"
#include "draw/page/page_elements.h"
#include "draw/plane/map_pictures.h"
#include <array>
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

/// One coordinate of a panel.
struct PanelAxis {
  std::string title;                ///< with its unit
  double lower = 0.0, upper = 1.0;  ///< what is shown [m or rad]
  bool is_turn = false;             ///< from -pi to pi
};

/// A set of points of a panel, in its coordinates.
struct PanelShape {
  std::vector<std::vector<Eigen::Vector2d>> polygons;  ///< which share whole sides, turned the same way
  Rgb color = 0;
  std::string label;  ///< written on it; empty for none
  std::string title;  ///< what it is
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

/// A line, of a colour of its own.
struct PanelLine {
  std::vector<Eigen::Vector2d> points;  ///< in its coordinates
  Rgb color = 0;
  std::string title;  ///< what it is
};

/// A point, with what is written beside it.
struct PanelMark {
  Eigen::Vector2d at;  ///< in its coordinates
  std::string label;
  bool is_ring = false;  ///< a circle in place of a dot
};

/// What is in a panel.
struct PanelContents {
  std::string caption;
  std::array<PanelAxis, 2> axes;
  bool keeps_proportion = false;  ///< whether both axes have one scale
  std::vector<PanelShape> shapes;
  std::vector<BoundarySegment> segments;
  std::vector<LevelSegment> levels;
  std::optional<PageImage> image;  ///< in place of shapes, over the whole panel; then with these axes
  std::vector<ImageAxis> image_axes;
  std::vector<ImageLabel> image_labels;
  std::vector<std::vector<Eigen::Vector2d>> outlines{};  ///< lines over everything else
  std::vector<PanelLine> lines{};
  std::vector<PanelMark> marks{};  ///< dots or circles over these
};

/// How large a panel is without what is written around it, in a square of this side [px].
PagePoint panel_size(const PanelContents& contents, double side);

/// Room around it [px].
inline constexpr double left_of_panel = 46.0, below_panel = 34.0;

/// Between what is above it and its corner [px].
double room_above(const PanelContents& contents);

/// Adds a panel whose upper left corner is there.
void draw_panel(const PanelContents& contents, const PagePoint& corner, double side, PagePicture& picture);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_PAGE_PANEL_H
