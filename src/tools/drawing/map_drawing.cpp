// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/map_drawing.h"

#include "model/number_text.h"
#include "parallel_aspects/aspects/held_joint.h"
#include "tools/drawing/svg.h"
#include "tools/report/reports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

namespace parallel_aspects::tools {
namespace {

// Lengths on the page [px].
constexpr double panel_size = 300.0, margin = 34.0, title_height = 58.0, least_width = 640.0;

// After Paul Tol's colour schemes for people with any colour vision.
constexpr std::array<const char*, 5> positive_colors{"#4477aa", "#88ccee", "#332288", "#44aa99", "#117733"};
constexpr std::array<const char*, 5> negative_colors{"#cc6677", "#ddcc77", "#882255", "#aa4499", "#999933"};
constexpr const char* undecided_color = "#bbbbbb";

using svg::font_size;
using svg::number;
using svg::text_at;

/// Boxes in rows, those that touch in one row made one.
std::vector<Box> merged(std::vector<Box> boxes) {
  std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) {
    return std::tie(a.lower[1], a.upper[1], a.lower[0]) < std::tie(b.lower[1], b.upper[1], b.lower[0]);
  });
  std::vector<Box> result;
  for (const Box& box : boxes) {
    const bool continues = !result.empty() && result.back().lower[1] == box.lower[1] &&
                           result.back().upper[1] == box.upper[1] && result.back().upper[0] == box.lower[0];
    if (continues)
      result.back().upper[0] = box.upper[0];
    else
      result.push_back(box);
  }
  return result;
}

