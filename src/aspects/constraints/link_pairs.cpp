// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/constraints/link_pairs.h"

#include <algorithm>

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

}  // namespace parallel_aspects
