// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_PATH_ENDS_H
#define PARALLEL_ASPECTS_ASK_PATH_ENDS_H

#include "parallel_aspects/ask/plan.h"

#include <string>

namespace parallel_aspects::ask {

/// An end, understood: that of an aspect is of no meaning before there is a map. Where actuated joints
/// assemble in several poses, and none is given beside them, the problem lists these.
PathEnd path_end(const std::string& field, const Manipulator& robot, const EndQuestion& question,
                 ProblemList& problems);

/// Puts an end into the aspect that was asked for, if one was.
void place_in_aspect(const std::string& field, const AspectMap& map, const EndQuestion& question,
                     PathEnd& end, ProblemList& problems);

}  // namespace parallel_aspects::ask

#endif  // PARALLEL_ASPECTS_ASK_PATH_ENDS_H
