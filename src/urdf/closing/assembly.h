// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_ASSEMBLY_H
#define PARALLEL_ASPECTS_URDF_CLOSING_ASSEMBLY_H

#include "urdf/description/closure.h"

#include <Eigen/Core>

#include <optional>
#include <random>
#include <vector>

namespace parallel_aspects {

/// Singular values of the closure Jacobian below this part of the largest one count as zero. Wide enough for
/// angles rounded to four digits, as in rpy="1.57075 0 0".
inline constexpr double rank_tolerance = 5e-4;

/// A mechanism closes when its residual is below this part of its size; the same rounding asks for it.
inline constexpr double closing_tolerance = 5e-4;

/// Velocities of orthonormal motions below this count as none, lengths in sizes of the robot.
inline constexpr double velocity_tolerance = 1e-3;

/// A configuration that closes every loop, away from singularities where one was found.
struct Assembly {
  Eigen::VectorXd values;  ///< of all joints; those outside the loops are zero [rad or m]
  /// Basis of the joint velocities that keep the loops closed, a column each; orthonormal once lengths are
  /// divided by the size of the robot [rad or m].
  Eigen::MatrixXd motions;
  double residual = 0.0;  ///< largest entry over the size of the robot, dimensionless
};

/// How joints can move from a configuration that closes every loop.
struct LoopMotions {
  Eigen::MatrixXd motions;    ///< see `Assembly::motions`
  double conditioning = 0.0;  ///< of the closures: 0 where they hold nothing
};

LoopMotions loop_motions(const ClosureSystem& system, const Eigen::VectorXd& values);

/// Twists of a link in such motions, angular velocities first, lengths in sizes of the robot. `poses`: where
/// the links are.
Eigen::MatrixXd link_twists(const ClosureSystem& system, const Poses& poses, std::size_t link,
                            const Eigen::MatrixXd& motions);

/// Rates of the actuated joints in each of such motions, lengths in sizes of the robot; a row for each joint.
Eigen::MatrixXd actuated_rates(const ClosureSystem& system, const Eigen::MatrixXd& motions,
                               const std::vector<std::size_t>& actuated_joints);

struct AssemblyResult {
  std::optional<Assembly> assembly;
  Eigen::VectorXd closest;  ///< where the loops come closest to closing, if they do not
};

/// Levenberg-Marquardt from the zero configuration and from seeded random ones, inside the joint limits;
/// where all that this finds are singular or stand on a limit, also from beside the best of them. Of the
/// assembled configurations it takes one where the `actuated_joints` move independently, the mobility is
/// least, the platform moves in most ways and the conditioning is good: the others are singular, or in a
/// branch that is not meant, as a crossed parallelogram.
AssemblyResult assemble(const ClosureSystem& system, const std::vector<std::size_t>& actuated_joints,
                        std::size_t platform_link);

/// Random values, inside their limits, of the joints in the loops, from which these may be closed; the others
/// are as near to zero as their limits allow.
Eigen::VectorXd random_start(const ClosureSystem& system, std::mt19937& random);

/// The configuration nearest to `start` that closes the loops, with the joints marked in `held` kept where
/// they are. What it returns need not close them.
Eigen::VectorXd close_loops(const ClosureSystem& system, Eigen::VectorXd start,
                            const std::vector<bool>& held);

/// Up to `wanted` configurations that close the loops, from zero and from seeded random ones, `starts` in
/// all: for callers that examine of many mechanisms whether they close.
std::vector<Eigen::VectorXd> closed_configurations(const ClosureSystem& system, int starts,
                                                   std::size_t wanted);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_ASSEMBLY_H
