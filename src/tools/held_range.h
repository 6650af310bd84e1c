// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_HELD_RANGE_H
#define PARALLEL_ASPECTS_TOOLS_HELD_RANGE_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/model/problems.h"

#include <string>

namespace parallel_aspects::tools {

/// The range of an actuated joint that `text` names, such as "strut_1_joint=10:32", or the name alone: within
/// its limits. Messages name `option`.
HeldRange parse_held_range(const std::string& option, const Manipulator& robot, const std::string& text,
                           Problems& problems);

/// The actuated joint that `text` holds, such as "crank_1_joint=0.3".
HeldJoint parse_held_joint(const std::string& option, const Manipulator& robot, const std::string& text,
                           Problems& problems);

/// The slice of SE2 that holds the actuated joint which `text` names with its value; pose coordinates are
/// refused.
MapSlice parse_joint_slice(const std::string& option, const Manipulator& robot, const std::string& text,
                           Problems& problems);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_HELD_RANGE_H
