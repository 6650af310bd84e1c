// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/note.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {

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
