// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_MECHANISM_CONTENTS_H
#define PARALLEL_ASPECTS_URDF_MECHANISM_CONTENTS_H

#include "aspects/symmetry/near_symmetry.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "urdf/description/messages.h"
#include "urdf/recognition/completion.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

struct Mechanism::Contents {
  std::shared_ptr<const Manipulator> manipulator;
  std::shared_ptr<const Manipulator> mapped_manipulator;
  std::string platform_link;
  std::string platform_frame;
  std::vector<std::string> joint_names;
  std::vector<JointLimits> joint_limits;
  Notes notes;
  int mobility = 0;
  int idle_degrees_of_freedom = 0;
  double accepted_residual = 0.0;  ///< what rounding in the description costs, over the size of the robot
  Completion completion;
  bool point_platform = false;                   ///< see `PlatformMotion`
  SymmetricLegs symmetric{};                     ///< by `mechanism.symmetrize` or in decimals: the motions
  std::optional<AssembledConfiguration> home{};  ///< see `Mechanism::home`
  JointVector acceleration{};                    ///< see `Mechanism::acceleration`

  std::optional<std::size_t> joint_outside_limits(
      const Eigen::Ref<const Eigen::VectorXd>& positions) const noexcept;
  bool complete(const Pose& pose, const JointVector& q, Eigen::Ref<Eigen::VectorXd> positions) const noexcept;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_MECHANISM_CONTENTS_H
