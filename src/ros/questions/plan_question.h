// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_QUESTIONS_PLAN_QUESTION_H
#define PARALLEL_ASPECTS_ROS_QUESTIONS_PLAN_QUESTION_H

#include "parallel_aspects/ask/plan.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/motion/plan_path.h"
#include "ros/monitor/known_domains.h"

#include <parallel_aspects/PlanPathGoal.h>
#include <parallel_aspects/PlanPathResult.h>
#include <parallel_aspects/Status.h>

#include <cstddef>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Whether a path lies in one uniqueness domain.
struct PathDomains {
  SameAspect in_one = SameAspect::unknown;  ///< yes and no are proved
  std::vector<std::size_t> domains;  ///< indices of those that hold what was found at 32 poses a segment
  std::string message;               ///< why, unless yes: the rest of a sentence
};

/// Of no path nothing is known. `in_slice`: where it does not run from pose to pose as `pose_between` does.
PathDomains domains_along(const PlannedPath& path, const PoseBetween& between, const KnownDomains& known,
                          bool in_slice);

void write_domains(const PathDomains& domains, PlanPathResult& result);

/// Reads what a goal says besides its ends. The start is in the question already, in its working mode, since
/// `held_joint` is held at its value there.
Status read_wish(const Manipulator& manipulator, const PlanPathGoal& goal, ask::PlanQuestion& question);

/// Why a question is refused, with the fields of messages.
Status refused(const ask::ProblemList& problems);

/// Writes the whole answer but its status into a result: the path, its times and what to know of it.
void write_answer(const Manipulator& manipulator, const ask::PlanAnswer& answer, PlanPathResult& result);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_QUESTIONS_PLAN_QUESTION_H
