// SPDX-License-Identifier: BSD-3-Clause
#include "ask/slice_ends.h"

#include "model/number_text.h"
#include "model/pose_text.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/aspects/held_joint.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects::ask {
namespace {

Pose nearest_of(const MapSlice& slice, const Manipulator& robot, const Pose& pose) {
  if (slice.joint) return circle_of_anchor(robot, *slice.joint).nearest(pose);
  Pose nearest = pose;
  for (std::size_t i = 0; i < slice.moves.size(); ++i)
    if (!slice.moves[i])
      nearest.position[static_cast<Eigen::Index>(i)] = slice.held.position[static_cast<Eigen::Index>(i)];
  if (slice.rotation == MapSlice::Rotation::none) nearest.orientation = slice.held.orientation;
  return nearest;
}

double distance_to(const MapSlice& slice, const Manipulator& robot, const Pose& pose) {
  if (slice.joint) return std::abs(circle_of_anchor(robot, *slice.joint).distance(pose));
  const Pose nearest = nearest_of(slice, robot, pose);
  return std::hypot((pose.position - nearest.position).norm(),
                    robot.characteristic_length() * pose.orientation.angularDistance(nearest.orientation));
}

/// How far a pose of the slice is from it at most once its numbers are rounded as tables have them, to six
/// digits: each then differs by half a unit of the last one.
double tolerance_at(const Manipulator& robot, const Pose& pose) {
  constexpr double rounding = 5.0001e-6;  // of a number at most, and as it is rounded itself
  constexpr double largest_share = 1e-4;  // of the robot's size, however far off its frame is
  const PoseCoordinates coordinates = pose_coordinates(robot.task_space(), pose);
  const Eigen::Index moves = traits(robot.task_space()).translations;
  const double lengths = coordinates.head(moves).lpNorm<1>(),
               turned = coordinates.tail(coordinates.size() - moves).lpNorm<1>();
  // A quaternion turns by twice as much as its numbers differ, and no anchor is much farther out than this.
  const double rounded = rounding * (lengths + 2.0 * robot.characteristic_length() * turned);
  return held_joint_tolerance + std::min(rounded, largest_share * robot.size());
}

}  // namespace

double put_onto_slice(const MapSlice& slice, const Manipulator& robot, const std::string& field, Pose& pose,
                      ProblemList& problems) {
  const Pose nearest = nearest_of(slice, robot, pose);
  const double distance = distance_to(slice, robot, pose), tolerance = tolerance_at(robot, pose);
  if (!(distance <= tolerance))
    problems.push_back(
        {ProblemKind::value, field,
         "{" + field + "} lies " + number_text(distance) + " m from the slice " + given(to_string(slice)),
         "give a pose within " + number_text(tolerance, 4) + " m of it. The nearest in the task frame is \"" +
             pose_numbers(robot.task_space(), nearest, pose_digits) + "\""});
  if (distance > 0.0) pose = nearest;
  return distance;
}

}  // namespace parallel_aspects::ask
