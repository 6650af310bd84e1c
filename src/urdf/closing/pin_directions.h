// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_PIN_DIRECTIONS_H
#define PARALLEL_ASPECTS_URDF_CLOSING_PIN_DIRECTIONS_H

#include "urdf/description/closure.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace parallel_aspects {

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

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_PIN_DIRECTIONS_H
