// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/messages.h"

#include "model/message_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int digits = 12;
constexpr double noise = 1e-12;

}  // namespace

std::string shell_word(const std::string& word) {
  const auto is_plain = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
           std::string("_-./=+:,@%").find(letter) != std::string::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

std::string option_name(const std::string& key) {
  static const std::array<std::pair<std::string, std::string>, 4> options{
      {{"base_link", "--base"},
       {"operational_point", "--platform"},
       {"actuated_joints", "--actuated"},
       {"closures", "--closures"}}};
  for (const auto& [known, option] : options)
    if (known == key) return option;
  return key;
}

std::string option_for(const std::string& key, const std::vector<std::string>& values) {
  const std::string option = option_name(key);
  if (option == key) return key;
  std::string joined;
  for (const std::string& value : values) joined += (joined.empty() ? "" : " ") + value;
  return option + " " + shell_word(joined);
}

std::string coordinate_text(double value) {
  return number_text(std::abs(value) < noise ? 0.0 : value, digits);
}

std::string placed_name(const std::string& link, const Eigen::Vector3d& xyz, const Eigen::Vector3d& rpy) {
  std::string text = link;
  for (const Eigen::Index k : {0, 1, 2}) text += (k == 0 ? "@" : ":") + coordinate_text(xyz[k]);
  for (const Eigen::Index k : {0, 1, 2})
    if (!rpy.isZero(0.0)) text += ":" + coordinate_text(rpy[k]);
  return text;
}

void add_name(const std::string& reason, const std::string& name, NamesByReason& names) {
  const auto known =
      std::find_if(names.begin(), names.end(), [&](const auto& other) { return other.first == reason; });
  auto& same = known == names.end() ? names.emplace_back(reason, std::vector<std::string>()) : *known;
  same.second.push_back(name);
}

std::string SourceNames::key(const std::string& key) const { return as_options ? option_name(key) : key; }

std::string SourceNames::full_key(const std::string& key) const {
  return as_options ? option_name(key) : "mechanism." + key;
}

std::string SourceNames::entry(const std::string& key, const std::string& value) const {
  return as_options ? option_for(key, {value}) : key + ": " + value;
}

std::string SourceNames::entry(const std::string& key, const std::vector<std::string>& values) const {
  if (as_options) return option_for(key, values);
  std::string list;
  for (const std::string& value : values) list += (list.empty() ? "" : ", ") + value;
  return key + ": [" + list + "]";
}

Note::Note(std::string words) : pieces_{{Piece::Kind::words, {std::move(words)}}} {}
Note::Note(const char* words) : Note(std::string(words)) {}
Note::Note(Piece::Kind kind, std::vector<std::string> items) : pieces_{{kind, std::move(items)}} {}

Note& Note::operator+=(const Note& other) {
  pieces_.insert(pieces_.end(), other.pieces_.begin(), other.pieces_.end());
  return *this;
}

std::string Note::text() const {
  std::string text;
  for (const Piece& piece : pieces_) text += piece.text();
  return text;
}

bool Note::has(Piece::Kind kind) const noexcept {
  return std::any_of(pieces_.begin(), pieces_.end(),
                     [kind](const Piece& piece) { return piece.kind == kind; });
}

std::string Note::Piece::text() const {
  std::string text;
  for (const std::string& item : items)
    text += (text.empty() ? "" : ", ") + (kind == Kind::names ? "'" + item + "'" : item);
  return kind == Kind::closures ? "closures: [" + text + "]" : text;
}

std::vector<std::string> texts_of(const Notes& notes) {
  std::vector<std::string> texts;
  for (const Note& note : notes) texts.push_back(note.text());
  return texts;
}

Note listed_names(std::vector<std::string> names) { return {Note::Piece::Kind::names, std::move(names)}; }

}  // namespace parallel_aspects
