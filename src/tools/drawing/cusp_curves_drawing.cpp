// SPDX-License-Identifier: BSD-3-Clause
#include "model/angles.h"
#include "model/number_text.h"
#include "tools/drawing/page.h"
#include "tools/drawing/uniqueness_drawing.h"
#include "tools/report/reports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace parallel_aspects::tools {
namespace {

using Eigen::Vector2d;

constexpr double side_of_curves = 430.0;  // [px]
constexpr Rgb count_color = 0xCC3311;

/// That of its curves and its legend.
Rgb curve_color(std::size_t i) { return aspect_color(i % 2 == 0 ? 1 : -1, i / 2); }

class CurvesDrawing {
 public:
  CurvesDrawing(const Manipulator& robot, const CuspCurves& found)
      : robot_(robot), found_(found), held_(found.range.leg) {
    others_ = {held_ == 0 ? std::size_t{1} : std::size_t{0}, held_ == 2 ? std::size_t{1} : std::size_t{2}};
  }

  Picture draw() const {
    Page page;
    page.side = side_of_curves;
    page.title = robot_.name() + ", " + title(held_) + " from " + number_text(found_.range.lower) + " to " +
                 number_text(found_.range.upper) + ": curves of cusps";
    page.notes = {std::string("Each curve and each number is proved. ") +
                  (found_.complete ? "There are no other curves." : "There may be other curves.") +
                  " Dots: where the value that is held turns back, and two cusps meet."};
    page.figures = {{"", {}, {plane(others_[0], others_[1]), plane(held_, others_[0]), counts()}}};
    for (std::size_t i = 0; i < found_.curves.size(); ++i)
      page.legend.push_back({curve_color(i), true, "curve " + std::to_string(i + 1)});
    return draw_page(page);
  }

 private:
  std::string title(std::size_t leg) const {
    return robot_.leg(leg).actuated_joint + " [" + joint_unit(robot_.leg(leg)) + "]";
  }

  /// From the least to the largest value of a joint on all curves.
  PanelAxis axis(std::size_t leg) const {
    PanelAxis result{title(leg), HUGE_VAL, -HUGE_VAL, false};
    for (const CuspCurve& curve : found_.curves)
      for (const Cusp& cusp : curve.points) {
        const double value = cusp.actuated[static_cast<Eigen::Index>(leg)];
        result.lower = std::min(result.lower, value);
        result.upper = std::max(result.upper, value);
      }
    if (!(result.lower < result.upper)) return {title(leg), 0.0, 1.0, false};
    const double more = 0.03 * (result.upper - result.lower);
    result.lower -= more;
    result.upper += more;
    return result;
  }

  PanelContents plane(std::size_t x, std::size_t y) const {
    PanelContents panel;
    panel.caption = "cusps, by actuated values";
    panel.axes = {axis(x), axis(y)};
    const auto place = [&](const Cusp& cusp) {
      return Vector2d(cusp.actuated[static_cast<Eigen::Index>(x)],
                      cusp.actuated[static_cast<Eigen::Index>(y)]);
    };
    for (std::size_t i = 0; i < found_.curves.size(); ++i) {
      add_curve(found_.curves[i], place, curve_color(i), "curve " + std::to_string(i + 1), panel);
      for (const std::size_t turn : turns(found_.curves[i]))
        panel.marks.push_back({place(found_.curves[i].points[turn]), ""});
    }
    return panel;
  }

  /// In pieces where the values of a crank go from one end of the turn to the other.
  template <class Place>
  static void add_curve(const CuspCurve& curve, const Place& place, Rgb color, const std::string& words,
                        PanelContents& panel) {
    PanelLine line{{}, color, words};
    for (std::size_t n = 0; n < curve.points.size(); ++n) {
      const bool jumps =
          n > 0 && (curve.points[n].actuated - curve.points[n - 1].actuated).cwiseAbs().maxCoeff() > pi;
      if (jumps && !line.points.empty()) panel.lines.push_back(std::exchange(line, {{}, color, words}));
      line.points.push_back(place(curve.points[n]));
    }
    if (curve.closed && !curve.points.empty()) line.points.push_back(place(curve.points.front()));
    panel.lines.push_back(std::move(line));
  }

  /// Points where the value that is held is larger, or smaller, than beside them.
  std::vector<std::size_t> turns(const CuspCurve& curve) const {
    std::vector<std::size_t> result;
    const auto held = [&](std::size_t n) {
      return curve.points[n % curve.points.size()].actuated[static_cast<Eigen::Index>(held_)];
    };
    const std::size_t count = curve.points.size();
    for (std::size_t n = 0; n < count; ++n) {
      if (!curve.closed && (n == 0 || n + 1 == count)) continue;
      if ((held(n) - held(n + count - 1)) * (held(n + 1) - held(n)) < 0.0) result.push_back(n);
    }
    return result;
  }

  PanelContents counts() const {
    PanelContents panel;
    panel.caption = "number of cusps";
    std::size_t most = 1;
    for (const CuspCount& each : found_.counts) most = std::max(most, each.cusps);
    panel.axes = {PanelAxis{title(held_), found_.range.lower, found_.range.upper, false},
                  PanelAxis{"cusps", 0.0, static_cast<double>(most + 1), false}};
    for (const CuspCount& each : found_.counts) {
      const auto height = static_cast<double>(each.cusps);
      panel.lines.push_back(
          {{{each.lower, height}, {each.upper, height}}, count_color, counted(each.cusps, "cusp")});
    }
    return panel;
  }

  const Manipulator& robot_;
  const CuspCurves& found_;
  std::size_t held_;
  std::array<std::size_t, 2> others_{};
};

}  // namespace

Picture draw_cusp_curves(const Manipulator& robot, const CuspCurves& found) {
  return CurvesDrawing(robot, found).draw();
}

}  // namespace parallel_aspects::tools
