// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/svg.h"

#include "model/number_text.h"

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

}  // namespace parallel_aspects::tools::svg
