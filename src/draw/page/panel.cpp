// SPDX-License-Identifier: BSD-3-Clause
#include "draw/page/panel.h"

#include "model/angles.h"
#include "model/message_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double id_size = 13.0, level_size = 8.0;
constexpr double rim = 2.0;  // around a text [px]
constexpr double shortest_named_line = 45.0;

// Where a text goes beside what it names [px].
constexpr double nearest = 16.0, farthest = 110.0, radius_step = 6.0;
constexpr int directions_tried = 16;

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
  return {middle + PagePoint(0.0, 0.5 * height_of(size)), TextAnchor::middle, size, text, color};
}

}  // namespace

bool PanelLabels::take(const Eigen::AlignedBox2d& box) {
  if (!bounds_.contains(box)) return false;
  for (const Eigen::AlignedBox2d& other : taken_)
    if (box.intersects(other)) return false;
  taken_.push_back(box);
  return true;
}

void PanelLabels::add(const std::string& text, const LabelPoint& point, Rgb background,
                      PagePicture& picture) {
  const Eigen::AlignedBox2d box = box_around(point.at, text, id_size);
  if (0.5 * box.sizes().norm() <= point.clearance && take(box)) {
    PageText written = text_around(point.at, text, id_size, readable_on(background));
    written.bold = true;
    written.halo = background;
    picture.elements.emplace_back(written);
    return;
  }
  for (double radius = nearest; radius <= farthest; radius += radius_step)
    for (int k = 0; k < directions_tried; ++k) {
      const double angle = full_turn * (k + 0.5) / directions_tried;
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

void PanelLabels::add_on_line(const std::string& text, const PageLine& line, PagePicture& picture) {
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

namespace {

constexpr double tick_size = 9.0, axis_title_size = 10.0, caption_size = 11.0;
constexpr Rgb frame_color = 0x444444;
constexpr double tick_length = 4.0, mark_radius = 3.0;

// Lines are cased in white, so that they are seen on light and on dark.
constexpr double curve_width = 1.6, level_width = 0.7, casing = 1.4;

struct Tick {
  double value;
  std::string text;
};

std::vector<Tick> ticks_of_turn() {
  return {{-pi, "-π"}, {-0.5 * pi, "-π/2"}, {0.0, "0"}, {0.5 * pi, "π/2"}, {pi, "π"}};
}

// Steps of 1, 2 or 5 of a power of ten, four to nine over the whole range.
std::vector<Tick> ticks_of(const PlaneAxis& axis) {
  if (axis.is_turn) return ticks_of_turn();
  const double range = axis.upper - axis.lower, power = std::pow(10.0, std::floor(std::log10(range)));
  double step = power;
  for (const double factor : {0.5, 0.2, 0.1})
    if (range / step < 4.0) step = factor * power;
  std::vector<Tick> ticks;
  for (double k = std::ceil(axis.lower / step); k * step <= axis.upper; ++k)
    ticks.push_back({k * step, number_text(k * step + 0.0, 6)});  // never "-0"
  return ticks;
}

class Panel {
 public:
  Panel(const PagePanel& contents, const PagePoint& corner, double side)
      : contents_(contents),
        plane_(contents.plane),
        corner_(corner),
        size_(panel_size(contents, side)),
        labels_(corner_, size_) {}

  void draw(PagePicture& picture) {
    if (contents_.image) {
      draw_image(picture);
      return;
    }
    picture.elements.emplace_back(
        PageText{corner_ - PagePoint(0.0, 22.0), TextAnchor::start, caption_size, plane_.caption});
    draw_shapes(picture);
    const auto levels = level_lines();
    for (const auto& [level, lines] : levels) draw_cased(lines, ink_color, level_width, "", picture);
    draw_segments(picture);
    draw_lines(picture);
    draw_marks(picture);
    draw_frame(picture);
    draw_labels(picture);
    for (const auto& [level, lines] : levels) name_level(number_text(level, 3), lines, picture);
  }

 private:
  PagePoint place(const Eigen::Vector2d& point) const {
    const auto& [x, y] = plane_.axes;
    return corner_ + PagePoint(size_.x() * (point.x() - x.lower) / (x.upper - x.lower),
                               size_.y() * (y.upper - point.y()) / (y.upper - y.lower));
  }

  void draw_image(PagePicture& picture) {
    PageImage image = *contents_.image;
    image.corner = corner_;
    image.size = size_;
    picture.elements.emplace_back(std::move(image));
    for (const ImageAxis& axis : contents_.image_axes) draw_image_axis(axis, picture);
    for (const ImageLabel& label : contents_.image_labels) {
      const PagePoint at = corner_ + label.point.at.cwiseProduct(size_);
      labels_.add(label.text, {at, label.point.clearance * size_.x()}, label.background, picture);
    }
  }

  void draw_image_axis(const ImageAxis& axis, PagePicture& picture) const {
    const PagePoint from = corner_ + axis.from.cwiseProduct(size_),
                    to = corner_ + axis.to.cwiseProduct(size_);
    const PagePoint middle = 0.5 * (from + to), out = middle - corner_ - 0.5 * size_;
    const TextAnchor anchor = out.x() < 0.0 ? TextAnchor::end : TextAnchor::start;
    picture.elements.emplace_back(PageCurves{{{from, to}}, frame_color, 0.8, false, ""});
    PagePoint at = middle + 8.0 * out.normalized() + PagePoint(0.0, 5.0);
    for (const std::string& line : axis.lines) {
      picture.elements.emplace_back(PageText{at, anchor, tick_size, line});
      at.y() += 1.3 * tick_size;
    }
  }

  void draw_shapes(PagePicture& picture) {
    for (const PlaneArea& shape : plane_.areas) {
      std::vector<PageLine> polygons;
      for (const auto& polygon : shape.polygons) {
        polygons.emplace_back();
        for (const Eigen::Vector2d& corner : polygon) polygons.back().push_back(place(corner));
      }
      PageArea area{outlines_of(polygons), shape.color, shape.title};
      if (area.loops.empty()) continue;
      if (const auto point = label_point(polygons, area.loops); point && !shape.label.empty())
        ids_.push_back({*point, &shape});
      picture.elements.emplace_back(std::move(area));
    }
  }

  void draw_labels(PagePicture& picture) {
    // Those that need a place on what they name come first.
    std::sort(ids_.begin(), ids_.end(),
              [](const Id& a, const Id& b) { return a.first.clearance > b.first.clearance; });
    for (const auto& [point, shape] : ids_) labels_.add(shape->label, point, shape->color, picture);
  }

  static void draw_cased(const std::vector<PageLine>& lines, Rgb color, double width,
                         const std::string& title, PagePicture& picture) {
    if (lines.empty()) return;
    picture.elements.emplace_back(PageCurves{lines, 0xFFFFFF, width + casing, false, ""});
    picture.elements.emplace_back(PageCurves{lines, color, width, false, title});
  }

  void draw_segments(PagePicture& picture) const {
    for (const BoundaryCurves& curves : curves_of(plane_.boundaries)) {
      std::vector<std::pair<PagePoint, PagePoint>> pieces;
      for (std::size_t i = 0; i + 1 < curves.ends.size(); i += 2)
        pieces.emplace_back(place(curves.ends[i]), place(curves.ends[i + 1]));
      draw_cased(joined_lines(pieces), curves.style->color, curve_width, curves.style->words, picture);
    }
  }

  void draw_lines(PagePicture& picture) const {
    for (const PlaneLine& each : plane_.lines) {
      PageLine line;
      for (const Eigen::Vector2d& point : each.points) line.push_back(place(point));
      draw_cased({line}, each.color, curve_width, each.title, picture);
    }
  }

  void draw_marks(PagePicture& picture) const {
    for (const PlaneMark& mark : plane_.marks) {
      const PagePoint at = place(mark.at);
      for (const auto& [radius, color] :
           {std::pair{mark_radius + 1.0, Rgb{0xFFFFFF}}, {mark_radius, ink_color}})
        picture.elements.emplace_back(PageArea{{dot(at, radius)}, color, ""});
      if (mark.is_ring)
        picture.elements.emplace_back(PageArea{{dot(at, mark_radius - 1.0)}, Rgb{0xFFFFFF}, ""});
      picture.elements.emplace_back(PageText{at + PagePoint(mark_radius + 2.0, -mark_radius),
                                             TextAnchor::start, caption_size, mark.label, ink_color, true,
                                             Rgb{0xFFFFFF}});
    }
  }

  static PageLine dot(const PagePoint& middle, double radius) {
    constexpr int corners = 16;
    PageLine line;
    for (int i = 0; i <= corners; ++i) {
      const double angle = 2.0 * pi * i / corners;
      line.push_back(middle + radius * PagePoint(std::cos(angle), std::sin(angle)));
    }
    return line;
  }

  std::map<double, std::vector<PageLine>> level_lines() const {
    std::map<double, std::vector<std::pair<PagePoint, PagePoint>>> pieces;
    for (const LevelSegment& segment : plane_.levels)
      pieces[segment.level].emplace_back(place(segment.from), place(segment.to));
    std::map<double, std::vector<PageLine>> lines;
    for (const auto& [level, each] : pieces) lines.emplace(level, joined_lines(each));
    return lines;
  }

  void name_level(const std::string& name, const std::vector<PageLine>& lines, PagePicture& picture) {
    for (const PageLine& line : lines) labels_.add_on_line(name, line, picture);
  }

  void draw_frame(PagePicture& picture) const {
    const PagePoint right(size_.x(), 0.0), down(0.0, size_.y());
    std::vector<PageLine> lines{{corner_, corner_ + right, corner_ + size_, corner_ + down, corner_}};
    const auto& [x, y] = plane_.axes;
    for (const Tick& tick : ticks_of(x)) {
      const PagePoint at(place({tick.value, 0.0}).x(), corner_.y() + size_.y());
      lines.push_back({at, at + PagePoint(0.0, tick_length)});
      picture.elements.emplace_back(
          PageText{at + PagePoint(0.0, tick_length + 10.0), TextAnchor::middle, tick_size, tick.text});
    }
    for (const Tick& tick : ticks_of(y)) {
      const PagePoint at(corner_.x(), place({0.0, tick.value}).y());
      lines.push_back({at, at - PagePoint(tick_length, 0.0)});
      picture.elements.emplace_back(
          PageText{at + PagePoint(-tick_length - 2.0, 3.0), TextAnchor::end, tick_size, tick.text});
    }
    picture.elements.emplace_back(PageCurves{lines, frame_color, 0.8, false, ""});
    picture.elements.emplace_back(PageText{corner_ + down + 0.5 * right + PagePoint(0.0, 27.0),
                                           TextAnchor::middle, axis_title_size, x.title});
    picture.elements.emplace_back(
        PageText{corner_ - PagePoint(0.0, 7.0), TextAnchor::start, axis_title_size, y.title});
  }

  using Id = std::pair<LabelPoint, const PlaneArea*>;

  const PagePanel& contents_;
  const PlaneScene& plane_;
  PagePoint corner_, size_;
  PanelLabels labels_;
  std::vector<Id> ids_;
};

}  // namespace

PagePoint panel_size(const PagePanel& contents, double side) {
  if (!contents.plane.keeps_proportion) return {side, side};
  const auto& [x, y] = contents.plane.axes;
  const PagePoint range(x.upper - x.lower, y.upper - y.lower);
  return side / range.maxCoeff() * range;
}

double room_above(const PagePanel& contents) { return contents.image ? 0.0 : 36.0; }

void draw_panel(const PagePanel& contents, const PagePoint& corner, double side, PagePicture& picture) {
  Panel(contents, corner, side).draw(picture);
}

}  // namespace parallel_aspects
