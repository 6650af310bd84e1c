// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include <array>
#include <cmath>
#include <random>

namespace parallel_aspects {
namespace {

// Where the proximal points of a Delta, each moved by its anchor, can meet (docs/theory/maps.md): the crank
// is longer than the difference of the radii.
struct MeetingPoint {
  explicit MeetingPoint(const Manipulator& robot) {
    const Leg& leg = robot.leg(0);
    const double difference = leg.base_point().head<2>().norm() - leg.anchor.head<2>().norm();
    const double height = std::sqrt(std::pow(leg.crank()->radius, 2) - std::pow(difference, 2));
    upper.z() = height;
    rod = leg.rod_length;
  }
  Eigen::Vector3d upper = Eigen::Vector3d::Zero();  // the other is below
  double rod;
};

// How many legs have their point there.
std::size_t legs_at(const Manipulator& robot, const JointVector& q, const Eigen::Vector3d& meeting) {
  std::size_t count = 0;
  for (std::size_t j = 0; j < robot.leg_count(); ++j)
    count += (robot.leg(j).proximal_point(q[static_cast<Eigen::Index>(j)]) - robot.leg(j).anchor - meeting)
                 .norm() < 1e-9;
  return count;
}

double determinant_at(const Manipulator& robot, const Eigen::Vector3d& position, const WorkingMode& mode) {
  const Pose pose{position, Eigen::Quaterniond::Identity()};
  return direct_determinant(robot, pose, inverse(robot, pose, mode).q);
}

// Two rods that are one: det A changes its sign across the sphere. Three: it keeps it, and falls with the
// square of the distance.
TEST(DeltaSphere, RodsThatAreOneLoseControl) {
  const auto robot = test::delta();
  const MeetingPoint meeting(*robot);
  std::mt19937_64 random{20261123};
  std::normal_distribution<double> normal;
  std::array<int, 4> seen{};  // by number of legs
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d u = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    const Pose pose{meeting.upper + meeting.rod * u, Eigen::Quaterniond::Identity()};
    for (const InverseSolution& solution : inverse_in_all_modes(*robot, pose)) {
      if (solution.status != InverseStatus::solved ||
          serial_indices(*robot, pose, solution.q).minCoeff() < 0.2)
        continue;
      const std::size_t legs = legs_at(*robot, solution.q, meeting.upper);
      ++seen[legs];
      if (legs < 2) continue;
      const auto at = [&](double off) {
        return determinant_at(*robot, pose.position + off * u, solution.mode);
      };
      EXPECT_NEAR(at(0.0), 0.0, 1e-12) << pose.position.transpose();
      const double step = 1e-5, outside = at(step), inside = at(-step), nearer = at(0.5 * step);
      // Near another singularity, terms of a higher order are as large.
      if (std::abs(outside) < 0.05 * std::pow(step, static_cast<double>(legs - 1))) continue;
      EXPECT_EQ(outside * inside > 0.0, legs == 3)
          << pose.position.transpose() << ' ' << to_string(solution.mode);
      EXPECT_NEAR(outside / nearer, legs == 3 ? 4.0 : 2.0, 0.05) << pose.position.transpose();
    }
  }
  EXPECT_GT(seen[2], 100);
  EXPECT_GT(seen[3], 100);
}

}  // namespace
}  // namespace parallel_aspects
