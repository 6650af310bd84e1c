// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/pose_reading.h"

#include "ros/messages/conversions.h"

#include <utility>

namespace parallel_aspects {

Status read_pose(const Manipulator& manipulator, const PoseTransformer& to_base,
                 const geometry_msgs::PoseStamped& message, const std::string& which, Pose& pose) {
  std::string failure;
  const auto in_base = to_base(message, failure);
  if (!in_base) return make_status(Status::NO_TRANSFORM, std::move(failure));
  const auto found = pose_from_base(manipulator, *in_base);
  if (!found)
    return invalid_request(which +
                           " must be finite, and its quaternion of unit length "
                           "where the platform turns.");
  pose = *found;
  const double off = distance_off_task_space(manipulator, *in_base);
  if (!(off > 1e-6 * manipulator.size())) return {};
  return make_status(Status::OK,
                     which + " is " + std::to_string(off) +
                         " m off the motions of the platform; the answer is about its projection.");
}

Status read_waypoints(const Manipulator& manipulator, const PoseTransformer& to_base,
                      const std::vector<geometry_msgs::PoseStamped>& poses, const std::vector<double>& times,
                      std::vector<PoseWaypoint>& waypoints) {
  Status status;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Pose pose;
    const Status read = read_pose(manipulator, to_base, poses[i], "Pose " + std::to_string(i + 1), pose);
    if (read.code != Status::OK) return read;
    if (status.message.empty()) status = read;
    waypoints.push_back({times[i], pose});
  }
  return status;
}

}  // namespace parallel_aspects
