// SPDX-License-Identifier: BSD-3-Clause
#include "model/pose_text.h"

#include "model/number_text.h"

namespace parallel_aspects {

std::string pose_numbers(TaskSpace space, const Pose& pose, int digits) {
  const PoseCoordinates coordinates = pose_coordinates(space, pose);
  std::string text;
  for (Eigen::Index k = 0; k < coordinates.size(); ++k)
    text += (k == 0 ? "" : " ") + number_text(without_noise(coordinates[k]), digits);
  return text;
}

}  // namespace parallel_aspects
