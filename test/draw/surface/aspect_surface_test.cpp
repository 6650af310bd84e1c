// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of aspects are closed, enclose what the map proves, and end where an independent look at the
// kinematics says that the aspect ends.
#include "draw/surface/aspect_surface.h"

#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/slices.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

struct Case {
  const char* robot;
  double resolution_of_size;  // over the size of the robot; in SO3 [rad]
};

std::ostream& operator<<(std::ostream& stream, const Case& given) { return stream << given.robot; }

class Surfaces : public testing::TestWithParam<Case> {
 protected:
  /// A coarse map of its first two working modes, computed by the first test that asks for it.
  static const AspectMap& map() {
    static std::map<std::string, std::shared_ptr<const AspectMap>> all;
    auto& result = all[GetParam().robot];
    if (result) return *result;
    const test::Robot robot = test::shipped(GetParam().robot)->manipulator();
    MapOptions options;
    options.modes = working_modes(*robot);
    options.modes.resize(2);
    options.extra_levels = 3;
    const bool turns_only = robot->task_space() == TaskSpace::SO3;
    options.resolution = GetParam().resolution_of_size * (turns_only ? 1.0 : robot->size());
    result = test::map_of(robot, options);
    return *result;
  }

  static bool turns_only() { return map().manipulator()->task_space() == TaskSpace::SO3; }

  /// Those that fill a few hundred cells.
  static std::vector<int> larger_aspects() {
    std::vector<int> ids;
    for (const Aspect& aspect : map().aspects())
      if (aspect.inside_leaves > 200) ids.push_back(aspect.id);
    return ids;
  }
};

/// Each edge has one triangle on each side.
void expect_closed(const SurfaceMesh& mesh, const std::string& what) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const auto& triangle : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++uses[{triangle[i], triangle[(i + 1) % 3]}];
  for (const auto& [edge, count] : uses) {
    ASSERT_EQ(count, 1) << what << ": edge " << edge.first << " " << edge.second;
    ASSERT_EQ(uses.count({edge.second, edge.first}), 1U)
        << what << ": edge " << edge.first << " " << edge.second;
  }
  EXPECT_FALSE(uses.empty()) << what;
}

HalfSpace half_of(const AspectSurface& surface) {
  std::vector<double> heights;
  for (const Vector3d& point : surface.mesh.points) heights.push_back(point.z());
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return {Vector3d::UnitZ(), *middle + 1e-3 * surface.edges.z()};
}

TEST_P(Surfaces, AreClosed) {
  ASSERT_FALSE(larger_aspects().empty());
  for (const Aspect& aspect : map().aspects())
    for (const bool smoothed : {false, true}) {
      SurfaceOptions options;
      options.smoothed = smoothed;
      expect_closed(surface_of(map(), aspect.id, options).mesh, "aspect " + std::to_string(aspect.id));
    }
}

TEST_P(Surfaces, EncloseTheInsideLeaves) {
  for (const int id : larger_aspects()) {
    SurfaceOptions options;
    options.smoothed = false;
    const AspectSurface surface = surface_of(map(), id, options);
    double leaves = 0.0;
    map().visit_inside_poses(id, [&leaves](const Pose&, double measure) { leaves += measure; });
    EXPECT_NEAR(surface.measure, leaves, 0.1 * leaves) << "aspect " << id;
    if (!turns_only()) {
      EXPECT_NEAR(volume_of(surface.mesh), surface.measure, 1e-9 * surface.measure) << "aspect " << id;
      options.smoothed = true;
      const double smoothed = volume_of(surface_of(map(), id, options).mesh);
      EXPECT_GT(smoothed, 0.85 * leaves) << "aspect " << id;
      const Aspect& aspect = map().aspects()[static_cast<std::size_t>(id - 1)];
      EXPECT_LT(smoothed, 1.1 * aspect.measure_upper) << "aspect " << id;
    }
  }
}

// The volume of rotations in a ball of rotation vectors, by the density (2 - 2 cos t) / t^2 at the middle of
// thin tetrahedra from the center.
TEST_P(Surfaces, EncloseTheRotations) {
  if (!turns_only()) return;
  for (const int id : larger_aspects()) {
    SurfaceOptions options;
    options.smoothed = false;
    const AspectSurface surface = surface_of(map(), id, options);
    double sum = 0.0;
    constexpr int shells = 200;
    for (const auto& triangle : surface.mesh.triangles) {
      const Vector3d &a = surface.mesh.points[triangle[0]], &b = surface.mesh.points[triangle[1]],
                     &c = surface.mesh.points[triangle[2]];
      const double volume = a.dot(b.cross(c)) / 6.0, reach = ((a + b + c) / 3.0).norm();
      for (int shell = 0; shell < shells; ++shell) {
        const double share = (shell + 0.5) / shells, angle = share * reach;
        sum += volume * 3.0 * share * share / shells * 2.0 * (1.0 - std::cos(angle)) / (angle * angle);
      }
    }
    EXPECT_NEAR(sum, surface.measure, 0.05 * surface.measure) << "aspect " << id;
  }
}

