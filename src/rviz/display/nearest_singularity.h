// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_NEAREST_SINGULARITY_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_NEAREST_SINGULARITY_H

#include "draw/plane/map_pictures.h"
#include "model/spherical_links.h"
#include "parallel_aspects/distance/boundary_distances.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The nearest singularity of a configuration that was found, as a picture has it.
struct NearestSingularity {
  BoundaryKind kind = BoundaryKind::parallel;  ///< or serial
  double distance = 0.0;                       ///< in the metric of `BoundaryDistance` [m]
  Pose pose;                                   ///< there

  /// Two ends of each piece of the way there, among the points that `drawn_point` gives [m]. With six degrees
  /// of freedom, the ways of the anchors.
  std::vector<Eigen::Vector3d> way;
  std::vector<Eigen::Vector3d> ends;  ///< where it leads
};

/// The nearer one of both kinds; nothing where none was found. `radian`: how long an angle of one rad is
/// drawn [m].
std::optional<NearestSingularity> nearest_singularity(const Manipulator& robot, const Pose& present,
                                                      const BoundaryDistances& distances, double radian);

/// In one line.
std::string words_of(const NearestSingularity& nearest, DistanceUnit unit);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_NEAREST_SINGULARITY_H
