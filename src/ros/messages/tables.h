// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MESSAGES_TABLES_H
#define PARALLEL_ASPECTS_ROS_MESSAGES_TABLES_H

#include "parallel_aspects/aspects/aspect_map.h"

#include <string>

namespace parallel_aspects {

/// The aspects of a map as lines of text, for the console.
std::string aspect_table(const AspectMap& map);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MESSAGES_TABLES_H
