// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_MECHANISM_CONTENTS_H
#define PARALLEL_ASPECTS_URDF_MECHANISM_CONTENTS_H

#include "aspects/symmetry/near_symmetry.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "urdf/description/note.h"
#include "urdf/recognition/completion.h"

#include <memory>
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
  bool point_platform = false;  ///< see `PlatformMotion`
  SymmetricLegs symmetric{};    ///< by `mechanism.symmetrize`: the motions; the legs are the manipulator's
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_MECHANISM_CONTENTS_H
