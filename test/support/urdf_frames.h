// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_URDF_FRAMES_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_URDF_FRAMES_H

#include <Eigen/Geometry>
#include <urdf_parser/urdf_parser.h>

#include <map>
#include <string>

namespace parallel_aspects::test {

inline Eigen::Isometry3d isometry(const urdf::Pose& pose) {
  const Eigen::Quaterniond rotation(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
  return Eigen::Translation3d(pose.position.x, pose.position.y, pose.position.z) * rotation;
}

/// Frame of a link in the frame of the root, walking up the model of urdfdom: a second way beside the
/// loader's.
inline Eigen::Isometry3d link_frame(const urdf::ModelInterface& model, const std::string& link,
                                    const std::map<std::string, double>& joints) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  for (auto at = model.getLink(link); at->parent_joint; at = at->getParent()) {
    const urdf::Joint& joint = *at->parent_joint;
    const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
    Eigen::Isometry3d moved = isometry(joint.parent_to_joint_origin_transform);
    if (joint.type == urdf::Joint::PRISMATIC)
      moved.translate(joints.at(joint.name) * axis);
    else if (joint.type != urdf::Joint::FIXED)
      moved.rotate(Eigen::AngleAxisd(joints.at(joint.name), axis));
    frame = moved * frame;
  }
  return frame;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_URDF_FRAMES_H
