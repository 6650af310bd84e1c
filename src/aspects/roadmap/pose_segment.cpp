// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/roadmap/pose_segment.h"

#include "interval/half_turns.h"
#include "model/angles.h"

#include <cstddef>

namespace parallel_aspects {
namespace {

// Of quaternions between two of about unit length at most a right angle apart it is at least a half; less
// shows that the part is too long.
constexpr double least_squared_norm = 0.01;

Turn<PathForm> turn_of(const PathForm& angle) {
  const Turn<Interval> center = enclosed_turn(0.0, 1.0, angle.center);
  const Turn<Interval> range = enclosed_turn(0.0, 1.0, angle.range);
  return {composed(angle, center.cosine, range.cosine, -range.sine),
          composed(angle, center.sine, range.sine, range.cosine)};
}

// The short way from one angle to another, of numbers: the nearest of the ways that lead there.
Interval short_way(double from, double to) {
  const Interval way = Interval(to) - Interval(from), turn = Interval(2.0) * pi_enclosure();
  const double middle = 0.5 * (way.lower() + way.upper());
  return middle > pi ? way - turn : middle < -pi ? way + turn : way;
}

}  // namespace

PoseSegment::PoseSegment(const Motions& motions, const Pose& from, const Pose& to) noexcept
    : motions_(motions) {
  assert_rounding_upward();
  if (motions.space == TaskSpace::R2) {
    const PoseCoordinates start = pose_coordinates(motions.space, from),
                          end = pose_coordinates(motions.space, to);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      angles_[i] = Interval(start[k]);
      turns_[i] = short_way(start[k], end[k]);
    }
    return;
  }
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

// Sines of ranges longer than this say nothing.
constexpr double longest_turn = 1.5;

bool PoseSegment::place_by_hinges(const PathForm& t, Placement& placement) const noexcept {
  std::array<Turn<PathForm>, 2> turns;
  for (std::size_t i = 0; i < 2; ++i) {
    const PathForm angle = PathForm(angles_[i]) + turns_[i] * t;
    if (!(angle.range.upper() - angle.range.lower() < longest_turn)) return false;
    turns[i] = turn_of(angle);
  }
  placement = EnclosedHinges(motions_.hinges).placed(turns[0], turns[1]);
  return true;
}

bool PoseSegment::place(const PathForm& t, Placement& placement) const noexcept {
  assert_rounding_upward();
  if (motions_.space == TaskSpace::R2) return place_by_hinges(t, placement);
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
