// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_MESSAGES_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_MESSAGES_H

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// A word of a command line, in quotation marks where a shell needs them.
std::string shell_word(const std::string& word);

/// The option of `aspects setup` that stands for a key of the YAML, as "--actuated" for "actuated_joints";
/// the key where the YAML alone can say it.
std::string option_name(const std::string& key);

/// The option with its values, as "--actuated 'a b'".
std::string option_for(const std::string& key, const std::vector<std::string>& values);

/// A coordinate or an angle, "0.4": what is but rounding is zero.
std::string coordinate_text(double value);

/// A place in the frame of a link [m], as "rod_2@0.4:0:0".
std::string placed_name(const std::string& link, const Eigen::Vector3d& xyz,
                        const Eigen::Vector3d& rpy = Eigen::Vector3d::Zero());

/// Names of one kind by the reason that a message gives for them, in the order in which they came.
using NamesByReason = std::vector<std::pair<std::string, std::vector<std::string>>>;
void add_name(const std::string& reason, const std::string& name, NamesByReason& names);

/// Names of files or parameters, for messages, and how these call what the YAML says.
struct SourceNames {
  std::string urdf;
  std::string config;
  bool as_options = false;  ///< no YAML was written: its values are those of options of a command

  /// "actuated_joints", or "--actuated".
  std::string key(const std::string& key) const;

  /// "mechanism.actuated_joints", or "--actuated".
  std::string full_key(const std::string& key) const;

  /// "base_link: a", or "--base a".
  std::string entry(const std::string& key, const std::string& value) const;

  /// "actuated_joints: [a, b]", or "--actuated 'a b'".
  std::string entry(const std::string& key, const std::vector<std::string>& values) const;
};

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

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_MESSAGES_H
