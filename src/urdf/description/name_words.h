// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_NAME_WORDS_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_NAME_WORDS_H

#include "urdf/description/tree.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The words of a name, in small letters: "rod2LeftTip" and "rod_2-left_tip" are rod, 2, left, tip. The place
/// in "rod_2@0.4:0:0" is none.
std::vector<std::string> words_of(const std::string& name);

/// The name without what counts legs: "crank_#_joint".
std::string role_of(const std::string& name);

/// Whether the words of the name say that a drive is there, as "motor" or "crank" do.
bool says_drive(const std::string& name);

/// Whether they say that none is, as "passive" does.
bool says_passive(const std::string& name);

/// Whether they say that a loop is closed there, as "tip" or "closing" do.
bool says_end(const std::string& name);

/// Whether they say that no loop is closed there, as "camera" and "finger" do.
bool says_fitting(const std::string& name);

/// How much the name looks like that of an operational point: 0 for not at all.
int operational_point_likeness(const std::string& name);

/// Whether they say that it is the base.
bool says_base(const std::string& name);

/// Words that distinguish the ends: an index weighs more than any other word, and so does a word that counts
/// links of one form, as that of platform_alpha and platform_bravo, on both sides. What all have does not
/// tell, nor does an index that all names of one form have, as the 3 of ball_1_3 and ball_2_3.
class EndLikeness {
 public:
  EndLikeness(const Tree& tree, const std::vector<std::size_t>& tips,
              const std::vector<std::size_t>& anchors);

  /// How much the names of these two of the links have in common.
  int between(std::size_t one, std::size_t other) const;

 private:
  std::map<std::size_t, std::set<std::string>> words_, counters_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_NAME_WORDS_H
