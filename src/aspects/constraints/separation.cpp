// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/constraints/separation.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

// Rods by one anchor, cranks by one centre.
bool are_joined(const Manipulator& manipulator, const LinkName& one, const LinkName& other) noexcept {
  if (one.kind != other.kind) return false;
  const Leg &leg = manipulator.leg(one.leg), &next = manipulator.leg(other.leg);
  const Eigen::Vector3d between = one.kind == LinkKind::rod
                                      ? Eigen::Vector3d(leg.anchor - next.anchor)
                                      : Eigen::Vector3d(leg.base_point() - next.base_point());
  return between.norm() <= joint_tolerance * manipulator.size();
}

bool is_ignored(const SelfCollision& collision, const LinkName& one, const LinkName& other) noexcept {
  return std::any_of(collision.ignored.begin(), collision.ignored.end(), [&](const auto& pair) {
    return (pair[0] == one && pair[1] == other) || (pair[0] == other && pair[1] == one);
  });
}

}  // namespace

bool can_collide(const Manipulator& manipulator, const LinkName& one, const LinkName& other) noexcept {
  return one.leg != other.leg && !are_joined(manipulator, one, other) &&
         !is_ignored(*manipulator.constraints().self_collision, one, other);
}

namespace {

using Eigen::Vector3d;

constexpr int bisections = 40;

double share(double numerator, double denominator) {
  return denominator > 0.0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0.0;
}

// Half of the derivative of the squared distance from the box by the share: never decreasing.
double slope(const Vector3d& point, const Vector3d& along, const Vector3d& half_size) {
  return (point - point.cwiseMin(half_size).cwiseMax(-half_size)).dot(along);
}

// The shares of a segment that are in the box; crossed where there are none (Liang and Barsky).
std::pair<double, double> shares_inside(const Vector3d& from, const Vector3d& along,
                                        const Vector3d& half_size) {
  double begin = 0.0, end = 1.0;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (along[i] == 0.0) {
      if (from[i] < -half_size[i] || from[i] > half_size[i]) return {1.0, 0.0};
      continue;
    }
    const double one = (-half_size[i] - from[i]) / along[i], other = (half_size[i] - from[i]) / along[i];
    begin = std::max(begin, std::min(one, other));
    end = std::min(end, std::max(one, other));
  }
  return {begin, end};
}

}  // namespace

ClosestPoints closest_points(const Vector3d& a_from, const Vector3d& a_to, const Vector3d& b_from,
                             const Vector3d& b_to) noexcept {
  const Vector3d a = a_to - a_from, b = b_to - b_from, offset = a_from - b_from;
  const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b);
  const double ao = a.dot(offset), bo = b.dot(offset);
  double s = share(ab * bo - ao * bb, aa * bb - ab * ab);
  const double t = bb > 0.0 ? std::clamp((ab * s + bo) / bb, 0.0, 1.0) : 0.0;
  s = share(ab * t - ao, aa);
  const Vector3d second = b_from + t * b;
  return {s, t, second, a_from + s * a - second};
}

ClosestPoints closest_point_to_box(const Vector3d& from, const Vector3d& to,
                                   const Vector3d& half_size) noexcept {
  const Vector3d along = to - from;
  const auto [enter, leave] = shares_inside(from, along, half_size);
  double begin = 0.0, end = 1.0;
  if (enter <= leave) begin = end = 0.5 * (enter + leave);
  for (int i = 0; i < bisections && begin < end; ++i) {
    const double middle = 0.5 * (begin + end);
    (slope(from + middle * along, along, half_size) > 0.0 ? end : begin) = middle;
  }
  const double s = 0.5 * (begin + end);
  const Vector3d point = from + s * along, nearest = point.cwiseMin(half_size).cwiseMax(-half_size);
  return {s, 0.0, nearest, point - nearest};
}

}  // namespace parallel_aspects
