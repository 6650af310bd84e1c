// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_RECOGNITION_PASSIVE_LIMITS_H
#define PARALLEL_ASPECTS_URDF_RECOGNITION_PASSIVE_LIMITS_H

#include "parallel_aspects/model/constraints.h"
#include "urdf/closing/chain.h"
#include "urdf/recognition/leg_recognition.h"
#include "urdf/recognition/platform_motion.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace parallel_aspects {

/// Limits of the joints of the loops that are not actuated.
struct FoundPassiveLimits {
  std::vector<PassiveLimit> limits;  ///< of those whose angle is between two links of a planar leg
  std::vector<PassiveCone> cones;    ///< of universal joints at the ends of a leg in space
  std::vector<std::string> missing;  ///< names of the others
};

/// `legs` are recognised in `system` at these joint values [rad or m]. A revolute joint with a range of a
/// full turn has no limits. What is `bounded` otherwise, by index of the joint value, is left out.
FoundPassiveLimits find_passive_limits(const ClosureSystem& system, const Eigen::VectorXd& values,
                                       const PlatformMotion& motion, const std::vector<RecognisedLeg>& legs,
                                       const std::vector<std::size_t>& bounded);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_RECOGNITION_PASSIVE_LIMITS_H
