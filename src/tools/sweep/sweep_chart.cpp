// SPDX-License-Identifier: BSD-3-Clause
#include "tools/sweep/sweep_chart.h"

#include "tools/report/report.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>

namespace parallel_aspects::tools {
namespace {

constexpr std::size_t no_column = static_cast<std::size_t>(-1);

std::size_t index_of_column(const SweepTable& table, const std::string& name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  return found == table.columns.end() ? no_column : static_cast<std::size_t>(found - table.columns.begin());
}

std::optional<double> number_in(const std::vector<std::string>& row, std::size_t column) {
  if (column == no_column || row[column].empty()) return std::nullopt;
  return std::strtod(row[column].c_str(), nullptr);
}

/// Names between "design" and "status", and those behind.
std::pair<std::vector<std::string>, std::vector<std::string>> parameters_and_figures(
    const SweepTable& table) {
  const auto status = std::find(table.columns.begin(), table.columns.end(), "status");
  return {{table.columns.begin() + 1, status}, {std::next(status), table.columns.end()}};
}

/// Rows that have the fixed values.
std::vector<const std::vector<std::string>*> chosen_rows(const SweepTable& table,
                                                         const ChartQuestion& question) {
  std::vector<const std::vector<std::string>*> rows;
  for (const auto& row : table.rows) {
    const bool fits = std::all_of(question.fixed.begin(), question.fixed.end(), [&](const auto& fixed) {
      return number_in(row, index_of_column(table, fixed.first)) == fixed.second;
    });
    if (fits) rows.push_back(&row);
  }
  return rows;
}

void check_names(const SweepTable& table, const ChartQuestion& question, Problems& problems) {
  const auto [parameters, figures] = parameters_and_figures(table);
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (!has(figures, question.column))
    problems.push_back("--column is '" + question.column + "'; the file has " + joined(figures, ", ") + ".");
  for (const std::string& name : question.over)
    if (!has(parameters, name))
      problems.push_back("--over names '" + name + "'; the file has " + joined(parameters, ", ") + ".");
  for (const auto& fixed : question.fixed)
    if (!has(parameters, fixed.first))
      problems.push_back("--at names '" + fixed.first + "'; the file has " + joined(parameters, ", ") + ".");
}

std::vector<std::string> varying(const SweepTable& table,
                                 const std::vector<const std::vector<std::string>*>& rows) {
  std::vector<std::string> names;
  for (const std::string& name : parameters_and_figures(table).first) {
    std::set<std::string> values;
    for (const auto* row : rows) values.insert((*row)[index_of_column(table, name)]);
    if (values.size() > 1) names.push_back(name);
  }
  return names;
}

void check_over(const std::vector<std::string>& over, const std::vector<std::string>& all,
                Problems& problems) {
  if (over.empty()) problems.emplace_back("No parameter varies in these rows; choose others by --at.");
  if (over.size() > 2)
    problems.push_back(joined(over, ", ") + " vary; name one or two by --over, and hold the others by --at.");
  for (const std::string& name : all)
    if (over.size() <= 2 && !over.empty() && std::find(over.begin(), over.end(), name) == over.end())
      problems.push_back("'" + name + "' varies, too; hold it by --at, such as --at \"" + name + "=1\".");
}

std::vector<double> values_along(const SweepChart& chart, double ChartPoint::*coordinate) {
  std::set<double> values;
  for (const ChartPoint& point : chart.points) values.insert(point.*coordinate);
  return {values.begin(), values.end()};
}

/// From dark blue over green to yellow (after the scale "viridis" of matplotlib), which grows lighter evenly.
Rgb color_of_share(double share) {
  return color_along({0x440154, 0x414487, 0x2A788E, 0x22A884, 0x7AD151, 0xFDE725}, share);
}

// Lengths on the page [px].
constexpr double left = 80.0, top = 50.0, width = 520.0, height = 380.0, right = 130.0, bottom = 70.0;
constexpr double mark = 4.0, scale_width = 18.0;
constexpr Rgb frame_color = 0x888888, curve_color = 0x1F77B4, change_color = 0xD62728;

PageLine rectangle_of(const PagePoint& low, const PagePoint& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

/// Places on the page, and what belongs to every chart.
class ChartPage {
 public:
  ChartPage(const SweepChart& chart, const std::string& title) : chart_(chart) {
    for (const ChartPoint& point : chart.points)
      if (point.value) {
        least_ = std::min(least_.value_or(*point.value), *point.value);
        most_ = std::max(most_.value_or(*point.value), *point.value);
      }
    picture_.width = left + width + right;
    picture_.height = top + height + bottom;
    text({20.0, 24.0}, TextAnchor::start, title, 14.0);
  }

  PagePicture take() { return std::move(picture_); }

 protected:
  const SweepChart& chart() const { return chart_; }
  double least() const { return least_.value_or(0.0); }
  double most() const { return most_.value_or(0.0); }
  double share_of(double value) const {
    return most() > least() ? (value - least()) / (most() - least()) : 0.5;
  }

  void text(const PagePoint& at, TextAnchor anchor, const std::string& words, double size = 11.0) {
    picture_.elements.emplace_back(PageText{at, anchor, size, words});
  }

  void area(const PageLine& loop, Rgb color, const std::string& words) {
    picture_.elements.emplace_back(PageArea{{loop}, color, words});
  }

  void curves(std::vector<PageLine> lines, Rgb color, double line_width, bool dashed = false,
              const std::string& words = "") {
    if (!lines.empty())
      picture_.elements.emplace_back(PageCurves{std::move(lines), color, line_width, dashed, words});
  }

  /// Where a value is on the page, for the ends of an axis.
  struct AxisEnds {
    std::string name;                                 ///< empty for none
    std::array<std::pair<double, double>, 2> places;  ///< [px], and the value there
  };

  void frame(const AxisEnds& across, const AxisEnds& up) {
    PageLine loop = rectangle_of({left, top}, {left + width, top + height});
    loop.push_back(loop.front());
    curves({loop}, frame_color, 1.0);
    for (const auto& [x, value] : across.places)
      text({x, top + height + 16.0}, TextAnchor::middle, shown_briefly(value));
    for (const auto& [y, value] : up.places)
      text({left - 6.0, y + 4.0}, TextAnchor::end, shown_briefly(value));
    text({left + 0.5 * width, top + height + 16.0}, TextAnchor::middle, across.name);
    text({left - 6.0, top + 0.5 * height}, TextAnchor::end, up.name);
  }

  void legend_of_lines() {
    const double y = top + height + 40.0;
    if (!chart_.has_count)
      return text({left, y}, TextAnchor::start,
                  "numbers of aspects are not in the file: --report count has them");
    curves({{{left, y - 4.0}, {left + 30.0, y - 4.0}}}, change_color, 2.0);
    text({left + 36.0, y}, TextAnchor::start, "the number of aspects changes, proved");
    curves({{{left + 270.0, y - 4.0}, {left + 300.0, y - 4.0}}}, change_color, 1.2, true);
    text({left + 306.0, y}, TextAnchor::start, "it may change");
  }

 private:
  const SweepChart& chart_;
  std::optional<double> least_, most_;
  PagePicture picture_;
};

std::string words_of(const ChartPoint& point) {
  std::string words = point.value ? shown_briefly(*point.value) : "not known";
  if (!point.least) return words;
  words += ", aspects: " + shown_briefly(*point.least);
  if (point.most == point.least) return words;
  return words + (point.most ? " to " + shown_briefly(*point.most) : " or more");
}

class CurveChart : public ChartPage {
 public:
  CurveChart(const SweepChart& chart, const std::string& title)
      : ChartPage(chart, title), points_(chart.points) {
    std::sort(points_.begin(), points_.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  }

  void draw() {
    frame({chart().over.front() + " [m]",
           {{{x(points_.front().x), points_.front().x}, {x(points_.back().x), points_.back().x}}}},
          {"", {{{top + height, least()}, {top, most()}}}});
    lines_of_changes();
    std::vector<PageLine> pieces(1);
    for (const ChartPoint& point : points_) {
      if (!point.value) {
        pieces.emplace_back();  // a gap
        continue;
      }
      const PagePoint at(x(point.x), top + (1.0 - share_of(*point.value)) * height);
      pieces.back().push_back(at);
      area(rectangle_of(at - PagePoint(2.5, 2.5), at + PagePoint(2.5, 2.5)), curve_color, words_of(point));
    }
    pieces.erase(
        std::remove_if(pieces.begin(), pieces.end(), [](const auto& piece) { return piece.size() < 2; }),
        pieces.end());
    curves(pieces, curve_color, 1.5);
    legend_of_lines();
  }

 private:
  double x(double value) const {
    const double from = points_.front().x, to = points_.back().x;
    return left + (to > from ? (value - from) / (to - from) : 0.5) * width;
  }

  void lines_of_changes() {
    std::map<CountChange, std::vector<PageLine>> lines;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const double at = x(0.5 * (points_[i].x + points_[i + 1].x));
      lines[change_between(points_[i], points_[i + 1])].push_back({{at, top}, {at, top + height}});
    }
    curves(lines[CountChange::proved], change_color, 2.0);
    curves(lines[CountChange::possible], change_color, 1.2, true);
  }

  std::vector<ChartPoint> points_;
};

/// Borders of the cells about rising values: halfway between them, and as far beyond the ends.
std::vector<double> borders_of(const std::vector<double>& values) {
  std::vector<double> borders;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) borders.push_back(0.5 * (values[i] + values[i + 1]));
  borders.insert(borders.begin(),
                 values.front() - (borders.empty() ? 0.5 : borders.front() - values.front()));
  borders.push_back(values.back() + (borders.size() == 1 ? 0.5 : values.back() - borders.back()));
  return borders;
}

class PlaneChart : public ChartPage {
 public:
  PlaneChart(const SweepChart& chart, const std::string& title)
      : ChartPage(chart, title),
        xs_(values_along(chart, &ChartPoint::x)),
        ys_(values_along(chart, &ChartPoint::y)),
        x_borders_(borders_of(xs_)),
        y_borders_(borders_of(ys_)) {}

