// SPDX-License-Identifier: BSD-3-Clause
#include "draw/page/page_elements.h"
#include "tools/drawing/gate_line.h"
#include "tools/drawing/result_charts.h"
#include "tools/report/report.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using svg::number;
using svg::text_at;

constexpr const char* parallel_color = "#999999";

constexpr double page_margin = 20.0, header = 50.0, line_height = 18.0;
constexpr double least_radius = 9.0, largest_radius = 24.0;
constexpr double beside = 62.0;  // room around a circle of aspects, for their working modes
constexpr double full_turn = 2.0 * static_cast<double>(EIGEN_PI);
constexpr double least_spacing = 72.0, widening = 1.25;  // of aspects along the circle
constexpr int widenings = 6;

/// Where the working mode of a node is written.
struct TextPlace {
  double text_x = 0.0, text_y = 0.0;
  const char* anchor = "middle";
};

struct SetPanel {
  double x = 0.0, y = 0.0, radius = 0.0;  // of the circle
};

class GraphDrawing {
 public:
  GraphDrawing(const AspectMap& map, const AspectGraph& graph)
      : map_(map), graph_(graph), circles_(map.aspects().size()), places_(map.aspects().size()) {
    for (const Aspect& aspect : map.aspects()) largest_ = std::max(largest_, aspect.measure);
    // Farther apart where the circles leave a line no way.
    for (int i = 0; i <= widenings; ++i, spacing_ *= widening)
      if (lay_out()) break;
  }

  std::string text() const {
    std::string picture =
        svg::start(width_, height_) +
        text_at(page_margin, 22.0, "start", map_.manipulator()->name() + ": aspects and gates", 15.0);
    for (const bool serial : {false, true})
      for (std::size_t i = 0; i < lines_.size(); ++i)
        if ((graph_.gates[i].crossing == Crossing::serial) == serial)
          picture += line(graph_.gates[i], lines_[i]);
    for (const Aspect& aspect : map_.aspects()) picture += node(aspect);
    for (std::size_t i = 0; i < panels_.size(); ++i) picture += title(i);
    return picture + legend() + "</svg>\n";
  }

 private:
  /// Whether each line found a way.
  bool lay_out() {
    lay_out_panels();
    for (std::size_t i = 0; i < panels_.size(); ++i) place_set(panels_[i], graph_.sets[i].aspects);
    const Eigen::AlignedBox2d bounds(PagePoint(page_margin, header),
                                     PagePoint(width_ - page_margin, legend_y_ - 1.5 * line_height));
    bool all = true;
    lines_.clear();
    for (const Neighbours& gate : graph_.gates) {
      const auto first = static_cast<std::size_t>(gate.first - 1),
                 second = static_cast<std::size_t>(gate.second - 1);
      const auto found = line_between(circles_, first, second, bounds);
      const PagePoint &from = circles_[first].middle, &to = circles_[second].middle;
      lines_.push_back(found.value_or(GateLine{{from, from, to, to}}));
      all = all && found;
    }
    return all;
  }