/// One panel a working mode, in rows.
class Drawing {
 public:
  explicit Drawing(const AspectMap& map) : map_(map), names_(map.coordinates()) {
    find_bounds();
    // Two positions keep their proportion; an angle beside a position has none.
    const bool angle = names_[1] != "x" && names_[1] != "y" && names_[1] != "z";
    const double longest = std::max(bounds_.width(0), bounds_.width(1));
    for (std::size_t i = 0; i < 2; ++i) scale_[i] = panel_size / (angle ? bounds_.width(i) : longest);
    const std::size_t modes = std::max<std::size_t>(1, map.working_modes().size());
    columns_ = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(modes))));
    rows_ = (modes + columns_ - 1) / columns_;
  }

  std::string text() const {
    const double width = std::max(least_width, margin + static_cast<double>(columns_) * step(0));
    const double height = title_height + static_cast<double>(rows_) * step(1);
    std::string svg = svg::start(width, height);
    svg += text_at(margin, 18.0, "start", title(), 14.0);
    svg += text_at(margin, 34.0, "start", slice());
    svg +=
        text_at(margin, 50.0, "start",
                "det A > 0: blue and green; det A < 0: red, yellow and purple; undecided: grey. Numbers are "
                "ids of aspects.");
    for (std::size_t k = 0; k < map_.working_modes().size(); ++k) svg += panel(k);
    return svg + "</svg>\n";
  }

 private:
  void find_bounds() {
    bounds_ = map_.region();
    if (map_.aspects().empty()) return;
    bounds_ = map_.aspects().front().bounds;
    for (const Aspect& aspect : map_.aspects())
      for (std::size_t i = 0; i < 2; ++i) {
        bounds_.lower[i] = std::min(bounds_.lower[i], aspect.bounds.lower[i]);
        bounds_.upper[i] = std::max(bounds_.upper[i], aspect.bounds.upper[i]);
      }
    for (std::size_t i = 0; i < 2; ++i) {
      const double around = 0.03 * bounds_.width(i);
      bounds_.lower[i] -= around;
      bounds_.upper[i] += around;
    }
  }

  double length(std::size_t i) const { return scale_[i] * bounds_.width(i); }
  double step(std::size_t i) const { return length(i) + (i == 0 ? margin : 2.0 * margin); }
  double x(double value) const { return scale_[0] * (value - bounds_.lower[0]); }
  double y(double value) const { return scale_[1] * (bounds_.upper[1] - value); }

  std::string title() const { return map_.manipulator()->name() + ": " + aspect_count(map_); }

  std::string slice() const { return map_.slice() ? "slice " + to_string(*map_.slice()) : "all poses"; }

  std::string panel(std::size_t k) const {
    const WorkingMode& mode = map_.working_modes()[k];
    const double left = margin + static_cast<double>(k % columns_) * step(0);
    const double top = title_height + margin + static_cast<double>(k / columns_) * step(1) - 8.0;
    std::string svg = "<g transform=\"translate(" + number(left) + " " + number(top) + ")\">\n" +
                      text_at(0.5 * length(0), -6.0, "middle", to_string(mode)) + leaves(mode) + ids(mode) +
                      frame();
    return svg + "</g>\n";
  }

  std::string leaves(const WorkingMode& mode) const {
    std::vector<Box> boxes;
    const auto collect = [&boxes](const Box& box) { boxes.push_back(box); };
    map_.visit_undecided_leaves(mode, collect);
    std::string svg = path(boxes, undecided_color);
    std::array<std::size_t, 2> next{};
    for (const Aspect& aspect : map_.aspects()) {
      if (aspect.mode != mode) continue;
      const bool positive = aspect.determinant_sign > 0;
      const auto& colors = positive ? positive_colors : negative_colors;
      boxes.clear();
      map_.visit_inside_leaves(aspect.id, collect);
      svg += path(boxes, colors[next[positive ? 1 : 0]++ % colors.size()]);
    }
    return svg;
  }

  std::string path(const std::vector<Box>& boxes, const char* color) const {
    if (boxes.empty()) return "";
    std::string svg = std::string("<path fill=\"") + color + "\" shape-rendering=\"crispEdges\" d=\"";
    for (const Box& box : merged(boxes))
      svg += "M" + number(x(box.lower[0])) + " " + number(y(box.upper[1])) + "H" + number(x(box.upper[0])) +
             "V" + number(y(box.lower[1])) + "H" + number(x(box.lower[0])) + "Z";
    return svg + "\"/>\n";
  }

  std::string ids(const WorkingMode& mode) const {
    std::string svg;
    for (const Aspect& aspect : map_.aspects()) {
      if (aspect.mode != mode || aspect.deepest_clearance * scale_[0] < font_size) continue;
      const MapPoint at = deepest(aspect);
      svg += "<g fill=\"#ffffff\" font-weight=\"bold\">" +
             text_at(x(at[0]), y(at[1]) + 0.35 * font_size, "middle", std::to_string(aspect.id)) + "</g>";
    }
    return svg;
  }

  MapPoint deepest(const Aspect& aspect) const {
    if (map_.slice() && map_.slice()->joint) return deepest_directions(aspect, *map_.slice()->joint);
    const std::array<std::string, 3> positions{"x", "y", "z"};
    MapPoint point{};
    for (std::size_t i = 0; i < 2; ++i) {
      point[i] = 0.5 * (aspect.bounds.lower[i] + aspect.bounds.upper[i]);
      for (std::size_t k = 0; k < 3; ++k)
        if (names_[i] == positions[k]) point[i] = aspect.deepest.position[static_cast<Eigen::Index>(k)];
    }
    return point;
  }

  MapPoint deepest_directions(const Aspect& aspect, const HeldJoint& joint) const {
    const Eigen::Vector2d rod = circle_of_anchor(*map_.manipulator(), joint).rod(aspect.deepest);
    const Eigen::Quaterniond& turn = aspect.deepest.orientation;
    const double phi = 2.0 * std::atan2(turn.z(), turn.w()), full_turn = 2.0 * EIGEN_PI;
    return {std::atan2(rod.y(), rod.x()), std::remainder(phi, full_turn), 0.0};
  }

  std::string frame() const {
    return "<rect width=\"" + number(length(0)) + "\" height=\"" + number(length(1)) +
           "\" fill=\"none\" stroke=\"#444444\"/>\n" +
           text_at(0.0, length(1) + 13.0, "start", shown_briefly(bounds_.lower[0])) +
           text_at(0.5 * length(0), length(1) + 13.0, "middle",
                   names_[0] + " to the right, " + names_[1] + " up") +
           text_at(length(0), length(1) + 13.0, "end", shown_briefly(bounds_.upper[0])) +
           text_at(-3.0, length(1), "end", shown_briefly(bounds_.lower[1]), 9.0) +
           text_at(-3.0, 8.0, "end", shown_briefly(bounds_.upper[1]), 9.0);
  }

  const AspectMap& map_;
  std::vector<std::string> names_;
  Box bounds_;
  std::array<double, 2> scale_{};
  std::size_t columns_ = 1, rows_ = 1;
};

}  // namespace

std::string draw_map(const AspectMap& map) { return Drawing(map).text(); }

}  // namespace parallel_aspects::tools
