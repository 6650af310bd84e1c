// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_CLOSEST_POINTS_H
#define PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_CLOSEST_POINTS_H

#include <Eigen/Core>

namespace parallel_aspects {

/// Points of two bodies that are closest to each other, in double precision: what is proved starts from
/// there. Along a segment a share of 0 is its first end, 1 its second.
struct ClosestPoints {
  double first_share = 0.0, second_share = 0.0;  ///< the second is unused for a box
  Eigen::Vector3d second_point = Eigen::Vector3d::Zero();
  Eigen::Vector3d difference = Eigen::Vector3d::Zero();  ///< first point minus second [m]
};

/// Of two segments, which may be points. (Ericson, Real-Time Collision Detection, 2005, section 5.1.9.)
ClosestPoints closest_points(const Eigen::Vector3d& a_from, const Eigen::Vector3d& a_to,
                             const Eigen::Vector3d& b_from, const Eigen::Vector3d& b_to) noexcept;

/// Of a segment and the box of all |x_i| <= half_size_i. Where they meet, the point of the segment is in the
/// middle of what the box holds of it, and the difference is zero.
ClosestPoints closest_point_to_box(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                   const Eigen::Vector3d& half_size) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_CLOSEST_POINTS_H
