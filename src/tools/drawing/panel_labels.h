// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_PANEL_LABELS_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_PANEL_LABELS_H

#include "tools/drawing/outlines.h"
#include "tools/drawing/page_elements.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// Writes texts into a rectangle so that none overlaps another.
class PanelLabels {
 public:
  PanelLabels(const PagePoint& corner, const PagePoint& size) : bounds_(corner, corner + size) {}

  /// On what it names where there is room, else beside it with a line to it; not at all where neither goes.
  void add(const std::string& text, const LabelPoint& point, Rgb background, Picture& picture);

  /// At the point on a line that is free and nearest to its middle; not at all where none is.
  void add_on_line(const std::string& text, const PageLine& line, Picture& picture);

 private:
  bool take(const Eigen::AlignedBox2d& box);

  Eigen::AlignedBox2d bounds_;
  std::vector<Eigen::AlignedBox2d> taken_;
};

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_PANEL_LABELS_H
