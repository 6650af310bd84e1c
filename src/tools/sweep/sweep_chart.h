// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_CHART_H
#define PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_CHART_H

#include "draw/page/page_elements.h"
#include "parallel_aspects/model/problems.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {

/// The rows of a sweep, as a file has them.
struct SweepTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  ///< a cell a column; empty where a figure is not known
};

/// The rows of a finished sweep, or of one of its shards. Throws `InvalidDescription` where it is none.
SweepTable read_sweep_table(const std::string& file);

/// What is drawn of a table.
struct ChartQuestion {
  std::string column;                                 ///< of figures
  std::vector<std::string> over;                      ///< one or two parameters; empty for those that vary
  std::vector<std::pair<std::string, double>> fixed;  ///< rows with these values alone
};

/// One design that is drawn.
struct ChartPoint {
  double x = 0.0, y = 0.0;      ///< its parameters; y of no meaning where there is one
  std::optional<double> value;  ///< nothing where it is not known
  std::optional<double> least;  ///< number of aspects at least
  std::optional<double> most;   ///< and at most
};

/// How sure it is that two designs differ in their number of aspects.
enum class CountChange { none, possible, proved };
CountChange change_between(const ChartPoint& a, const ChartPoint& b);

/// A column over one or two parameters.
struct SweepChart {
  std::string column;
  std::vector<std::string> over;   ///< one or two
  std::vector<ChartPoint> points;  ///< no two with the same parameters
  bool has_count = false;          ///< whether numbers of aspects are known at all
};

/// Throws `InvalidDescription` with every problem: unknown columns, more parameters that vary than are drawn,
/// no rows.
SweepChart chart_of(const SweepTable& table, const ChartQuestion& question);

/// Over one parameter a curve; over two the cells of a grid, or a mark for each design where they form none.
/// Between neighbours whose numbers of aspects are proved to differ there are lines, dashed where they may
/// differ.
PagePicture draw_chart(const SweepChart& chart, const std::string& title);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_CHART_H
