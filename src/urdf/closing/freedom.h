// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_FREEDOM_H
#define PARALLEL_ASPECTS_URDF_CLOSING_FREEDOM_H

#include "urdf/closing/assembly.h"
#include "urdf/description/closure.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// In how many ways the platform moves, and how far it is from one less.
struct PlatformFreedom {
  Eigen::Index translations = 0;
  Eigen::Index motions = 0;  ///< with rotations
  double conditioning = 0.0;

  Eigen::Index ways() const { return translations + motions; }

  /// Up to two actuated joints move a point.
  bool is_full(std::size_t actuated_joints) const {
    const auto count = static_cast<Eigen::Index>(actuated_joints);
    return motions == count && (count > 2 || translations == count);
  }
};

/// Of a link in an assembly. Velocities of its origin count, and of those all with the angular ones: one task
/// space wants the former, another the latter.
PlatformFreedom platform_freedom(const ClosureSystem& system, const Assembly& assembly, std::size_t link,
                                 std::size_t actuated_joints);

/// About which two links turn against each other in the motions of an assembly: orthonormal columns, in the
/// base frame. `poses`: where the links are.
Eigen::MatrixXd axes_between(const ClosureSystem& system, const Poses& poses, const Eigen::MatrixXd& motions,
                             const std::array<LinkFrame, 2>& frames);

/// Those of these joints that can move while the others are locked, and leave the link where it is.
std::vector<std::size_t> idle_joints(const ClosureSystem& system, const Assembly& assembly, std::size_t link,
                                     const std::vector<std::size_t>& joints);

/// In how many ways these configurations, which close the loops, let a link move at most: 0 where there are
/// none.
std::size_t freedom_of(const ClosureSystem& system, const std::vector<Eigen::VectorXd>& closed,
                       std::size_t link);

/// The joints inside the loops that these hold still, for each joint value: as those that only take up
/// misalignment in a planar robot. Found from where the mechanism is after a step of each of its motions.
std::vector<bool> still_joints(const ClosureSystem& system, const Assembly& assembly);

/// Which way round the axes of revolute closures are. No motion turns a pin around in its hole: two
/// assemblies that differ in this are two robots.
class PinDirections {
 public:
  explicit PinDirections(const ClosureSystem& system);

  /// How many are not as they are drawn, where their axes are parallel at zero, as in the plane; else not the
  /// same way round, as those of frames that coincide.
  std::size_t turned_over(const Eigen::VectorXd& values) const;

 private:
  const ClosureSystem& system_;
  std::vector<double> drawn_;  // cosines of the angles between the axes at zero
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_FREEDOM_H
