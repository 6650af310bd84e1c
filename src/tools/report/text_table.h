// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_TEXT_TABLE_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_TEXT_TABLE_H

#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// Columns of text, each as wide as its longest cell.
class TextTable {
 public:
  /// One title a column; a title that starts with '>' (not shown) makes its column right-aligned.
  explicit TextTable(const std::vector<std::string>& titles);

  /// Adds a row with one cell a column.
  void add(std::vector<std::string> cells);

  /// Titles and rows, two blanks between columns, no blanks at the ends of lines.
  std::string text() const;

 private:
  std::vector<bool> right_aligned_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_TEXT_TABLE_H
