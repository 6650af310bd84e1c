// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/result_charts.h"

#include "draw/page/page_elements.h"
#include "draw/plane/palette.h"
#include "model/message_text.h"
#include "tools/report/basins_report.h"
#include "tools/report/reports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using svg::number;
using svg::text_at;

// Lengths on the page [px].
constexpr double bars_left = 190.0, bars_width = 480.0, first_row = 66.0, row_height = 13.0, bar_height = 8.0,
                 bottom = 30.0;

// Shorter bars, as a share of the longest, are counted and not drawn.
constexpr double least_share = 0.02;

class BasinsDrawing {
 public:
  BasinsDrawing(const AspectMap& map, const MapBasins& basins) : map_(map), basins_(basins) {
    for (const Basin& basin : basins.basins) largest_ = std::max(largest_, basin.depth.upper);
    rows_.resize(basins.basins.size());
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (!basins.basins[i].deeper || length(basins.basins[i]) >= least_share * largest_) rows_[i] = count_++;
  }

  std::string text() const {
    const double height = first_row + static_cast<double>(count_) * row_height + bottom;
    std::string picture = svg::start(bars_left + bars_width + 30.0, height);
    picture += text_at(10.0, 18.0, "start", map_.manipulator()->name() + ": basins of its aspects", 14.0);
    picture += text_at(10.0, 34.0, "start", caption());
    picture += svg::key(10.0, 50.0,
                        {{color_text(sign_color(1)), "det A > 0"},
                         {color_text(sign_color(-1)), "det A < 0"},
                         {color_text(sign_color(1, true)), ""},
                         {color_text(sign_color(-1, true)), "between the proved bounds of an end"}});
    picture += scale(first_row - 4.0, height - bottom + 4.0);
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (rows_[i]) picture += row(basins_.basins[i], *rows_[i]);
    return picture + "</svg>\n";
  }

 private:
  static double length(const Basin& basin) { return basin.depth.lower - basin.saddle.upper; }

  std::string caption() const {
    const std::size_t left_out = basins_.basins.size() - count_;
    return "from where a basin merges into a deeper one to its largest " + index_name(basins_.index) +
           (left_out == 0 ? "" : "; " + counted(left_out, "shorter one") + " not drawn");
  }

  double x(double index) const { return bars_left + (largest_ > 0.0 ? bars_width * index / largest_ : 0.0); }
  static double y(std::size_t row) { return first_row + static_cast<double>(row) * row_height; }

  std::string scale(double from, double to) const {
    std::string picture;
    for (int k = 0; k <= 4; ++k) {
      const double index = 0.25 * k * largest_;
      picture += "<path stroke=\"#dddddd\" d=\"M" + number(x(index)) + " " + number(from) + "V" + number(to) +
                 "\"/>\n" + text_at(x(index), to + 14.0, "middle", shown_briefly(index));
    }
    return picture;
  }

  std::string row(const Basin& basin, std::size_t row) const {
    const Aspect& aspect = map_.aspects()[static_cast<std::size_t>(basin.aspect - 1)];
    const std::string dark = color_text(sign_color(aspect.determinant_sign)),
                      light = color_text(sign_color(aspect.determinant_sign, true));
    const IndexRange start = basin.deeper ? basin.saddle : IndexRange{0.0, 0.0};
    std::string picture =
        bar(start.lower, basin.depth.upper, row, light) + bar(start.upper, basin.depth.lower, row, dark) +
        text_at(bars_left - 6.0, y(row) + bar_height, "end",
                "aspect " + std::to_string(basin.aspect) + " " + to_string(aspect.mode), 9.0);
    if (basin.deeper && rows_[*basin.deeper])
      picture += "<path stroke=\"" + dark + "\" d=\"M" + number(x(start.upper)) + " " +
                 number(y(row) + bar_height) + "V" + number(y(*rows_[*basin.deeper])) + "\"/>\n";
    return picture;
  }

  std::string bar(double from, double to, std::size_t row, const std::string& color) const {
    return "<rect x=\"" + number(x(from)) + "\" y=\"" + number(y(row)) + "\" width=\"" +
           number(std::max(0.0, x(to) - x(from))) + "\" height=\"" + number(bar_height) + "\" fill=\"" +
           color + "\"/>\n";
  }

  const AspectMap& map_;
  const MapBasins& basins_;
  double largest_ = 0.0;
  std::vector<std::optional<std::size_t>> rows_;  // of those that are drawn
  std::size_t count_ = 0;
};

}  // namespace

std::string draw_basins(const AspectMap& map, const MapBasins& basins) {
  return BasinsDrawing(map, basins).text();
}

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
