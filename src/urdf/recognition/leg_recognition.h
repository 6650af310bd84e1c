// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_RECOGNITION_LEG_RECOGNITION_H
#define PARALLEL_ASPECTS_URDF_RECOGNITION_LEG_RECOGNITION_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"
#include "urdf/closing/chain.h"
#include "urdf/recognition/platform_motion.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A chain as two groups of pivots, each about one point, and an actuated joint before or between them. All
/// in the base frame at the assembled configuration.
struct SplitChain {
  Chain proximal;  ///< pivots about c
  Chain distal;    ///< pivots about p; empty where the rod carries the operational point itself
  Pivot actuation;
  bool actuated_first =
      true;  ///< the actuated joint moves c; otherwise it is between the groups and changes |p - c|
  /// Whether all its axes were accepted as meeting in the center of a spherical motion: c and p are then
  /// drawn on the sphere of radius 1 m about it, where lengths stand for angles.
  bool on_unit_sphere = false;
  Eigen::Vector3d c = Eigen::Vector3d::Zero();                ///< proximal point [m]
  Eigen::Vector3d p = Eigen::Vector3d::Zero();                ///< anchor [m]
  Eigen::Vector3d proximal_center = Eigen::Vector3d::Zero();  ///< on all axes of `proximal` [m]
  Eigen::Vector3d distal_center = Eigen::Vector3d::Zero();    ///< on all axes of `distal` [m]
};

/// A leg and the chains that it stands for.
struct RecognisedLeg {
  Leg leg;  ///< in the task frame
  std::vector<SplitChain> chains;
};

/// What a leg is recognised in.
struct LegSetting {
  const PlatformMotion* motion = nullptr;
  double size = 1.0;         ///< of the robot [m]
  double joint_value = 0.0;  ///< at the assembled configuration [rad or m]
  JointLimits limits;        ///< of the actuated joint
  std::string name;          ///< of the leg
  bool planar = false;       ///< whether the leg stays in the x-y plane; `recognise_leg` finds it
};

/// The leg as one distance equation. Nothing, and the reason as "keeps no point ...", where it is not a
/// distance leg.
std::optional<RecognisedLeg> recognise_leg(const LegChains& leg, std::size_t actuated_variable,
                                           const LegSetting& setting, std::string& reason);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_RECOGNITION_LEG_RECOGNITION_H
