// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/text_table.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects::tools {

TextTable::TextTable(const std::vector<std::string>& titles) {
  rows_.emplace_back();
  for (const std::string& title : titles) {
    const bool right = !title.empty() && title.front() == '>';
    right_aligned_.push_back(right);
    rows_.front().push_back(right ? title.substr(1) : title);
  }
}

void TextTable::add(std::vector<std::string> cells) {
  cells.resize(right_aligned_.size());
  rows_.push_back(std::move(cells));
}

std::string TextTable::text() const {
  std::vector<std::size_t> widths(right_aligned_.size(), 0);
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string result;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string blanks(widths[i] - row[i].size(), ' ');
      line += (i == 0 ? "" : "  ") + (right_aligned_[i] ? blanks + row[i] : row[i] + blanks);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    result += line + '\n';
  }
  return result;
}

}  // namespace parallel_aspects::tools
