// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/roadmap/pose_segment.h"

#include <cstddef>

namespace parallel_aspects {
namespace {

// Of quaternions between two of about unit length at most a right angle apart it is at least a half; less
// shows that the part is too long.
constexpr double least_squared_norm = 0.01;

}  // namespace

PoseSegment::PoseSegment(const Pose& from, const Pose& to) noexcept {
  assert_rounding_upward();
  const Eigen::Vector4d first = from.orientation.coeffs(), last = nearer_quaternion(from, to);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    position_[i] = Interval(from.position[k]);
    travel_[i] = Interval(to.position[k]) - position_[i];
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    quaternion_[i] = Interval(first[k]);
    quaternion_change_[i] = Interval(last[k]) - quaternion_[i];
  }
}

bool PoseSegment::place(const PathForm& t, Placement& placement) const noexcept {
  assert_rounding_upward();
  for (std::size_t i = 0; i < 3; ++i) placement.position[i] = position_[i] + travel_[i] * t;
  std::array<PathForm, 4> q;
  for (std::size_t i = 0; i < 4; ++i) q[i] = quaternion_[i] + quaternion_change_[i] * t;
  const QuaternionRotation<PathForm> rotation(q);
  const PathForm squared_norm = rotation.squared_norm();
  if (!(squared_norm.range.lower() > least_squared_norm)) return false;
  placement.rotation = rotation.rows(reciprocal(squared_norm));
  return true;
}

}  // namespace parallel_aspects
