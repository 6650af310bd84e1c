// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ROADMAP_ROADMAP_GROWTH_H
#define PARALLEL_ASPECTS_ASPECTS_ROADMAP_ROADMAP_GROWTH_H

#include "parallel_aspects/aspects/map_control.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/aspects/segment_certifier.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace parallel_aspects {

/// Where the anchors of a platform are [m], divided by the root of their number: distances between such
/// points are root mean square displacements of the anchors.
using AnchorPoint = Eigen::Matrix<double, 3 * max_legs, 1>;

AnchorPoint anchor_point(const Manipulator& manipulator, const Pose& pose);

/// What growth needs of the roadmap.
struct RoadmapGround {
  const SegmentCertifier& certifier;
  const std::vector<Pose>& poses;
  const std::vector<AnchorPoint>& points;  ///< of the poses
  std::size_t neighbors;
};

/// Joins the poses of a side: each to its nearest, then components to one another, shortest segments first
/// and none between poses that are joined already. The result does not depend on the number of threads. Ends
/// early, of no use, when cancelled.
void grow(RoadmapSide& side, const RoadmapGround& ground, const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ROADMAP_ROADMAP_GROWTH_H
