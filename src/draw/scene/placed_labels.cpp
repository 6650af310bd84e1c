// SPDX-License-Identifier: BSD-3-Clause
#include "draw/scene/placed_labels.h"

#include <algorithm>
#include <limits>

namespace parallel_aspects {
namespace {

// From line to line, over the height: labels in space are seen from above, too, which brings them nearer.
constexpr double flat_pitch = 1.1, body_pitch = 1.6;

}  // namespace

void keep_apart(std::vector<PlacedLabel>& labels, double height, bool planar) {
  const Eigen::Index up = planar ? 1 : 2;
  const double line = (planar ? flat_pitch : body_pitch) * height;
  const auto overlap = [&](const PlacedLabel& one, const PlacedLabel& other) {
    const double width =
        std::max(1.0, half_letter * static_cast<double>(one.letters + other.letters)) * height;
    const double far = std::numeric_limits<double>::infinity();  // one over the other, as they are seen
    const Eigen::Vector3d room(width, planar ? line : width, planar ? far : line);
    return ((one.at - other.at).cwiseAbs().array() < room.array()).all();
  };
  for (auto label = labels.begin(); label != labels.end(); ++label)
    for (auto other = labels.begin(); other != label;) {
      if (overlap(*label, *other)) {
        label->at[up] = other->at[up] - 1.01 * line;
        other = labels.begin();  // it may lie on one of those before now
      } else {
        ++other;
      }
    }
}

namespace {

constexpr std::size_t letters = 26;

Eigen::Vector3d place_of(const Manipulator& robot, const Pose& pose, double radius, double height) {
  if (is_planar(robot.task_space())) return pose.position + height * Eigen::Vector3d::UnitY();
  const double scale = robot.task_space() == TaskSpace::SO3 ? radius : 1.0;
  const Eigen::Matrix3d axes = scale * drawing_axes(robot);
  Eigen::Vector3d nearest = axes * pose.transform(robot.leg(0).anchor);
  for (const Leg& leg : robot.legs()) {
    const Eigen::Vector3d anchor = axes * pose.transform(leg.anchor);
    if (anchor.y() < nearest.y()) nearest = anchor;
  }
  return nearest + height * Eigen::Vector3d(0.0, -1.0, 0.5);
}

}  // namespace

std::string candidate_name(std::size_t index) {
  const std::string last(1, static_cast<char>('A' + index % letters));
  return index < letters ? last : candidate_name(index / letters - 1) + last;
}

std::vector<Eigen::Vector3d> candidate_places(const Manipulator& robot, const std::vector<Pose>& poses,
                                              double radius) {
  const double height = candidate_name_height * drawn_size(robot, radius);
  std::vector<PlacedLabel> labels;
  for (const Pose& pose : poses)
    labels.push_back({place_of(robot, pose, radius, height), candidate_name(labels.size()).size()});
  keep_apart(labels, height, is_planar(robot.task_space()));
  std::vector<Eigen::Vector3d> places;
  for (const PlacedLabel& label : labels) places.push_back(label.at);
  return places;
}

}  // namespace parallel_aspects
