// SPDX-License-Identifier: BSD-3-Clause
#include "model/message_text.h"

#include <ios>
#include <locale>
#include <sstream>

namespace parallel_aspects {
namespace {

std::string text_of(double value, int precision, std::ios::fmtflags notation) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.setf(notation, std::ios::floatfield);
  text.precision(precision);
  text << value;
  return text.str();
}

}  // namespace

std::string number_text(double value, int digits) { return text_of(value, digits, {}); }

std::string fixed_number_text(double value, int decimals) {
  return text_of(value, decimals, std::ios::fixed);
}

std::string pose_numbers(TaskSpace space, const Pose& pose, int digits) {
  const PoseCoordinates coordinates = pose_coordinates(space, pose);
  std::string text;
  for (Eigen::Index k = 0; k < coordinates.size(); ++k)
    text += (k == 0 ? "" : " ") + number_text(without_noise(coordinates[k]), digits);
  return text;
}

std::optional<Pose> as_typed(const Motions& motions, const Pose& pose, int digits) {
  std::istringstream text(pose_numbers(motions.space, pose, digits));
  text.imbue(std::locale::classic());
  PoseCoordinates coordinates = pose_coordinates(motions.space, pose);
  for (Eigen::Index k = 0; k < coordinates.size(); ++k)
    if (!(text >> coordinates[k])) return std::nullopt;
  return pose_from_coordinates(motions, coordinates);
}

}  // namespace parallel_aspects
