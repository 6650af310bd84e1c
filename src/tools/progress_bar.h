// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_PROGRESS_BAR_H
#define PARALLEL_ASPECTS_TOOLS_PROGRESS_BAR_H

#include <ostream>
#include <string>

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

  /// The same, with the time that is left at the speed so far: `seconds` since the share was `from`.
  void show(double share, double from, double seconds);

 private:
  void draw(double share, const std::string& more);

  std::ostream& terminal_;
  std::string drawn_;
};

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_PROGRESS_BAR_H
