// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_QUESTION_PARTS_H
#define PARALLEL_ASPECTS_ASK_QUESTION_PARTS_H

#include "parallel_aspects/ask/plan.h"
#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <string>
#include <vector>

namespace parallel_aspects::ask {

/// "x=-1:1 y=-1:1", in quotes and with units.
std::string example_of_ranges(const std::vector<std::string>& names);

/// The box with these ranges, one for each of the names. Where there are problems it is of no meaning.
Box box_of(const std::string& field, const std::vector<std::string>& names,
           const std::vector<NamedRange>& ranges, ProblemList& problems);

/// Puts a pose, typed in a few digits, onto the slice, and returns by how much [m]. Where that is more than
/// the rounding of a table to six digits it is refused, and the problem gives the nearest pose.
double put_onto_slice(const MapSlice& slice, const Manipulator& robot, const std::string& field, Pose& pose,
                      ProblemList& problems);

/// An end, understood: that of an aspect is of no meaning before there is a map. Where actuated joints
/// assemble in several poses, and none is given beside them, the problem lists these.
PathEnd path_end(const std::string& field, const Manipulator& robot, const EndQuestion& question,
                 ProblemList& problems);

/// Puts an end into the aspect that was asked for, if one was.
void place_in_aspect(const std::string& field, const AspectMap& map, const EndQuestion& question,
                     PathEnd& end, ProblemList& problems);

}  // namespace parallel_aspects::ask

#endif  // PARALLEL_ASPECTS_ASK_QUESTION_PARTS_H
