// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MESSAGES_NOT_A_NUMBER_H
#define PARALLEL_ASPECTS_ROS_MESSAGES_NOT_A_NUMBER_H

#include <limits>

namespace parallel_aspects {

/// What messages hold where a value is unknown.
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MESSAGES_NOT_A_NUMBER_H
