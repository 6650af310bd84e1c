// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ARMS_IDEAL_CHAIN_H
#define PARALLEL_ASPECTS_ARMS_IDEAL_CHAIN_H

#include "parallel_aspects/arms/serial_arm.h"

#include <string>
#include <vector>

namespace parallel_aspects {

/// Joints and links after Denavit and Hartenberg, exactly parallel, perpendicular and meeting where they are
/// but for tolerances.
struct IdealChain {
  std::vector<ArmJoint> joints;
  Eigen::Isometry3d base = Eigen::Isometry3d::Identity();  ///< first frame
  Eigen::Isometry3d last = Eigen::Isometry3d::Identity();  ///< last frame while all joints are zero
  std::int64_t tip_height = 0;                             ///< of the operational point above it [nm]
  std::vector<std::string> notes;                          ///< what was changed
};

/// The line that the z axis of the last frame lies on.
enum class LastAxis {
  of_last_joint,   ///< the axis of the last joint
  parallel_to_it,  ///< the parallel to it through the operational point
  of_tip,          ///< the z axis of the frame of the operational point
};

/// `tolerance_m` of lengths, `tolerance_rad` of angles.
IdealChain ideal_chain(const ArmDescription& description, LastAxis last, double tolerance_m,
                       double tolerance_rad);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ARMS_IDEAL_CHAIN_H
