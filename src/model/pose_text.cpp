// SPDX-License-Identifier: BSD-3-Clause
#include "model/pose_text.h"

#include "model/number_text.h"

#include <locale>
#include <sstream>

namespace parallel_aspects {

std::string pose_numbers(TaskSpace space, const Pose& pose, int digits) {
  const PoseCoordinates coordinates = pose_coordinates(space, pose);
  std::string text;
  for (Eigen::Index k = 0; k < coordinates.size(); ++k)
    text += (k == 0 ? "" : " ") + number_text(without_noise(coordinates[k]), digits);
  return text;
}

std::optional<Pose> as_typed(TaskSpace space, const Pose& pose, int digits) {
  std::istringstream text(pose_numbers(space, pose, digits));
  text.imbue(std::locale::classic());
  PoseCoordinates coordinates = pose_coordinates(space, pose);
  for (Eigen::Index k = 0; k < coordinates.size(); ++k)
    if (!(text >> coordinates[k])) return std::nullopt;
  return pose_from_coordinates(space, coordinates);
}

}  // namespace parallel_aspects
