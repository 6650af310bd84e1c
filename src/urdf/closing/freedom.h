// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_FREEDOM_H
#define PARALLEL_ASPECTS_URDF_CLOSING_FREEDOM_H

#include "urdf/description/closure.h"

#include <Eigen/Core>

#include <vector>

namespace parallel_aspects {

/// In how many ways the links of closed loops move: what costs as much as one attempt to load, and rules out
/// many.
class Freedom {
 public:
  /// The tree must outlive it; no closure may be automatic.
  Freedom(const Tree& tree, std::size_t base, std::vector<Closure> closures);

  /// The most, over some configurations, by which the twist of a link has dimensions; 0 where the loops do
  /// not close.
  std::size_t of(std::size_t link) const;

 private:
  struct Sample {
    Poses poses;
    Eigen::MatrixXd motions;  // orthonormal columns, lengths in sizes of the robot
  };

  void add(const Eigen::VectorXd& values);

  ClosureSystem system_;
  std::vector<Sample> samples_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_FREEDOM_H
