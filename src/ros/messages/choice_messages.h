// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MESSAGES_CHOICE_MESSAGES_H
#define PARALLEL_ASPECTS_ROS_MESSAGES_CHOICE_MESSAGES_H

#include "parallel_aspects/ask/choose.h"
#include "parallel_aspects/ask/connect.h"

#include <parallel_aspects/ChooseWorkingMode.h>
#include <parallel_aspects/ModeConnection.h>
#include <parallel_aspects/Status.h>

namespace parallel_aspects {

/// Reads the region that a request is about: a coordinate whose ends are equal is held.
Status read_region(const Manipulator& manipulator, const ChooseWorkingMode::Request& request,
                   ask::ChooseQuestion& question);

/// Writes an answer into a response.
void write_choice(const Manipulator& manipulator, const ask::ChooseAnswer& answer,
                  ChooseWorkingMode::Response& response);

ModeConnection connection_message(const Manipulator& manipulator, const ask::ConnectionInMode& connection);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MESSAGES_CHOICE_MESSAGES_H
