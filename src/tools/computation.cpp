// SPDX-License-Identifier: BSD-3-Clause
#include "tools/computation.h"

#include "model/message_text.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace parallel_aspects::tools {
namespace {

constexpr int cells = 40;
constexpr const char* clear_line = "\r\x1b[K";

/// "40 s", "12 min" or "3.4 h".
std::string time_text(double seconds) {
  if (seconds < 100.0) return std::to_string(std::lround(seconds)) + " s";
  if (seconds < 6000.0) return std::to_string(std::lround(seconds / 60.0)) + " min";
  return number_text(seconds / 3600.0, 2) + " h";
}

}  // namespace

ProgressBar::~ProgressBar() {
  if (!drawn_.empty()) terminal_ << clear_line << std::flush;
}

void ProgressBar::show(double share) { draw(share, ""); }

void ProgressBar::show(double share, double from, double seconds) {
  const double left = (1.0 - share) / (share - from) * seconds;
  draw(share, share > from && std::isfinite(left) ? ", " + time_text(left) + " left" : "");
}

void ProgressBar::draw(double share, const std::string& more) {
  if (!std::isfinite(share)) return;
  const int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
  const auto full = static_cast<std::size_t>(percent * cells / 100);
  const std::string line = "[" + std::string(full, '#') + std::string(cells - full, ' ') + "] " +
                           std::to_string(percent) + " %" + more;
  if (line == drawn_) return;
  drawn_ = line;
  terminal_ << clear_line << line << std::flush;
}

}  // namespace parallel_aspects::tools
