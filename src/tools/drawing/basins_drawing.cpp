// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/result_charts.h"
#include "tools/drawing/svg.h"
#include "tools/report/basins_report.h"
#include "tools/report/reports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
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

constexpr const char *dark_positive = "#4477aa", *dark_negative = "#cc6677", *light_positive = "#b4c8dd",
                     *light_negative = "#ebc2c9";

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
                        {{dark_positive, "det A > 0"},
                         {dark_negative, "det A < 0"},
                         {light_positive, ""},
                         {light_negative, "between the proved bounds of an end"}});
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
    const bool positive = aspect.determinant_sign > 0;
    const std::string dark = positive ? dark_positive : dark_negative,
                      light = positive ? light_positive : light_negative;
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

}  // namespace parallel_aspects::tools
