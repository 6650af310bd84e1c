// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/robot_models.h"

#include <rviz/display_context.h>
#include <rviz/display_group.h>

namespace parallel_aspects {

void reload_robot_models(rviz::DisplayContext& context) {
  rviz::DisplayGroup* const root = context.getRootDisplayGroup();
  for (int i = 0; i < root->numDisplays(); ++i) {
    rviz::Display* const display = root->getDisplayAt(i);
    if (display->getClassId() != "rviz/RobotModel" || !display->isEnabled()) continue;
    display->setEnabled(false);
    display->setEnabled(true);
  }
}

}  // namespace parallel_aspects
