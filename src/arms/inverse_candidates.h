// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ARMS_INVERSE_CANDIDATES_H
#define PARALLEL_ASPECTS_ARMS_INVERSE_CANDIDATES_H

#include "parallel_aspects/arms/serial_arm.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace parallel_aspects {

/// Joint values that are solutions but for rounding, or none: to be corrected and looked at.
using Candidates = std::vector<Eigen::VectorXd>;

/// Of an angle: solutions of a cos(x) + b sin(x) = c; the nearest angle where there is almost none.
std::vector<double> solutions_of_circle(double a, double b, double c);

/// Links after Denavit and Hartenberg as numbers, without offsets of joint values.
struct LinkNumbers {
  double turn = 0.0, offset = 0.0, length = 0.0, cosine = 1.0, sine = 0.0;  ///< the last two of the twist
};
std::vector<LinkNumbers> link_numbers(const SerialArm& arm);
Eigen::Matrix3d about_z(double angle);
Eigen::Matrix3d twist_of(const LinkNumbers& link);
inline Eigen::Vector3d shift_of(const LinkNumbers& link) { return {link.length, 0.0, link.offset}; }

/// The candidates of each method; `goal` is the last frame in the first (`SerialArm::frames`), of which the
/// methods for positions look at the operational point alone.
Candidates planar_candidates(const SerialArm& arm, const Eigen::Isometry3d& goal);
Candidates wrist_candidates(const SerialArm& arm, const Eigen::Isometry3d& goal);
Candidates three_parallel_candidates(const SerialArm& arm, const Eigen::Isometry3d& goal);
Candidates elimination_candidates(const SerialArm& arm, const Eigen::Isometry3d& goal);

/// Of the first three joints, which turn: at which a point at this height above the third frame is in
/// `point`, in the first frame.
Candidates position_candidates(const std::vector<LinkNumbers>& links, double height,
                               const Eigen::Vector3d& point);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ARMS_INVERSE_CANDIDATES_H