  void draw() {
    const bool is_grid = xs_.size() * ys_.size() <= 2 * chart().points.size();
    frame({chart().over[0] + " [m]", {{{x(xs_.front()), xs_.front()}, {x(xs_.back()), xs_.back()}}}},
          {chart().over[1] + " [m]", {{{y(ys_.front()), ys_.front()}, {y(ys_.back()), ys_.back()}}}});
    is_grid ? cells() : marks();
    scale();
    if (is_grid) legend_of_lines();
  }

 private:
  using Cell = std::pair<std::size_t, std::size_t>;

  double x(double value) const {
    return left + (value - x_borders_.front()) / (x_borders_.back() - x_borders_.front()) * width;
  }
  double y(double value) const {
    return top + (y_borders_.back() - value) / (y_borders_.back() - y_borders_.front()) * height;
  }

  Rgb color_of(const ChartPoint& point) const {
    return point.value ? color_of_share(share_of(*point.value)) : undecided_color;
  }

  void cells() {
    std::map<Cell, const ChartPoint*> by_cell;
    for (const ChartPoint& point : chart().points) {
      const auto place = [](const std::vector<double>& values, double value) {
        return static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), value) -
                                        values.begin());
      };
      const Cell cell(place(xs_, point.x), place(ys_, point.y));
      by_cell[cell] = &point;
      area(rectangle_of({x(x_borders_[cell.first]), y(y_borders_[cell.second])},
                        {x(x_borders_[cell.first + 1]), y(y_borders_[cell.second + 1])}),
           color_of(point), words_of(point));
    }
    std::map<CountChange, std::vector<PageLine>> lines;
    for (const auto& [cell, point] : by_cell) {
      const auto [i, j] = cell;
      if (const auto other = by_cell.find({i + 1, j}); other != by_cell.end())
        lines[change_between(*point, *other->second)].push_back(
            {{x(x_borders_[i + 1]), y(y_borders_[j])}, {x(x_borders_[i + 1]), y(y_borders_[j + 1])}});
      if (const auto other = by_cell.find({i, j + 1}); other != by_cell.end())
        lines[change_between(*point, *other->second)].push_back(
            {{x(x_borders_[i]), y(y_borders_[j + 1])}, {x(x_borders_[i + 1]), y(y_borders_[j + 1])}});
    }
    curves(lines[CountChange::proved], change_color, 2.0, false, "the number of aspects changes");
    curves(lines[CountChange::possible], change_color, 1.2, true, "the number of aspects may change");
  }

  void marks() {
    for (const ChartPoint& point : chart().points) {
      const PagePoint at(x(point.x), y(point.y));
      area(rectangle_of(at - PagePoint(mark, mark), at + PagePoint(mark, mark)), color_of(point),
           words_of(point));
    }
  }

  void scale() {
    constexpr int steps = 40;
    const double from = left + width + 20.0, step = height / steps;
    for (int i = 0; i < steps; ++i) {
      const double low = top + height - step * static_cast<double>(i);
      area(rectangle_of({from, low - step - 0.5}, {from + scale_width, low}),
           color_of_share((static_cast<double>(i) + 0.5) / steps), "");
    }
    text({from + scale_width + 5.0, top + height}, TextAnchor::start, shown_briefly(least()));
    text({from + scale_width + 5.0, top + 10.0}, TextAnchor::start, shown_briefly(most()));
    text({from, top - 8.0}, TextAnchor::start, chart().column);
  }

  std::vector<double> xs_, ys_, x_borders_, y_borders_;
};

}  // namespace

