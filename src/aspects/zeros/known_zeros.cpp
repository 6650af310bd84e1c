// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/zeros/known_zeros.h"

#include "aspects/zeros/krawczyk.h"

#include <algorithm>

namespace parallel_aspects {

bool KnownZeros::cover(const Box& box) const noexcept {
  return std::any_of(zeros_.begin(), zeros_.end(),
                     [&](const KnownZero& each) { return contains_up_to_turns(each.unique, box); });
}

bool KnownZeros::note(const KnownZero& found) {
  for (const KnownZero& each : zeros_) {
    if (contains_up_to_turns(each.unique, found.enclosure)) return true;
    if (contains_up_to_turns(found.unique, each.enclosure)) return true;
    if (meet_up_to_turns(found.enclosure, each.enclosure)) return false;
  }
  zeros_.push_back(found);
  return true;
}

}  // namespace parallel_aspects
