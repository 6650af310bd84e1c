// SPDX-License-Identifier: BSD-3-Clause
#include "draw/page/page_elements.h"

#include "model/message_text.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {

double text_width(const std::string& text, double size) {
  constexpr double widest = 0.64;  // of the letters of DejaVu Sans, on average, in heights of the font
  const auto letters = std::count_if(text.begin(), text.end(), [](char each) {
    return (static_cast<unsigned char>(each) & 0xC0U) != 0x80U;
  });
  return widest * size * static_cast<double>(letters);
}

}  // namespace parallel_aspects

namespace parallel_aspects::svg {

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

}  // namespace parallel_aspects::svg

namespace parallel_aspects {
namespace {

using svg::number;

// "12.50" as "12.5", "3.00" as "3".
std::string brief(double value) {
  std::string text = number(value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

// As short as paths may say it: "0.5" as ".5".
std::string step_text(double step) {
  std::string text = brief(step);
  const std::size_t zero = text.find("0.");
  if (zero == 0 || (zero == 1 && text[0] == '-')) text.erase(zero, 1);
  return text;
}

double rounded(double value) { return 0.01 * std::round(100.0 * value); }

// Steps from point to point are half as long as the points.
std::string path_of(const std::vector<PageLine>& lines, bool closed) {
  std::string path;
  for (const PageLine& line : lines) {
    PagePoint from = line.front().unaryExpr(&rounded);
    path += "M" + brief(from.x()) + " " + brief(from.y()) + (line.size() > 1 ? "l" : "");
    for (std::size_t i = 1; i < line.size(); ++i) {
      const PagePoint to = line[i].unaryExpr(&rounded);
      const std::string right = step_text(to.x() - from.x()), down = step_text(to.y() - from.y());
      path += (i > 1 && right[0] != '-' ? " " : "") + right + (down[0] != '-' ? " " : "") + down;
      from = to;
    }
    if (closed || (line.size() > 2 && line.front() == line.back())) path += 'Z';
  }
  return path;
}

std::string ended(const std::string& element, const std::string& name, const std::string& title) {
  return title.empty() ? element + "/>\n"
                       : element + "><title>" + svg::escaped(title) + "</title></" + name + ">\n";
}

std::string text_of(const PageArea& area) {
  return ended("<path fill=\"" + color_text(area.color) + "\" d=\"" + path_of(area.loops, true) + "\"",
               "path", area.title);
}

std::string text_of(const PageCurves& curves) {
  return ended("<path fill=\"none\" stroke=\"" + color_text(curves.color) + "\" stroke-width=\"" +
                   brief(curves.width) + "\" stroke-linejoin=\"round\" stroke-linecap=\"round\"" +
                   (curves.dashed ? " stroke-dasharray=\"4 3\"" : "") + " d=\"" +
                   path_of(curves.lines, false) + "\"",
               "path", curves.title);
}

const char* name_of(TextAnchor anchor) {
  switch (anchor) {
    case TextAnchor::start:
      return "start";
    case TextAnchor::middle:
      return "middle";
    case TextAnchor::end:
      break;
  }
  return "end";
}

std::string text_of(const PageText& text) {
  return "<text x=\"" + brief(text.at.x()) + "\" y=\"" + brief(text.at.y()) + "\" font-size=\"" +
         brief(text.size) + "\" text-anchor=\"" + name_of(text.anchor) + "\" fill=\"" +
         color_text(text.color) + "\"" + (text.bold ? " font-weight=\"bold\"" : "") +
         (text.halo ? " stroke=\"" + color_text(*text.halo) + "\" stroke-width=\"3\" paint-order=\"stroke\""
                    : "") +
         ">" + svg::escaped(text.text) + "</text>\n";
}

std::string base_64(const std::string& bytes) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[bits >> (18U - 6U * k) & 63U];
  }
  return text;
}

// SVG holds pictures of points as PNG.
std::string text_of(const PageImage& image) {
  const double height = static_cast<double>(image.points.size() / image.width);
  PagePicture alone{static_cast<double>(image.width), height, {image}};
  auto& copy = std::get<PageImage>(alone.elements.front());
  copy.corner.setZero();
  copy.size = PagePoint(alone.width, alone.height);
  return "<image x=\"" + brief(image.corner.x()) + "\" y=\"" + brief(image.corner.y()) + "\" width=\"" +
         brief(image.size.x()) + "\" height=\"" + brief(image.size.y()) + "\" href=\"data:image/png;base64," +
         base_64(as_png(alone, 1.0)) + "\"/>\n";
}

}  // namespace

std::string as_svg(const PagePicture& picture) {
  std::string text = svg::start(picture.width, picture.height);
  for (const PageElement& element : picture.elements)
    text += std::visit([](const auto& each) { return text_of(each); }, element);
  return text + "</svg>\n";
}

}  // namespace parallel_aspects
