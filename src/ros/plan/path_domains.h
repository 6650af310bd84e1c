// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PLAN_PATH_DOMAINS_H
#define PARALLEL_ASPECTS_ROS_PLAN_PATH_DOMAINS_H

#include "parallel_aspects/aspects/same_aspect.h"
#include "parallel_aspects/motion/plan_path.h"
#include "parallel_aspects/motion/time_path.h"
#include "ros/monitor/domain_finder.h"

#include <parallel_aspects/PlanPathResult.h>

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PLAN_PATH_DOMAINS_H
