// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// In which aspects paths around cusps run, against the direct solutions of actuated values on circles about
// them.

namespace parallel_aspects {
namespace {

using test::Robot;

/// How far a platform is turned and moved from one pose to another, in the robot's size.
double distance_between(const Manipulator& robot, const Pose& a, const Pose& b) {
  return a.orientation.angularDistance(b.orientation) + (a.position - b.position).norm() / robot.size();
}

/// The poses near a cusp of the actuated values at an angle on a circle about its own.
std::vector<AssemblyMode> solutions_at(const Manipulator& robot, const Cusp& cusp, double radius,
                                       double angle) {
  JointVector q = cusp.actuated;
  q[1] += radius * std::cos(angle);
  q[2] += radius * std::sin(angle);
  std::vector<AssemblyMode> near;
  for (const AssemblyMode& each : direct(robot, q).solutions)
    if (working_mode(robot, each.pose, q) == cusp.mode &&
        distance_between(robot, each.pose, cusp.pose) < 5.0 * std::sqrt(radius))
      near.push_back(each);
  return near;
}

/// Two solutions of equal sign of det A.
struct EqualPair {
  int sign = 0;
  std::array<Pose, 2> poses;
};

/// Of three solutions, for an angle that has them. They come by falling det A.
std::optional<EqualPair> pair_beside(const Manipulator& robot, const Cusp& cusp, double radius) {
  for (int i = 0; i < 3600; ++i) {
    const auto near = solutions_at(robot, cusp, radius, 2.0 * test::pi * (i * 1117 % 3600) / 3600.0);
    if (near.size() != 3) continue;
    return near[1].determinant > 0.0 ? EqualPair{1, {near[0].pose, near[1].pose}}
                                     : EqualPair{-1, {near[1].pose, near[2].pose}};
  }
  return std::nullopt;
}

/// What the map tells of both; 0 where it does not.
int aspect_of(const AspectMap& map, const WorkingMode& mode, const EqualPair& pair) {
  const AnchorCircle circle = circle_of_anchor(*map.manipulator(), *map.slice()->joint);
  const int aspect = map.locate(circle.nearest(pair.poses[0]), mode).aspect;
  return map.locate(circle.nearest(pair.poses[1]), mode).aspect == aspect ? aspect : 0;
}

/// On how many circles the map tells what it does.
int count_told(const AspectMap& map, const Cusp& cusp, const std::string& text) {
  const Manipulator& robot = *map.manipulator();
  const Aspect& aspect = map.aspects().at(static_cast<std::size_t>(cusp.aspect - 1));
  EXPECT_EQ(aspect.mode, cusp.mode) << text;
  int told = 0;
  for (const double radius : {1e-5, 1e-4, 1e-3}) {
    const auto pair =
        pair_beside(robot, cusp, radius * (robot.leg(1).actuated_by_angle() ? 1.0 : robot.size()));
    if (!pair) continue;
    EXPECT_EQ(pair->sign, aspect.determinant_sign) << text;
    const int located = aspect_of(map, cusp.mode, *pair);
    if (located == 0) continue;
    EXPECT_EQ(located, cusp.aspect) << text;
    ++told;
  }
  return told;
}

TEST(CuspAspects, HoldBothSolutionsOfEqualSign) {
  const std::vector<std::pair<Robot, double>> slices{{test::three_rpr()->with_constraints({}), 14.98},
                                                     {test::three_rpr(), 14.98},
                                                     {test::three_rrr()->with_constraints({}), 0.3}};
  for (const auto& [robot, held] : slices) {
    const auto found = test::uniqueness_of_slice(robot, 0, held);
    for (std::size_t i = 0; i < found->cusps.size(); i += test::is_sanitized ? 4 : 1) {
      const std::string text = robot->name() + ", cusp " + std::to_string(i + 1);
      ASSERT_GT(found->cusps[i].aspect, 0) << text;
      EXPECT_GT(count_told(*found->map, found->cusps[i], text), 0) << text;
    }
  }
}

}  // namespace
}  // namespace parallel_aspects
