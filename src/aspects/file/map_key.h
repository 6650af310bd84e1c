// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_FILE_MAP_KEY_H
#define PARALLEL_ASPECTS_ASPECTS_FILE_MAP_KEY_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A name that stays in its line: control characters become "?".
std::string printable(std::string text);

/// The part of a `map_key` with the constraints: every number of them with all its digits, a line each;
/// empty where there are none.
std::string constraint_key(const Constraints& constraints);

/// What a map was computed for, as text: the task space and every number of the legs, then the region and the
/// levels of the tree, which is all that the options come to. A line each, numbers with all their digits; two
/// maps are of the same robot and options exactly if their keys are equal.
std::string map_key(const Manipulator& manipulator, const Box& region, double resolution, std::uint32_t depth,
                    std::uint32_t deepest_level);

/// Which configurations of the robot a map covers, in the same manner: its slice and its working modes.
std::string coverage_key(const std::optional<MapSlice>& slice, const std::vector<WorkingMode>& modes);

/// The first line of `other` that `text` does not have; empty where it has them all.
std::string line_missing_in(const std::string& text, const std::string& other);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_FILE_MAP_KEY_H
