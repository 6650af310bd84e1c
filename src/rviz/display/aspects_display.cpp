// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/aspects_display.h"

#include <pluginlib/class_list_macros.hpp>

namespace parallel_aspects {

void AspectsDisplay::onInitialize() { setStatus(rviz::StatusProperty::Warn, "Map", "Waits for a node."); }

}  // namespace parallel_aspects

PLUGINLIB_EXPORT_CLASS(parallel_aspects::AspectsDisplay, rviz::Display)
