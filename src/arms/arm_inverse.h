// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ARMS_ARM_INVERSE_H
#define PARALLEL_ASPECTS_ARMS_ARM_INVERSE_H

#include "parallel_aspects/arms/serial_arm.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace parallel_aspects {

/// How inverse solutions of an arm are found.
enum class InverseMethod {
  planar,          ///< two or three turning joints in a plane, and slides along its normal
  position,        ///< three turning joints: a quartic in tan(theta3 / 2)
  wrist,           ///< the last three axes meet: position, then orientation
  three_parallel,  ///< the second, third and fourth axes are parallel, and the last two meet
  elimination,     ///< six turning joints: Raghavan and Roth
  search,          ///< Newton's method from many places
};
const char* name(InverseMethod method);  ///< "three_parallel"

InverseMethod inverse_method(const SerialArm& arm);

/// Whether a solution in each set of joint values where the factors of det J have given signs is the only one
/// of its pose there: then the arm is not cuspidal. By the closed form: each joint angle solves an equation
/// A cos + B sin = C with two solutions, and what tells them apart, -A sin + B cos, is a factor of det J.
bool has_one_solution_a_sign(const SerialArm& arm);

/// A solution.
struct ArmSolution {
  Eigen::VectorXd q;       ///< angles from -pi to pi, or within limits where they have such [rad or m]
  double residual = 0.0;   ///< largest difference of the pose [m or rad]
  bool is_proved = false;  ///< whether there is exactly one in a box of 1e-6 about q, or less
};

/// All that are found.
struct ArmSolutions {
  std::vector<ArmSolution> all;
  bool is_complete = false;  ///< whether it is known that there are no others
  std::string reason;        ///< why that is so, or why not
};

/// The values of the joints at which the operational point is there; limits are not looked at.
ArmSolutions inverse_solutions(const SerialArm& arm, const Eigen::Isometry3d& tip);

/// A frame of the operational point with these task coordinates (see `SerialArm::task_coordinates`); the rest
/// is as in a solution, where the task leaves it open. Angles of a pose: roll, pitch, yaw.
Eigen::Isometry3d tip_with(const SerialArm& arm, const Eigen::VectorXd& coordinates);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ARMS_ARM_INVERSE_H
