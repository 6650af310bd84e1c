// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ROADMAP_POSE_SAMPLER_H
#define PARALLEL_ASPECTS_ASPECTS_ROADMAP_POSE_SAMPLER_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <vector>

namespace parallel_aspects {

/// Seeded random poses of a manipulator's task space: the orientation is uniform, then the position is
/// uniform in the box that the reach of the legs leaves for it.
class PoseSampler {
 public:
  /// Positions are kept in the workspace of its constraints, and in `region` where one is given: as many of
  /// x, y, z as it moves [m]. Orientations turn from the identity by at most `largest_rotation` [rad], and
  /// hinges of R1 and R2 from zero.
  PoseSampler(std::shared_ptr<const Manipulator> manipulator, std::uint64_t seed,
              const std::optional<Box>& region, double largest_rotation);

  /// Whether positions are bounded, by the legs or by the region.
  bool is_bounded() const;

  /// A pose that the legs may reach; nothing where the drawn orientation leaves no position.
  std::optional<Pose> draw();

 private:
  using Positions = Eigen::AlignedBox3d;

  double uniform(double lower, double upper);
  Eigen::Quaterniond orientation();
  std::optional<Pose> at_random_angles();
  double angle(double largest);
  Eigen::Vector3d axis();
  Positions positions(const Eigen::Quaterniond& orientation) const;

  std::shared_ptr<const Manipulator> manipulator_;
  std::vector<Positions> anchor_boxes_;  // where the anchor of each leg can be
  Positions region_;
  double largest_rotation_;
  std::mt19937_64 engine_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ROADMAP_POSE_SAMPLER_H
