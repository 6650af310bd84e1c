// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_RECOGNITION_PASSIVE_LIMITS_H
#define PARALLEL_ASPECTS_URDF_RECOGNITION_PASSIVE_LIMITS_H

#include "parallel_aspects/model/manipulator.h"
#include "urdf/closing/chain.h"
#include "urdf/recognition/leg_recognition.h"
#include "urdf/recognition/platform_motion.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// One of the two revolute joints of a universal joint, at the assembled configuration.
struct UniversalAxis {
  std::string joint;     ///< its name
  Eigen::Vector3d axis;  ///< unit vector that the rod turns about as the joint value grows
  double value = 0.0;    ///< [rad]
  JointLimits limits;    ///< none where it turns freely [rad]
};

/// A unit vector of which the rod's direction is no farther away than `angle` [rad].
struct LimitedDirection {
  std::string joint;  ///< whose limit that is
  Eigen::Vector3d axis;
  double angle = 0.0;
};

/// The limits of a universal joint as cones about its centre: the directions of a rod for which both joints
/// are within their limits are those in all the cones, exactly. The first joint is fixed in what the rod is
/// seen from, the second in the cross. Nothing where the direction of the rod does not determine that: the
/// axes or the second axis and the rod are not perpendicular, the second joint can turn so far that the rod
/// is along the first axis, or the first by more than half a turn.
std::optional<std::vector<LimitedDirection>> limited_directions(const UniversalAxis& first,
                                                                const UniversalAxis& second,
                                                                const Eigen::Vector3d& rod);

/// Limits of the joints of the loops that are not actuated.
struct FoundPassiveLimits {
  std::vector<PassiveLimit> limits;  ///< of those whose angle is between two links of a planar leg
  std::vector<PassiveCone> cones;    ///< of universal joints at the ends of a leg in space
  std::vector<HingeLimit> hinges;    ///< of the chain that holds the platform, in R1 and R2
  std::vector<std::string> missing;  ///< names of the others
};

/// `legs` are recognised in `system` at these joint values [rad or m]. A revolute joint with a range of a
/// full turn has no limits. What is `bounded` otherwise, by index of the joint value, is left out.
FoundPassiveLimits find_passive_limits(const ClosureSystem& system, const Eigen::VectorXd& values,
                                       const PlatformMotion& motion, const std::vector<RecognisedLeg>& legs,
                                       const std::vector<std::size_t>& bounded);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_RECOGNITION_PASSIVE_LIMITS_H
