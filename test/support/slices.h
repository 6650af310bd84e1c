// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_SLICES_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_SLICES_H

#include "aspects/tree/pose_space.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <random>
#include <vector>

namespace parallel_aspects::test {

/// That of Eigen has more digits than a double.
inline constexpr double pi = EIGEN_PI;

using Robot = std::shared_ptr<const Manipulator>;
using Held = std::vector<HeldCoordinate>;

inline MapSlice slice_of(const Robot& robot, const Held& held) {
  Problems problems;
  const MapSlice slice = make_slice(*robot, held, problems);
  EXPECT_TRUE(problems.empty()) << problems.front();
  return slice;
}

inline MapOptions options_of(const MapSlice& slice, double resolution,
                             const std::vector<WorkingMode>& modes = {}) {
  MapOptions options;
  options.slice = slice;
  options.resolution = resolution;
  options.modes = modes;
  options.extra_levels = 6;
  return options;
}

inline std::shared_ptr<const AspectMap> map_of(const Robot& robot, const MapOptions& options) {
  const MapResult result = compute_aspect_map(robot, options);
  EXPECT_TRUE(result.map) << result.message;
  return result.map;
}

inline std::shared_ptr<const Uniqueness> uniqueness_of(const Robot& robot,
                                                       const UniquenessOptions& options = {}) {
  const UniquenessResult result = compute_uniqueness(robot, options);
  EXPECT_TRUE(result) << result.message;
  return result.uniqueness;
}

/// In the slice that holds the actuated joint of a leg at this value.
inline std::shared_ptr<const Uniqueness> uniqueness_of_slice(const Robot& robot, std::size_t leg,
                                                             double value, UniquenessOptions options = {}) {
  options.slice = slice_of(robot, {{robot->leg(leg).actuated_joint, value}});
  return uniqueness_of(robot, options);
}

inline double uniform(std::mt19937_64& random, double lower, double upper) {
  return std::uniform_real_distribution<double>(lower, upper)(random);
}

inline MapPosition random_position(const PoseSpace& space, std::mt19937_64& random) {
  MapPosition position;
  position.root = static_cast<RootIndex>(random() % space.root_count());
  for (std::size_t i = 0; i < space.dimension(); ++i)
    position.point[i] = uniform(random, space.region().lower[i], space.region().upper[i]);
  return position;
}

/// That of URDF: Rz(yaw) Ry(pitch) Rx(roll).
inline Eigen::Quaterniond orientation_of(double roll, double pitch, double yaw) {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

/// What is held of a pose without tilt or turn.
inline Held upright(const Held& more = {}) {
  Held held{{"roll", 0.0}, {"pitch", 0.0}, {"yaw", 0.0}};
  held.insert(held.end(), more.begin(), more.end());
  return held;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_SLICES_H
