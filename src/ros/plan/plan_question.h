// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PLAN_PLAN_QUESTION_H
#define PARALLEL_ASPECTS_ROS_PLAN_PLAN_QUESTION_H

#include "parallel_aspects/ask/plan.h"

#include <parallel_aspects/PlanPathGoal.h>
#include <parallel_aspects/PlanPathResult.h>
#include <parallel_aspects/Status.h>

#include <string>

namespace parallel_aspects {

/// Reads what a goal says besides its ends. The start is in the question already, in its working mode, since
/// `held_joint` is held at its value there.
Status read_wish(const Manipulator& manipulator, const PlanPathGoal& goal, ask::PlanQuestion& question);

/// Why a question is refused, with the fields of messages.
Status refused(const ask::ProblemList& problems);

/// Writes what was planned into a result, its status aside.
void write_answer(const Manipulator& manipulator, const ask::PlanAnswer& answer, PlanPathResult& result);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PLAN_PLAN_QUESTION_H
