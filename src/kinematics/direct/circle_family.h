// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_CIRCLE_FAMILY_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_CIRCLE_FAMILY_H

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace parallel_aspects {

/// Two linear equations in a point v of the plane: matrix v = right.
struct LinearPair {
  Eigen::Matrix2d matrix;
  Eigen::Vector2d right;
};

/// Find an angle t and a point v with  matrix(t) v = right(t)  and  |v|^2 = squared_radius, where matrix and
/// right are trigonometric polynomials of degree 1. Locking two of three legs to the linear equations leaves
/// the direct problem in SE2 (v: from a proximal point to its anchor) and in SO3 (v: cosine and sine of the
/// turn about an anchor) so.
struct CircleFamily {
  std::function<LinearPair(double)> equations;
  double squared_radius;
};

struct CircleFamilySolutions {
  struct Candidate {
    double angle;  ///< t [rad]
    Eigen::Vector2d v;
  };
  bool every_angle = false;  ///< the equations leave t free; `candidates` then holds samples
  std::vector<Candidate> candidates;
};

/// Every real solution, at least to the accuracy of half the digits, and possibly others that are none.
/// Cramer's rule gives v = adj(matrix) right / det, so that t is a root of |adj(matrix) right|^2 -
/// squared_radius det^2, of degree 4 (at most 8 roots). Where det vanishes too, v is sought where one of the
/// lines meets the circle.
CircleFamilySolutions circle_family_solutions(const CircleFamily& family);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_CIRCLE_FAMILY_H
