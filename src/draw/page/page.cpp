// SPDX-License-Identifier: BSD-3-Clause
#include "draw/page/page.h"

#include <algorithm>
#include <sstream>

namespace parallel_aspects {
namespace {

// Lengths on the page [px].
constexpr double widest_page = 1010.0, narrowest_page = 640.0, margin = 16.0, beside_panel = 22.0,
                 between_rows = 14.0;
constexpr double page_title_size = 16.0, heading_size = 13.0, text_size = 10.0, line_pitch = 14.0;
constexpr double least_figure = 250.0;  // so that what is written over it has room
constexpr std::size_t most_entries = 8;
constexpr double swatch = 10.0, between_entries = 16.0;
constexpr double below_base_line = 4.0;  // of what hangs below the base line of a text

/// Lines of words that are no wider than that.
std::vector<std::string> wrapped(const std::string& text, double width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool fits = !lines.empty() && text_width(lines.back() + " " + word, text_size) <= width;
    if (fits)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

std::vector<LegendEntry> shortened(std::vector<LegendEntry> entries) {
  if (entries.size() <= most_entries) return entries;
  const std::size_t more = entries.size() - most_entries;
  entries.resize(most_entries);
  entries.push_back({0xFFFFFF, false, "and " + std::to_string(more) + " more"});
  return entries;
}

class PageDrawing {
 public:
  explicit PageDrawing(const Page& page) : page_(page) {}

  PagePicture draw() {
    picture_.width = page_width();
    y_ = margin + page_title_size;
    write({margin, y_}, page_title_size, page_.title, true);
    y_ += 6.0;
    for (const std::string& note : page_.notes)
      for (const std::string& line : wrapped(note, picture_.width - 2.0 * margin))
        write({margin, y_ += line_pitch}, text_size, line, false);
    y_ += between_rows;
    draw_figures();
    const double end = draw_entries(page_.legend, {margin, y_ + line_pitch}, picture_.width - 2.0 * margin);
    picture_.height = end + margin;
    return std::move(picture_);
  }

 private:
  double width_of(const PagePanel& panel) const {
    return left_of_panel + panel_size(panel, page_.side).x() + beside_panel;
  }

  double width_of(const PageFigure& figure) const {
    double width = 0.0;
    for (const PagePanel& panel : figure.panels) width += width_of(panel);
    return std::max(width, least_figure);
  }

  /// The figure after the last of the row that begins there.
  std::size_t end_of_row(std::size_t begin) const {
    double width = margin;
    std::size_t end = begin;
    for (; end < page_.figures.size(); ++end) {
      width += width_of(page_.figures[end]);
      if (width > widest_page && end > begin) break;
    }
    return end;
  }

  double page_width() const {
    double widest = narrowest_page;
    for (std::size_t i = 0; i < page_.figures.size(); i = end_of_row(i)) {
      double width = margin;
      for (std::size_t k = i; k < end_of_row(i); ++k) width += width_of(page_.figures[k]);
      widest = std::max(widest, width);
    }
    return widest;
  }

  void draw_figures() {
    for (std::size_t i = 0; i < page_.figures.size(); i = end_of_row(i)) draw_row(i, end_of_row(i));
  }

  void draw_row(std::size_t begin, std::size_t end) {
    double x = margin, heading_end = y_, bottom = y_;
    for (std::size_t i = begin; i < end; ++i) {
      const double width = width_of(page_.figures[i]);
      write({x, y_ + heading_size}, heading_size, page_.figures[i].title, true);
      heading_end =
          std::max(heading_end, draw_entries(shortened(page_.figures[i].entries),
                                             {x, y_ + heading_size + line_pitch}, width - beside_panel));
      x += width;
    }
    x = margin;
    for (std::size_t i = begin; i < end; ++i) {
      double panel_x = x;
      for (const PagePanel& panel : page_.figures[i].panels) {
        const PagePoint corner(panel_x + left_of_panel, heading_end + room_above(panel));
        draw_panel(panel, corner, page_.side, picture_);
        bottom = std::max(bottom, corner.y() + panel_size(panel, page_.side).y() + below_panel);
        panel_x += width_of(panel);
      }
      x += width_of(page_.figures[i]);
    }
    y_ = bottom + between_rows;
  }

  /// Entries in lines from there on; returns where they end, with what hangs below the last base line.
  double draw_entries(const std::vector<LegendEntry>& entries, const PagePoint& start, double width) {
    PagePoint at = start;
    for (const LegendEntry& entry : entries) {
      const double needed = swatch + 5.0 + text_width(entry.text, text_size);
      if (at.x() > start.x() && at.x() + needed > start.x() + width)
        at = PagePoint(start.x(), at.y() + line_pitch);
      draw_swatch(entry, at);
      write(at + PagePoint(swatch + 5.0, 0.0), text_size, entry.text, false);
      at.x() += needed + between_entries;
    }
    return (entries.empty() ? start.y() - line_pitch : at.y()) + below_base_line;
  }

  void draw_swatch(const LegendEntry& entry, const PagePoint& at) {
    const PagePoint right(swatch, 0.0), up(0.0, -swatch + 1.0), middle(0.0, 0.5 * (1.0 - swatch));
    if (entry.is_line)
      picture_.elements.emplace_back(
          PageCurves{{{at + middle, at + middle + right}}, entry.color, 2.0, false, ""});
    else
      picture_.elements.emplace_back(
          PageArea{{{at, at + right, at + right + up, at + up, at}}, entry.color, ""});
    if (!entry.is_line && entry.is_framed)
      picture_.elements.emplace_back(
          PageCurves{{{at, at + right, at + right + up, at + up, at}}, ink_color, 0.5, false, ""});
  }

  void write(const PagePoint& at, double size, const std::string& text, bool bold) {
    picture_.elements.emplace_back(
        PageText{at, TextAnchor::start, size, text, ink_color, bold, std::nullopt});
  }

  const Page& page_;
  PagePicture picture_;
  double y_ = 0.0;
};

}  // namespace

PagePicture draw_page(const Page& page) { return PageDrawing(page).draw(); }

Page page_of(const MapScene& scene, const std::string& title) {
  Page page;
  page.title = title;
  page.notes = scene.notes;
  page.legend = scene.legend;
  for (const MapFigure& figure : scene.figures) {
    page.figures.push_back({figure.title, figure.legend, {}});
    for (const PlaneScene& plane : figure.planes) page.figures.back().panels.push_back({plane});
  }
  return page;
}

}  // namespace parallel_aspects
