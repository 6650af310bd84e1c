// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/pictures/palette.h"
#include "model/number_text.h"
#include "tools/drawing/page_elements.h"
#include "tools/drawing/result_charts.h"
#include "tools/drawing/svg.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using svg::number;
using svg::text_at;

// Lengths on the page [px].
constexpr double chart_left = 70.0, chart_width = 640.0, first_chart = 66.0, chart_height = 180.0,
                 chart_gap = 50.0;

/// Colours of curves and what they mean.
using ChartKey = std::vector<std::pair<std::string, std::string>>;

/// In the colours that boundaries have in all pictures.
ChartKey boundary_key() {
  return {{color_text(boundary_color(BoundaryKind::parallel)), "parallel singularities"},
          {color_text(boundary_color(BoundaryKind::serial)), "serial singularities"},
          {color_text(boundary_color(BoundaryKind::limit)), "limits"}};
}

/// A panel of curves over time, from 0 to the largest value.
class Chart {
 public:
  Chart(const TrajectoryCheck& check, double y, double largest)
      : check_(check), y_(y), largest_(largest > 0.0 ? largest : 1.0) {
    begin_ = check.samples.front().time;
    end_ = std::max({check.samples.back().time, check.followed_until, begin_ + 1e-12});
    if (check.violation) end_ = std::max(end_, check.violation->before);
    for (const TrajectoryCrossing& crossing : check.crossings) end_ = std::max(end_, crossing.before);
  }

  std::string frame(const std::string& title, const ChartKey& key) const {
    std::string text = "<rect x=\"" + number(chart_left) + "\" y=\"" + number(y_) + "\" width=\"" +
                       number(chart_width) + "\" height=\"" + number(chart_height) +
                       "\" fill=\"none\" stroke=\"#888888\"/>\n";
    text += text_at(chart_left, y_ - 6.0, "start", title);
    text += svg::key(chart_left + text_width(title, svg::font_size) + 14.0, y_ - 6.0, key);
    text += text_at(chart_left - 6.0, y_ + 10.0, "end", number_text(largest_, 3));
    text += text_at(chart_left - 6.0, y_ + chart_height, "end", "0");
    text += text_at(chart_left, y_ + chart_height + 14.0, "start", number_text(begin_) + " s");
    text += text_at(chart_left + chart_width, y_ + chart_height + 14.0, "end", number_text(end_) + " s");
    for (const TrajectoryCrossing& crossing : check_.crossings) text += line_at(crossing.before);
    return text;
  }

  std::string curve(const std::string& color, const std::function<double(std::size_t)>& value) const {
    std::string points;
    for (std::size_t i = 0; i < check_.samples.size(); ++i) {
      const double share = std::clamp(value(i) / largest_, 0.0, 1.0);
      if (std::isfinite(share))
        points += number(x(check_.samples[i].time)) + "," + number(y_ + (1.0 - share) * chart_height) + " ";
    }
    return "<polyline fill=\"none\" stroke=\"" + color + "\" points=\"" + points + "\"/>\n";
  }

 private:
  double x(double time) const { return chart_left + chart_width * (time - begin_) / (end_ - begin_); }

  std::string line_at(double time) const {
    return "<line x1=\"" + number(x(time)) + "\" y1=\"" + number(y_) + "\" x2=\"" + number(x(time)) +
           "\" y2=\"" + number(y_ + chart_height) + "\" stroke=\"#000000\" stroke-dasharray=\"4 3\"/>\n";
  }

  const TrajectoryCheck& check_;
  double y_, largest_, begin_ = 0.0, end_ = 1.0;
};

std::string draw_indices(const TrajectoryCheck& check, double y) {
  const Chart panel(check, y, 1.0);
  const ChartKey key{boundary_key()[0], boundary_key()[1]};
  return panel.frame("least index:", key) + panel.curve(key[0].first, [&](std::size_t i) {
    return check.samples[i].parallel_index;
  }) + panel.curve(key[1].first, [&](std::size_t i) { return check.samples[i].serial_indices.minCoeff(); });
}

std::string draw_distances(const TrajectoryCheck& check, const std::vector<SampleDistances>& distances,
                           double y) {
  double largest = 0.0;
  for (const SampleDistances& each : distances)
    for (const double value : each.lower)
      if (std::isfinite(value)) largest = std::max(largest, value);
  const Chart panel(check, y, largest);
  const ChartKey key = boundary_key();
  std::string text = panel.frame("proved distance [m] to", key);
  for (std::size_t k = 0; k < key.size(); ++k)
    text += panel.curve(key[k].first, [&](std::size_t i) { return distances[i].lower[k]; });
  return text;
}

}  // namespace

std::string draw_check(const Manipulator& manipulator, const TrajectoryCheck& check,
                       const std::vector<SampleDistances>& distances) {
  const double below = first_chart + chart_height + chart_gap;
  std::string picture = svg::start(chart_left + chart_width + 30.0,
                                   (distances.empty() ? first_chart : below) + chart_height + chart_gap);
  picture += text_at(10.0, 18.0, "start", manipulator.name() + ", safe: " + name(check.answer), 14.0);
  picture += text_at(10.0, 34.0, "start", check.reason);
  if (!check.samples.empty()) picture += draw_indices(check, first_chart);
  if (!distances.empty()) picture += draw_distances(check, distances, below);
  return picture + "</svg>\n";
}

}  // namespace parallel_aspects::tools
