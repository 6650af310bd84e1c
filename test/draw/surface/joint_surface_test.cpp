// SPDX-License-Identifier: BSD-3-Clause
// Surfaces in joint space hold the joint values of what the map proves, and no others.
#include "draw/surface/joint_surface.h"

#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/slices.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

std::shared_ptr<const AspectMap> coarse_map(const char* name, double share) {
  const test::Robot robot = test::shipped(name)->manipulator();
  MapOptions options;
  options.modes = working_modes(*robot);
  options.modes.resize(1);
  options.extra_levels = 3;
  options.resolution = share * (robot->task_space() == TaskSpace::SO3 ? 1.0 : robot->size());
  return test::map_of(robot, options);
}

class JointSurfaces : public testing::TestWithParam<std::pair<const char*, double>> {};

// How often a ray up the third axis meets the surface, by a formula of its own.
int crossings(const JointSurface& surface, const Vector3d& from) {
  int count = 0;
  for (const auto& triangle : surface.triangles) {
    Eigen::Matrix3d sides;
    const Vector3d& a = surface.points[triangle[0]];
    sides << surface.points[triangle[1]] - a, surface.points[triangle[2]] - a, -Vector3d::UnitZ();
    if (std::abs(sides.determinant()) < 1e-15) continue;
    const Vector3d share = sides.inverse() * (from - a);
    if (share[0] >= 0.0 && share[1] >= 0.0 && share[0] + share[1] <= 1.0 && share[2] > 0.0) ++count;
  }
  return count;
}

TEST_P(JointSurfaces, LieInTheBlock) {
  const auto map = coarse_map(GetParam().first, GetParam().second);
  ASSERT_TRUE(has_joint_surfaces(*map));
  const JointBlock block = joint_block(*map);
  for (const Aspect& aspect : map->aspects()) {
    const JointSurface surface = joint_surface_of(*map, surface_of(*map, aspect.id), block);
    EXPECT_EQ(surface.bounds.size(), surface.triangles.size());
    const Vector3d rim = Vector3d::Constant(1e-9) + 0.05 * (block.upper - block.lower);
    for (const Vector3d& point : surface.points)
      EXPECT_TRUE(((point - block.lower + rim).array() >= 0.0).all() &&
                  ((block.upper - point + rim).array() >= 0.0).all())
          << "aspect " << aspect.id << ": " << point.transpose();
  }
}

// Of robots whose joints do not wrap, so that surfaces are closed in the block: a ray from the joint values
// of a deep pose leaves the surface.
TEST_P(JointSurfaces, HoldTheJointValuesOfDeepPoses) {
  const auto map = coarse_map(GetParam().first, GetParam().second);
  const JointBlock block = joint_block(*map);
  if (std::any_of(block.turns.begin(), block.turns.end(), [](bool turns) { return turns; })) return;
  if (map->manipulator()->task_space() != TaskSpace::T3) return;  // edges of angles are left out
  for (const Aspect& aspect : map->aspects()) {
    if (aspect.inside_leaves < 200) continue;
    const JointSurface surface = joint_surface_of(*map, surface_of(*map, aspect.id), block);
    const Vector3d q = values_in(block, *map->manipulator(), aspect.deepest, aspect.mode);
    EXPECT_EQ(crossings(surface, q + Vector3d(1e-7, 2e-7, 0.0)) % 2, 1) << "aspect " << aspect.id;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, JointSurfaces,
                         testing::Values(std::pair("three_rrr", 0.05), std::pair("linear_delta", 0.05),
                                         std::pair("spherical_3rrr", 0.15)),
                         [](const auto& given) { return std::string(given.param.first); });

}  // namespace
}  // namespace parallel_aspects