TEST_P(Surfaces, AreSmoothedByNoMoreThanACell) {
  for (const int id : larger_aspects()) {
    SurfaceOptions raw;
    raw.smoothed = false;
    const AspectSurface before = surface_of(map(), id, raw), after = surface_of(map(), id);
    ASSERT_EQ(before.mesh.points.size(), after.mesh.points.size());
    for (std::size_t p = 0; p < before.mesh.points.size(); ++p)
      for (Eigen::Index i = 0; i < 3; ++i)
        ASSERT_LE(std::abs(after.mesh.points[p][i] - before.mesh.points[p][i]), 1.0001 * after.edges[i])
            << "aspect " << id << ", point " << p;
  }
}

Pose pose_at(TaskSpace space, const Vector3d& point) {
  Pose pose;
  if (space == TaskSpace::T3) {
    pose.position = point;
  } else if (space == TaskSpace::SE2) {
    pose = Pose::planar(point.x(), point.y(), point.z());
  } else {
    pose.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(point.norm(), point.normalized()));
  }
  return pose;
}

TEST_P(Surfaces, EndWhereTheAspectEnds) {
  const Manipulator& robot = *map().manipulator();
  for (const int id : larger_aspects()) {
    const Aspect& aspect = map().aspects()[static_cast<std::size_t>(id - 1)];
    const AspectSurface surface = surface_of(map(), id);
    std::size_t found = 0, inside = 0;
    for (std::size_t p = 0; p < surface.mesh.points.size(); ++p) {
      if (!surface.bounds[p]) continue;
      ++found;
      const Pose pose = pose_at(robot.task_space(), surface.mesh.points[p]);
      const InverseSolution solution = inverse(robot, pose, aspect.mode);
      if (solution && aspect.determinant_sign * direct_determinant(robot, pose, solution.q) > 0.0) ++inside;
    }
    // In SO3 so coarse a map leaves several cells before the end undecided.
    const std::size_t fewest = turns_only() ? 0 : surface.mesh.points.size() / 5;
    EXPECT_GE(found, fewest) << "aspect " << id;
    EXPECT_GE(static_cast<double>(inside), 0.95 * static_cast<double>(found)) << "aspect " << id;
  }
}

TEST_P(Surfaces, AreCutByASection) {
  for (const int id : larger_aspects()) {
    const AspectSurface whole = surface_of(map(), id);
    const HalfSpace half = half_of(whole);
    const AspectSurface cut = section_of(whole, half);
    expect_closed(cut.mesh, "aspect " + std::to_string(id));
    std::size_t faces = 0;
    for (std::size_t t = 0; t < cut.mesh.triangles.size(); ++t)
      for (const std::uint32_t corner : cut.mesh.triangles[t]) {
        const double height = cut.mesh.points[corner].z() - half.offset;
        ASSERT_LE(height, 1e-9) << "aspect " << id;
        if (cut.mesh.kinds[t] != FaceKind::section) continue;
        ++faces;
        ASSERT_NEAR(height, 0.0, 1e-9) << "aspect " << id;
      }
    EXPECT_GT(faces, 0U) << "aspect " << id;
    const AspectSurface rest = section_of(whole, {-half.normal, -half.offset});
    EXPECT_NEAR(volume_of(cut.mesh) + volume_of(rest.mesh), volume_of(whole.mesh),
                1e-9 * volume_of(whole.mesh))
        << "aspect " << id;
  }
}

TEST_P(Surfaces, HaveNoMoreTrianglesThanAllowed) {
  SurfaceOptions options;
  options.most_triangles = 6000;
  for (const int id : larger_aspects())
    EXPECT_LE(surface_of(map(), id, options).mesh.triangles.size(), 6000U) << "aspect " << id;
}

TEST_P(Surfaces, PointsOfPosesAreThoseOfCells) {
  const TaskSpace space = map().manipulator()->task_space();
  const AspectSurface surface = surface_of(map(), larger_aspects().front());
  for (std::size_t p = 0; p < surface.mesh.points.size(); p += 7) {
    const Vector3d& point = surface.mesh.points[p];
    if (turns_only() ? point.norm() > 3.1 : space == TaskSpace::SE2 && std::abs(point.z()) > 3.1) continue;
    EXPECT_LT((surface_point(space, pose_at(space, point)) - point).norm(), 1e-9) << point.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Surfaces,
                         testing::Values(Case{"three_rrr", 0.04}, Case{"linear_delta", 0.05},
                                         Case{"spherical_3rrr", 0.13}),
                         [](const auto& given) { return std::string(given.param.robot); });

}  // namespace
}  // namespace parallel_aspects
