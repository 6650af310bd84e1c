// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MESSAGES_CHOICE_MESSAGES_H
#define PARALLEL_ASPECTS_ROS_MESSAGES_CHOICE_MESSAGES_H

#include "parallel_aspects/ask/connect.h"
#include "parallel_aspects/motion/choose_working_mode.h"

#include <parallel_aspects/ChooseWorkingMode.h>
#include <parallel_aspects/ModeConnection.h>

namespace parallel_aspects {

/// The question that a request about a region asks: a coordinate whose ends are equal is held. What is wrong
/// with it is added to `problems`.
RegionQuestion region_of(const Manipulator& manipulator, const ChooseWorkingMode::Request& request,
                         Problems& problems);

/// Writes the answers into a response.
void write_choice(const PathChoice& choice, ChooseWorkingMode::Response& response);
void write_choice(const Manipulator& manipulator, const RegionChoice& choice,
                  ChooseWorkingMode::Response& response);
void write_changes(const Manipulator& manipulator, const ChangingPath& path,
                   ChooseWorkingMode::Response& response);

ModeConnection connection_message(const Manipulator& manipulator, const ask::ConnectionInMode& connection);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MESSAGES_CHOICE_MESSAGES_H
