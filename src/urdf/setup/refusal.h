// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_REFUSAL_H
#define PARALLEL_ASPECTS_URDF_SETUP_REFUSAL_H

#include "parallel_aspects/model/problems.h"
#include "urdf/setup/closed_search.h"

namespace parallel_aspects {

/// Why what was tried makes no robot, in the words of the options, with what would correct it where that is
/// found in time: of what was tried first, and else of what was tried for other platforms.
Problems refusal_of(const SetupSubject& subject, const ClosedResult& found);

/// Whether any of them names a correction that was tried and makes a robot.
bool any_remedy(const Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_REFUSAL_H
