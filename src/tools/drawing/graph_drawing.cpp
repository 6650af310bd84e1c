// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/graph_drawing.h"

#include "tools/drawing/svg.h"
#include "tools/report/report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using svg::number;
using svg::text_at;

// After Paul Tol's colour schemes for people with any colour vision.
constexpr std::array<const char*, 6> leg_colors{"#228833", "#aa3377", "#ccbb44",
                                                "#66ccee", "#ee7733", "#332288"};
constexpr const char* parallel_color = "#999999";

constexpr double page_margin = 20.0, header = 50.0, line_height = 18.0;
constexpr double least_radius = 9.0, largest_radius = 24.0;
constexpr double beside = 62.0;  // room around a circle of aspects, for their working modes
constexpr double full_turn = 2.0 * static_cast<double>(EIGEN_PI);
constexpr double spacing = 72.0;  // of aspects along the circle

struct Place {
  double x = 0.0, y = 0.0, radius = 0.0;
  double text_x = 0.0, text_y = 0.0;
  const char* anchor = "middle";
};

struct SetPanel {
  double x = 0.0, y = 0.0, radius = 0.0;  // of the circle
};

class GraphDrawing {
 public:
  GraphDrawing(const AspectMap& map, const AspectGraph& graph)
      : map_(map), graph_(graph), places_(map.aspects().size()) {
    for (const Aspect& aspect : map.aspects()) largest_ = std::max(largest_, aspect.measure);
    lay_out();
    for (std::size_t i = 0; i < panels_.size(); ++i) place_set(panels_[i], graph.sets[i].aspects);
  }

  std::string text() const {
    std::string picture =
        svg::start(width_, height_) +
        text_at(page_margin, 22.0, "start", map_.manipulator()->name() + ": aspects and gates", 15.0);
    for (const bool serial : {false, true})
      for (const Neighbours& gate : graph_.gates)
        if ((gate.crossing == Crossing::serial) == serial) picture += line(gate);
    for (const Aspect& aspect : map_.aspects()) picture += node(aspect);
    for (std::size_t i = 0; i < panels_.size(); ++i) picture += title(i);
    return picture + legend() + "</svg>\n";
  }

 private:
  /// Panels in rows, as many in each as make the picture about as wide as it is high.
  void lay_out() {
    const auto per_row =
        static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(graph_.sets.size()))));
    double x = page_margin, y = header, row_height = 0.0;
    for (std::size_t i = 0; i < graph_.sets.size(); ++i) {
      if (i > 0 && i % per_row == 0) x = page_margin, y += row_height, row_height = 0.0;
      const auto count = static_cast<double>(graph_.sets[i].aspects.size());
      const double radius = count > 1.0 ? std::max(spacing, count * spacing / full_turn) : 0.0;
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
      Place& place = places_[static_cast<std::size_t>(aspects[i] - 1)];
      place.radius = std::max(least_radius, largest_radius * std::sqrt(aspect.measure / largest_));
      place.x = panel.x + panel.radius * right;
      place.y = panel.y - panel.radius * up;
      const double out = place.radius + 5.0;
      place.text_x = place.x + out * right;
      place.text_y = place.y - out * up + (up < 0.0 ? -up * 9.0 : 0.0) + (std::abs(up) < 0.5 ? 4.0 : 0.0);
      place.anchor = right > 0.3 ? "start" : right < -0.3 ? "end" : "middle";
    }
  }

  const Place& place(int aspect) const { return places_[static_cast<std::size_t>(aspect - 1)]; }

  static std::string stroke(double from_x, double from_y, double to_x, double to_y, const char* color,
                            double width, bool dashed) {
    return "<line x1=\"" + number(from_x) + "\" y1=\"" + number(from_y) + "\" x2=\"" + number(to_x) +
           "\" y2=\"" + number(to_y) + "\" stroke=\"" + color + "\" stroke-width=\"" + number(width) + "\"" +
           (dashed ? " stroke-dasharray=\"4 3\"" : "") + "/>\n";
  }

  std::string line(const Neighbours& gate) const {
    const Place &from = place(gate.first), &to = place(gate.second);
    const bool serial = gate.crossing == Crossing::serial;
    return stroke(from.x, from.y, to.x, to.y, serial ? leg_colors[gate.leg] : parallel_color,
                  serial ? 2.5 : 0.8, !gate.proved);
  }

  std::string node(const Aspect& aspect) const {
    const Place& at = place(aspect.id);
    const bool positive = aspect.determinant_sign > 0;
    return "<circle cx=\"" + number(at.x) + "\" cy=\"" + number(at.y) + "\" r=\"" + number(at.radius) +
           "\" fill=\"" + (positive ? "#b4c8dd" : "#ebc2c9") + "\" stroke=\"" +
           (positive ? "#4477aa" : "#cc6677") + "\"/>\n" +
           text_at(at.x, at.y + 4.0, "middle", std::to_string(aspect.id)) +
           text_at(at.text_x, at.text_y, at.anchor, to_string(aspect.mode), 9.0);
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
    const auto entry = [&](const char* color, double width, bool dashed, const std::string& meaning) {
      picture += stroke(page_margin, y - 4.0, page_margin + 30.0, y - 4.0, color, width, dashed) +
                 text_at(page_margin + 40.0, y, "start", meaning);
      y += line_height;
    };
    for (std::size_t leg = 0; leg < map_.manipulator()->leg_count(); ++leg)
      entry(leg_colors[leg], 2.5, false, "B_jj = 0 of " + map_.manipulator()->leg(leg).name);
    entry(parallel_color, 0.8, false, "det A = 0, where control is lost");
    entry("#000000", 1.0, true, "possible, not proved");
    return picture;
  }

  const AspectMap& map_;
  const AspectGraph& graph_;
  std::vector<SetPanel> panels_;  // by index of the set
  std::vector<Place> places_;     // by id - 1
  double largest_ = 0.0, width_ = 0.0, height_ = 0.0, legend_y_ = 0.0;
};

}  // namespace

std::string draw_graph(const AspectMap& map, const AspectGraph& graph) {
  return GraphDrawing(map, graph).text();
}

}  // namespace parallel_aspects::tools
