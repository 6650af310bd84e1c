// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_PROGRESS_BAR_H
#define PARALLEL_ASPECTS_TOOLS_PROGRESS_BAR_H

#include <ostream>

namespace parallel_aspects::tools {

/// A line on a terminal that shows the share of work done, and is gone when the bar is.
class ProgressBar {
 public:
  explicit ProgressBar(std::ostream& terminal) : terminal_(terminal) {}
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Draws the share done, 0 to 1, if it changed visibly.
  void show(double share);

 private:
  std::ostream& terminal_;
  int drawn_percent_ = -1;
};

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_PROGRESS_BAR_H
