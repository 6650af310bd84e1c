// SPDX-License-Identifier: BSD-3-Clause
#include "tools/progress_bar.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace parallel_aspects::tools {
namespace {

constexpr int cells = 40;
constexpr const char* clear_line = "\r\x1b[K";

}  // namespace

ProgressBar::~ProgressBar() {
  if (drawn_percent_ >= 0) terminal_ << clear_line << std::flush;
}

void ProgressBar::show(double share) {
  if (!std::isfinite(share)) return;
  const int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
  if (percent == drawn_percent_) return;
  drawn_percent_ = percent;
  const auto full = static_cast<std::size_t>(percent * cells / 100);
  terminal_ << clear_line << '[' << std::string(full, '#') << std::string(cells - full, ' ') << "] "
            << percent << " %" << std::flush;
}

}  // namespace parallel_aspects::tools
