// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/panel_labels.h"

#include "model/angles.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects::tools {
namespace {

constexpr double id_size = 13.0, level_size = 8.0;
constexpr double rim = 2.0;  // around a text [px]
constexpr double shortest_named_line = 45.0;

// Where a text goes beside what it names [px].
constexpr double nearest = 16.0, farthest = 110.0, radius_step = 6.0;
constexpr int directions = 16;

double height_of(double size) { return 0.75 * size; }

Eigen::AlignedBox2d box_around(const PagePoint& middle, const std::string& text, double size) {
  const PagePoint half(0.5 * text_width(text, size) + rim, 0.5 * height_of(size) + rim);
  return {middle - half, middle + half};
}

/// Where the line from the middle of a box to a point leaves it, before which it would run into the text.
PagePoint leaving(const Eigen::AlignedBox2d& box, const PagePoint& point) {
  const PagePoint away = point - box.center(), half = 0.5 * box.sizes();
  const double reach = std::max(std::abs(away.x()) / half.x(), std::abs(away.y()) / half.y());
  return reach <= 1.0 ? point : PagePoint(box.center() + away / reach);
}

PageText text_around(const PagePoint& middle, const std::string& text, double size, Rgb color) {
  return {middle + PagePoint(0.0, 0.5 * height_of(size)), Anchor::middle, size, text, color};
}

}  // namespace

bool PanelLabels::take(const Eigen::AlignedBox2d& box) {
  if (!bounds_.contains(box)) return false;
  for (const Eigen::AlignedBox2d& other : taken_)
    if (box.intersects(other)) return false;
  taken_.push_back(box);
  return true;
}

void PanelLabels::add(const std::string& text, const LabelPoint& point, Rgb background, Picture& picture) {
  const Eigen::AlignedBox2d box = box_around(point.at, text, id_size);
  if (0.5 * box.sizes().norm() <= point.clearance && take(box)) {
    PageText written = text_around(point.at, text, id_size, readable_on(background));
    written.bold = true;
    written.halo = background;
    picture.elements.emplace_back(written);
    return;
  }
  for (double radius = nearest; radius <= farthest; radius += radius_step)
    for (int k = 0; k < directions; ++k) {
      const double angle = full_turn * (k + 0.5) / directions;
      const PagePoint at = point.at + radius * PagePoint(std::cos(angle), std::sin(angle));
      const Eigen::AlignedBox2d beside = box_around(at, text, id_size);
      if (!take(beside)) continue;
      const PageLine leader{leaving(beside, point.at), point.at};
      picture.elements.emplace_back(PageCurves{{leader}, 0xFFFFFF, 2.6, false, ""});
      picture.elements.emplace_back(PageCurves{{leader}, ink_color, 0.8, false, ""});
      PageText written = text_around(at, text, id_size, ink_color);
      written.bold = true;
      written.halo = 0xFFFFFF;
      picture.elements.emplace_back(written);
      return;
    }
}

void PanelLabels::add_on_line(const std::string& text, const PageLine& line, Picture& picture) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  if (length < shortest_named_line) return;
  const std::size_t middle = line.size() / 2;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const std::size_t i = middle + (k % 2 == 0 ? k / 2 : line.size() - 1 - k / 2);
    const PagePoint& at = line[i % line.size()];
    if (!take(box_around(at, text, level_size))) continue;
    PageText written = text_around(at, text, level_size, ink_color);
    written.halo = 0xFFFFFF;
    picture.elements.emplace_back(written);
    return;
  }
}

}  // namespace parallel_aspects::tools
