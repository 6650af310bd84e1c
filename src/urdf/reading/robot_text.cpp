// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/reading/robot_text.h"

#include <boost/locale/encoding_utf.hpp>

#include <array>
#include <cstddef>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_shown = 20;  // characters of a text that is something else

struct Format {
  std::string start, remedy;
};

const std::array<Format, 5>& formats() {
  static const std::array<Format, 5> all{
      {{"version https://git-lfs", "is a pointer of Git LFS, not the file; fetch that with 'git lfs pull'."},
       {"\xff\xfe", "is in UTF-16; save it as UTF-8."},
       {"\xfe\xff", "is in UTF-16; save it as UTF-8."},
       {"\x1f\x8b", "is compressed; unpack it with gunzip."},
       {"PK\x03\x04", "is a ZIP archive; unpack it and give the URDF in it."}}};
  return all;
}

bool starts_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

bool is_printable(const std::string& text) {
  for (const char letter : text)
    if (letter < ' ' || letter > '~') return false;
  return true;
}

// What a text is that does not begin as XML does.
std::optional<std::string> other_format(const std::string& text) {
  for (const Format& format : formats())
    if (starts_with(text, format.start)) return format.remedy;
  if (text.find('\0') != std::string::npos)
    return "has a byte that is 0, so that it is no text; give a URDF.";
  const std::size_t start = text.find_first_not_of(" \t\r\n", starts_with(text, "\xef\xbb\xbf") ? 3 : 0);
  if (start == std::string::npos) return "is empty or missing; give a URDF.";
  if (text[start] == '<') return std::nullopt;
  const std::string shown =
      text.substr(start, text.find_first_of("\r\n", start) - start).substr(0, max_shown);
  return "is not XML, as it does not begin with '<'" +
         (is_printable(shown) ? ", but with '" + shown + "'" : std::string()) + "; give a URDF.";
}

}  // namespace

std::optional<std::string> parse_robot(const std::string& text, tinyxml2::XMLDocument& document) {
  if (auto other = other_format(text)) return other;
  if (document.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS) {
    if (document.FirstChildElement("robot") != nullptr) return std::nullopt;
    const tinyxml2::XMLElement* root = document.RootElement();
    return "has no <robot> element" + (root != nullptr ? ", but <" + std::string(root->Name()) + ">" : "") +
           "; give a URDF.";
  }
  if (text.find("<robot") != std::string::npos && text.find("</robot") == std::string::npos)
    return "ends before its <robot> does; give the whole file.";
  return "is not well-formed XML near line " + std::to_string(document.ErrorLineNum()) + " (" +
         tinyxml2::XMLDocument::ErrorIDToName(document.ErrorID()) + "); correct it there.";
}

std::optional<std::string> from_latin_1(const std::string& text) {
  if (other_format(text)) return std::nullopt;
  namespace conv = boost::locale::conv;
  try {
    conv::utf_to_utf<char32_t>(text, conv::stop);
    return std::nullopt;
  } catch (const conv::conversion_error&) {
  }
  std::u32string points;
  for (const char letter : text) points.push_back(static_cast<unsigned char>(letter));
  return conv::utf_to_utf<char>(points);
}

}  // namespace parallel_aspects
