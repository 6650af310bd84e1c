// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_TOUR_H
#define PARALLEL_ASPECTS_MOTION_TOUR_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/vectors.h"

#include <vector>

namespace parallel_aspects {

/// A round trip through aspects that passes from one to the next through serial singularities, and never
/// meets det A = 0: every piece is certified by continuation.
struct Tour {
  std::vector<JointVector> joint_values;  ///< corners, the first again at the end; actuated joints move
                                          ///< straight between [rad or m]
  std::vector<int> aspects;               ///< ids in the order of the visit, the first again at the end
};

/// Plans a tour from a pose in a working mode through every aspect that it finds a way to. Empty where the
/// map cannot locate the start, and where there are constraints besides limits of actuated joints: straight
/// motions of actuated joints are not proved to keep those. Takes up to some seconds.
Tour plan_tour(const AspectMap& map, const Pose& start, const WorkingMode& mode);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_TOUR_H