CountChange change_between(const ChartPoint& a, const ChartPoint& b) {
  const auto above = [](const ChartPoint& high, const ChartPoint& low) {
    return high.least && low.most && *high.least > *low.most;
  };
  if (above(a, b) || above(b, a)) return CountChange::proved;
  const bool both_known = a.least && b.least && a.least == a.most && b.least == b.most;
  return both_known || !a.least || !b.least || (a.least == b.least && a.most == b.most)
             ? CountChange::none
             : CountChange::possible;
}

SweepChart chart_of(const SweepTable& table, const ChartQuestion& question) {
  Problems problems;
  check_names(table, question, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const auto rows = chosen_rows(table, question);
  if (rows.empty()) throw InvalidDescription({"No row has the values of --at; give some that the file has."});
  const std::vector<std::string> all = varying(table, rows);
  SweepChart chart{question.column, question.over.empty() ? all : question.over, {}, false};
  check_over(chart.over, all, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const std::size_t least = index_of_column(table, "aspects_at_least"),
                    most = index_of_column(table, "aspects_at_most");
  chart.has_count = least != no_column;
  for (const auto* row : rows) {
    const auto at = [&](std::size_t i) { return *number_in(*row, index_of_column(table, chart.over[i])); };
    chart.points.push_back({at(0), chart.over.size() > 1 ? at(1) : 0.0,
                            number_in(*row, index_of_column(table, chart.column)), number_in(*row, least),
                            number_in(*row, most)});
  }
  return chart;
}

PagePicture draw_chart(const SweepChart& chart, const std::string& title) {
  if (chart.over.size() == 1) {
    CurveChart page(chart, title);
    page.draw();
    return page.take();
  }
  PlaneChart page(chart, title);
  page.draw();
  return page.take();
}

}  // namespace parallel_aspects::tools
