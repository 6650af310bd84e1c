// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_CUSP_PATH_H
#define PARALLEL_ASPECTS_ASK_CUSP_PATH_H

#include "parallel_aspects/ask/plan.h"

namespace parallel_aspects::ask {

/// What keeps a question from being one of a change of the assembly mode around a cusp: such a path is in one
/// aspect of a slice that holds an actuated joint, and ends at the actuated values of its start.
void check_cusp(const Manipulator& robot, const PlanQuestion& question, const std::optional<MapSlice>& slice,
                ProblemList& problems);

/// Plans it; there is no problem of the kind above.
void plan_around(Session& session, const PlanQuestion& question, PathEnd from, const Control& control,
                 PlanAnswer& answer, ProblemList& problems);

}  // namespace parallel_aspects::ask

#endif  // PARALLEL_ASPECTS_ASK_CUSP_PATH_H
