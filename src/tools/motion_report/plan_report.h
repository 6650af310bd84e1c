// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_PLAN_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_PLAN_REPORT_H

#include "parallel_aspects/ask/choose.h"
#include "parallel_aspects/ask/map.h"
#include "parallel_aspects/ask/plan.h"
#include "parallel_aspects/motion/plan_path.h"
#include "tools/report/report.h"

#include <string>

namespace parallel_aspects::tools {

/// `aspects choose`: in which working modes a path or a region can be done, the best first.
Report report_choice(const Manipulator& robot, const ask::ChooseAnswer& answer);

/// `aspects graph`: gates, and the sets of aspects that they join.
Report report_graph(const Manipulator& robot, const ask::GraphAnswer& answer);

/// The graph in the language of Graphviz: a node for each aspect, a box for each set, an edge for each gate;
/// those that are not proved are dashed, and those through det A = 0 red.
std::string graph_as_dot(const ask::GraphAnswer& answer);

/// `aspects plan`: why there is a path, or none.
std::string reason_text(const Manipulator& robot, const ask::PlanAnswer& answer);

/// The path.
std::string plan_text(const Manipulator& robot, const ask::PlanAnswer& answer);

/// How often its actuated values go around each cusp; empty where that was not asked.
std::string turns_text(const ask::PlanAnswer& answer);

/// How far its ends were moved, and what is known of it in time.
std::string text_after(const Manipulator& robot, const ask::PlanAnswer& answer);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_PLAN_REPORT_H
