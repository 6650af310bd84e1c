// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_END_LIKENESS_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_END_LIKENESS_H

#include "urdf/description/tree.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Words that tell the ends apart: an index weighs more than any other word, and so does a word that counts
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

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_END_LIKENESS_H
