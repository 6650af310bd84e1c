// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_NOTE_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_NOTE_H

#include <string>
#include <vector>

namespace parallel_aspects {

/// A message on a robot that loads. It is kept in pieces, so that a list in it can be shown in another way
/// than `text()` has it.
class Note {
 public:
  struct Piece {
    enum class Kind {
      words,     ///< one item, as it is
      names,     ///< a list of them: 'a', 'b'
      closures,  ///< entries of that list of the YAML: closures: [{...}, {...}]
    };
    Kind kind = Kind::words;
    std::vector<std::string> items;

    std::string text() const;  ///< as `Note::text` has it
  };

  Note() = default;
  Note(std::string words);  // NOLINT(google-explicit-constructor): most messages are words alone
  Note(const char* words);  // NOLINT(google-explicit-constructor)
  Note(Piece::Kind kind, std::vector<std::string> items);

  Note& operator+=(const Note& other);
  friend Note operator+(Note one, const Note& other) { return one += other; }

  /// In one piece.
  std::string text() const;

  const std::vector<Piece>& pieces() const noexcept { return pieces_; }
  bool has(Piece::Kind kind) const noexcept;

  /// Whether it says which limits bound no aspect, although the description has them.
  bool is_on_limits_left_out = false;

 private:
  std::vector<Piece> pieces_;
};

using Notes = std::vector<Note>;

/// 'a', 'b'.
Note listed_names(std::vector<std::string> names);

std::vector<std::string> texts_of(const Notes& notes);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_NOTE_H
