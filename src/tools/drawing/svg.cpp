// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/svg.h"

#include "model/number_text.h"
#include "tools/drawing/page_elements.h"

namespace parallel_aspects::tools::svg {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char character : text) {
    if (character == '&')
      result += "&amp;";
    else if (character == '<')
      result += "&lt;";
    else if (character == '>')
      result += "&gt;";
    else
      result += character;
  }
  return result;
}

std::string number(double value) { return fixed_number_text(value, 2); }

std::string start(double width, double height) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width) + "\" height=\"" +
         number(height) +
         "\" font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

std::string text_at(double x, double y, const std::string& anchor, const std::string& text, double size) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" font-size=\"" + number(size) +
         "\" text-anchor=\"" + anchor + "\">" + escaped(text) + "</text>\n";
}

std::string key(double x, double y, const std::vector<std::pair<std::string, std::string>>& entries) {
  constexpr double patch = 9.0, before_words = 5.0, after_words = 14.0;
  std::string result;
  for (const auto& [color, words] : entries) {
    result += "<rect x=\"" + number(x) + "\" y=\"" + number(y - patch) + "\" width=\"" + number(patch) +
              "\" height=\"" + number(patch) + "\" fill=\"" + color + "\"/>\n" +
              text_at(x + patch + before_words, y, "start", words);
    x += patch + before_words + text_width(words, font_size) + after_words;
  }
  return result;
}

}  // namespace parallel_aspects::tools::svg
