// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_ROBOT_MODELS_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_ROBOT_MODELS_H

namespace rviz {
class DisplayContext;
}

namespace parallel_aspects {

/// Loads the robot models of a window anew: by itself rviz reads each description once.
void reload_robot_models(rviz::DisplayContext& context);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_ROBOT_MODELS_H
