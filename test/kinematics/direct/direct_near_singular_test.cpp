// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/round_trip.h"
#include <cmath>
#include <optional>
#include <ostream>

namespace parallel_aspects {
namespace {

struct NearSingularCase {
  std::shared_ptr<const Manipulator> robot;
  Eigen::Vector3d home;
  double spread;
  int count;

  friend std::ostream& operator<<(std::ostream& out, const NearSingularCase& each) {
    return out << each.robot->name();
  }
};

class NearSingular : public testing::TestWithParam<NearSingularCase> {};

Pose between(const Pose& a, const Pose& b, double share) {
  return {(1.0 - share) * a.position + share * b.position, a.orientation.slerp(share, b.orientation)};
}

std::optional<double> determinant(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
  const InverseSolution solution = inverse(robot, pose, mode);
  if (solution.status == InverseStatus::out_of_reach) return std::nullopt;
  return direct_determinant(robot, pose, solution.q);
}

// A pose where det A = 0 to rounding, on the path between two poses where it has both signs; nothing where
// there is none in this mode.
std::optional<Pose> singular_pose(const Manipulator& robot, Pose a, Pose b, const WorkingMode& mode) {
  const auto at_a = determinant(robot, a, mode), at_b = determinant(robot, b, mode);
  if (!at_a || !at_b || (*at_a > 0.0) == (*at_b > 0.0)) return std::nullopt;
  for (int i = 0; i < 100; ++i) {
    const Pose middle = between(a, b, 0.5);
    const auto value = determinant(robot, middle, mode);
    if (!value) return std::nullopt;
    ((*value > 0.0) == (*at_a > 0.0) ? a : b) = middle;
  }
  return a;
}

// At a parallel singularity two direct solutions meet: the pose must be found, to half the digits, and
// flagged.
TEST_P(NearSingular, PoseIsFoundAndFlagged) {
  const auto& [robot, home, spread, count] = GetParam();
  test::RandomRobots random(20260108);
  int tested = 0;
  for (int i = 0; i < 50 * count && tested < count; ++i) {
    Pose a = random.pose(robot->motions(), spread), b = random.pose(robot->motions(), spread);
    a.position += home;
    b.position += home;
    const WorkingMode mode = working_modes(*robot).back();
    const auto pose = singular_pose(*robot, a, b, mode);
    if (!pose) continue;
    ++tested;
    const JointVector q = inverse(*robot, *pose, mode).q;
    SCOPED_TRACE(test::describe(*robot, *pose, q));
    const DirectResult result = direct(*robot, q);
    EXPECT_EQ(result.status, DirectStatus::solved);
    const AssemblyMode* found = test::closest(*robot, result, *pose);
    ASSERT_NE(found, nullptr);
    EXPECT_LT(test::pose_distance(*robot, found->pose, *pose), 1e-4);
    EXPECT_TRUE(found->near_singular);
  }
  EXPECT_EQ(tested, count);
}

std::string near_singular_name(const testing::TestParamInfo<NearSingularCase>& info) {
  return info.param.robot->name();
}

INSTANTIATE_TEST_SUITE_P(EveryTaskSpace, NearSingular,
                         testing::Values(NearSingularCase{test::three_rpr(), {5.0, 5.0, 0.0}, 25.0, 500},
                                         NearSingularCase{test::three_rrr(), {-3.0, -3.0, 0.0}, 10.0, 200},
                                         NearSingularCase{
                                             test::spherical_three_rrr(), {0.0, 0.0, 0.0}, 1.0, 500},
                                         NearSingularCase{test::dietmaier(), {0.0, 0.0, 0.0}, 1.0, 25},
                                         NearSingularCase{test::stewart(), {0.0, 0.0, 0.6}, 0.3, 25},
                                         NearSingularCase{test::six_pus(), {0.0, 0.0, 0.6}, 0.2, 25}),
                         near_singular_name);

}  // namespace
}  // namespace parallel_aspects
