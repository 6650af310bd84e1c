// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/page_elements.h"

#include <algorithm>

namespace parallel_aspects::tools {

double text_width(const std::string& text, double size) {
  constexpr double widest = 0.64;  // of the letters of DejaVu Sans, on average, in heights of the font
  const auto letters = std::count_if(text.begin(), text.end(), [](char each) {
    return (static_cast<unsigned char>(each) & 0xC0U) != 0x80U;
  });
  return widest * size * static_cast<double>(letters);
}

}  // namespace parallel_aspects::tools