  /// Panels in rows, as many in each as make the picture about as wide as it is high.
  void lay_out_panels() {
    panels_.clear();
    width_ = 0.0;
    const auto per_row =
        static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(graph_.sets.size()))));
    double x = page_margin, y = header, row_height = 0.0;
    for (std::size_t i = 0; i < graph_.sets.size(); ++i) {
      if (i > 0 && i % per_row == 0) x = page_margin, y += row_height, row_height = 0.0;
      const auto count = static_cast<double>(graph_.sets[i].aspects.size());
      const double radius = count > 1.0 ? std::max(spacing_, count * spacing_ / full_turn) : 0.0;
      const double half = std::max(radius + beside + largest_radius, 120.0);
      panels_.push_back({x + half, y + line_height + radius + beside, radius});
      x += 2.0 * half + page_margin;
      row_height = std::max(row_height, 2.0 * (radius + beside) + line_height + page_margin);
      width_ = std::max(width_, x);
    }
    legend_y_ = y + row_height + line_height;
    height_ =
        legend_y_ + line_height * static_cast<double>(map_.manipulator()->leg_count() + 2) + page_margin;
  }

  void place_set(const SetPanel& panel, const std::vector<int>& aspects) {
    for (std::size_t i = 0; i < aspects.size(); ++i) {
      const double angle = full_turn * static_cast<double>(i) / static_cast<double>(aspects.size());
      const double right = std::sin(angle), up = std::cos(angle);
      const Aspect& aspect = map_.aspects()[static_cast<std::size_t>(aspects[i] - 1)];
      NodeCircle& circle = circles_[static_cast<std::size_t>(aspects[i] - 1)];
      TextPlace& place = places_[static_cast<std::size_t>(aspects[i] - 1)];
      circle.radius = std::max(least_radius, largest_radius * std::sqrt(aspect.measure / largest_));
      circle.middle = {panel.x + panel.radius * right, panel.y - panel.radius * up};
      const double out = circle.radius + 5.0;
      place.text_x = circle.middle.x() + out * right;
      place.text_y =
          circle.middle.y() - out * up + (up < 0.0 ? -up * 9.0 : 0.0) + (std::abs(up) < 0.5 ? 4.0 : 0.0);
      place.anchor = right > 0.3 ? "start" : right < -0.3 ? "end" : "middle";
    }
  }

  static std::string stroke_style(const std::string& color, double width, bool dashed) {
    return " stroke=\"" + color + "\" stroke-width=\"" + number(width) + "\"" +
           (dashed ? " stroke-dasharray=\"4 3\"" : "") + "/>\n";
  }

  static std::string line(const Neighbours& gate, const GateLine& curve) {
    const bool serial = gate.crossing == Crossing::serial;
    const auto at = [&](std::size_t i) {
      return number(curve.points[i].x()) + " " + number(curve.points[i].y());
    };
    const std::string way = curve.is_straight() ? " L" : " C" + at(1) + " " + at(2) + " ";
    return "<path d=\"M" + at(0) + way + at(3) + "\" fill=\"none\"" +
           stroke_style(serial ? color_text(leg_color(gate.leg)) : std::string(parallel_color),
                        serial ? 2.5 : 0.8, !gate.proved);
  }

  std::string node(const Aspect& aspect) const {
    const NodeCircle& circle = circles_[static_cast<std::size_t>(aspect.id - 1)];
    const TextPlace& place = places_[static_cast<std::size_t>(aspect.id - 1)];
    return "<circle cx=\"" + number(circle.middle.x()) + "\" cy=\"" + number(circle.middle.y()) + "\" r=\"" +
           number(circle.radius) + "\" fill=\"" + color_text(sign_color(aspect.determinant_sign, true)) +
           "\" stroke=\"" + color_text(sign_color(aspect.determinant_sign)) + "\"/>\n" +
           text_at(circle.middle.x(), circle.middle.y() + 4.0, "middle", std::to_string(aspect.id)) +
           text_at(place.text_x, place.text_y, place.anchor, to_string(aspect.mode), 9.0);
  }

  std::string title(std::size_t set) const {
    const SetPanel& panel = panels_[set];
    return text_at(panel.x, panel.y - panel.radius - beside + 8.0, "middle",
                   "set " + std::to_string(set + 1) + ", det A " +
                       (graph_.sets[set].determinant_sign > 0 ? "> 0" : "< 0") + ", at least " +
                       shown_bound(graph_.sets[set].workspace_lower, Side::below) + " " + map_.unit(),
                   12.0);
  }

  std::string legend() const {
    std::string picture;
    double y = legend_y_;
    const auto entry = [&](const std::string& color, double width, bool dashed, const std::string& meaning) {
      const std::string height = number(y - 4.0);
      picture += "<line x1=\"" + number(page_margin) + "\" y1=\"" + height + "\" x2=\"" +
                 number(page_margin + 30.0) + "\" y2=\"" + height + "\"" +
                 stroke_style(color, width, dashed) + text_at(page_margin + 40.0, y, "start", meaning);
      y += line_height;
    };
    for (std::size_t leg = 0; leg < map_.manipulator()->leg_count(); ++leg)
      entry(color_text(leg_color(leg)), 2.5, false, "B_jj = 0 of " + map_.manipulator()->leg(leg).name);
    entry(parallel_color, 0.8, false, "det A = 0, where control is lost");
    entry("#000000", 1.0, true, "possible, not proved");
    return picture;
  }

  const AspectMap& map_;
  const AspectGraph& graph_;
  double spacing_ = least_spacing;
  std::vector<SetPanel> panels_;     // by index of the set
  std::vector<NodeCircle> circles_;  // by id - 1
  std::vector<TextPlace> places_;    // by id - 1
  std::vector<GateLine> lines_;      // by index of the gate
  double largest_ = 0.0, width_ = 0.0, height_ = 0.0, legend_y_ = 0.0;
};

}  // namespace

std::string draw_graph(const AspectMap& map, const AspectGraph& graph) {
  return GraphDrawing(map, graph).text();
}

}  // namespace parallel_aspects::tools
