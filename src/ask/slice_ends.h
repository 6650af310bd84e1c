// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_SLICE_ENDS_H
#define PARALLEL_ASPECTS_ASK_SLICE_ENDS_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <string>

namespace parallel_aspects::ask {

/// Puts a pose, typed in a few digits, onto the slice, and returns by how much [m]. Where that is more than
/// the rounding of a table to six digits it is refused, and the problem gives the nearest pose.
double put_onto_slice(const MapSlice& slice, const Manipulator& robot, const std::string& field, Pose& pose,
                      ProblemList& problems);

}  // namespace parallel_aspects::ask

#endif  // PARALLEL_ASPECTS_ASK_SLICE_ENDS_H
