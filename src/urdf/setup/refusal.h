// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_REFUSAL_H
#define PARALLEL_ASPECTS_URDF_SETUP_REFUSAL_H

#include "parallel_aspects/model/problems.h"
#include "urdf/setup/closed_search.h"

namespace parallel_aspects {

struct Refusal {
  Problems problems;
  bool is_explained = false;  ///< whether they say what makes a robot of it, or that nothing does
};

/// Why what was tried makes no robot, in the words of the options, with what would correct it where that is
/// found in time: of what was tried first, and else of what was tried for other platforms.
Refusal refusal_of(const SetupSubject& subject, const ClosedResult& found);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_REFUSAL_H
