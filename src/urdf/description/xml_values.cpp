// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/xml_values.h"

#include "model/linear_algebra.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace parallel_aspects {

std::string attribute(const tinyxml2::XMLElement* element, const char* name) {
  const char* value = element != nullptr ? element->Attribute(name) : nullptr;
  return value != nullptr ? value : "";
}

std::string child_text(const tinyxml2::XMLElement& element, const char* child) {
  const auto* found = element.FirstChildElement(child);
  const char* raw = found != nullptr ? found->GetText() : nullptr;
  const std::string text = raw != nullptr ? raw : "";
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::optional<std::vector<double>> numbers(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  std::vector<double> values;
  for (double value = 0.0; stream >> value;) values.push_back(value);
  const bool finite = std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  if (!stream.eof() || !finite) return std::nullopt;
  return values;
}

std::optional<Eigen::Vector3d> vector_or(const std::string& text, const Eigen::Vector3d& absent) {
  if (text.empty()) return absent;
  const auto values = numbers(text);
  if (!values || values->size() != 3) return std::nullopt;
  return Eigen::Vector3d((*values)[0], (*values)[1], (*values)[2]);
}

std::optional<Eigen::Isometry3d> frame_of(const std::string& xyz, const std::string& rpy) {
  const auto position = vector_or(xyz, Eigen::Vector3d::Zero());
  const auto angles = vector_or(rpy, Eigen::Vector3d::Zero());
  if (!position || !angles) return std::nullopt;
  return Eigen::Translation3d(*position) * Eigen::AngleAxisd(angles->z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(angles->y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angles->x(), Eigen::Vector3d::UnitX());
}

// Roll and yaw are found together, so that the frame is kept to rounding where the pitch is a right angle.
Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& r) {
  const double yaw = std::atan2(r(1, 0), r(0, 0)), pitch = std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)));
  const double s = std::sin(yaw), c = std::cos(yaw);
  return {std::atan2(s * r(0, 2) - c * r(1, 2), c * r(1, 1) - s * r(0, 1)), pitch, yaw};
}

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& roll_pitch_yaw) {
  return (Eigen::AngleAxisd(roll_pitch_yaw.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(roll_pitch_yaw.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll_pitch_yaw.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

Eigen::Matrix3d axes_with_z(const Eigen::Vector3d& axis) {
  return shortest_rotation(Eigen::Vector3d::UnitZ(), axis).toRotationMatrix();
}

}  // namespace parallel_aspects
