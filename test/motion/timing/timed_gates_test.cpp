// SPDX-License-Identifier: BSD-3-Clause
// Trajectories through gates keep the further constraints of the robot.
#include "motion/timing/timed_robots.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/constrained_robots.h"
#include "support/robots/robots.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace parallel_aspects {
namespace {

using test::accelerations_of;
using test::between;
using test::JointWaypoints;
using test::Motion;
using test::Robot;
using test::with_speeds;

/// A path of the five-bar through one gate.
PlannedPath through_gate(const Robot& robot) {
  PathPlanner planner(test::map_of(robot, {}));
  return planner.plan({Pose::planar(4.5, 8.0), WorkingMode::from_signs({1, 1})},
                      {Pose::planar(4.5, -8.0), WorkingMode::from_signs({-1, 1})}, PathPolicy::serial);
}

/// Where the links of a five-bar are along a trajectory, by circles alone.
struct LinksAt {
  std::array<Eigen::Vector3d, 2> base, tip;
  Eigen::Vector3d platform;

  double distance_to(const Eigen::Vector3d& point) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < 2; ++j)
      least = std::min({least, distance(point, base[j], tip[j]), distance(point, tip[j], platform)});
    return least;
  }

 private:
  static double distance(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& to) {
    const Eigen::Vector3d along = to - from;
    const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (point - from - share * along).norm();
  }
};

std::vector<LinksAt> links_along(const Manipulator& robot, const JointWaypoints& waypoints,
                                 const Eigen::Vector3d& start) {
  std::vector<LinksAt> result;
  Eigen::Vector3d last = start;
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i)
    for (int k = 0; k <= 200; ++k) {
      const JointVector q = between(waypoints[i], waypoints[i + 1], k / 200.0).q;
      LinksAt links;
      for (std::size_t j = 0; j < 2; ++j) {
        links.base[j] = robot.leg(j).base_point();
        links.tip[j] = robot.leg(j).proximal_point(q[static_cast<Eigen::Index>(j)]);
      }
      const double rod_1 = robot.leg(0).rod_length, rod_2 = robot.leg(1).rod_length;
      const Eigen::Vector3d apart = links.tip[1] - links.tip[0];
      const double d = apart.norm(), along = (d * d + rod_1 * rod_1 - rod_2 * rod_2) / (2.0 * d),
                   across = std::sqrt(rod_1 * rod_1 - along * along);
      const Eigen::Vector3d unit = apart / d, side(-unit.y(), unit.x(), 0.0);
      const Eigen::Vector3d one = links.tip[0] + along * unit + across * side,
                            other = links.tip[0] + along * unit - across * side;
      links.platform = last = (one - last).norm() < (other - last).norm() ? one : other;
      result.push_back(links);
    }
  return result;
}

// Balls about where the leg is stretched, and elsewhere: touched or just not.
TEST(TimePath, KeepsClearOfObstaclesWhereALegPassesAGate) {
  const Robot robot = with_speeds(test::five_bar());
  const PlannedPath path = through_gate(robot);
  ASSERT_EQ(path.crossings.size(), 1U) << path.message;
  const TimedPath timed =
      time_path(SegmentCertifier(robot), path, between_poses(TaskSpace::SE3), accelerations_of(*robot));
  ASSERT_TRUE(timed) << timed.message;
  const auto links = links_along(*robot, timed.waypoints, path.points.front().pose.position);
  const Eigen::Vector3d gate = path.points[path.crossings.front().point].pose.position;
  TrajectoryStart start;
  start.pose = path.points.front().pose;
  TrajectoryCheckOptions options;
  options.pass_serial = true;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int balls = 0;
  for (int i = 0; i < (test::is_sanitized ? 8 : 40); ++i) {
    const Eigen::Vector3d center =
        gate + (i % 2 == 0 ? 1.0 : 8.0) * Eigen::Vector3d(uniform(random), uniform(random), 0.0);
    double least = std::numeric_limits<double>::infinity();
    for (const LinksAt& each : links) least = std::min(least, each.distance_to(center));
    if (least < 0.01) continue;  // a link sweeps over it
    ++balls;
    for (const double share : {0.98, 1.001}) {
      Constraints constraints;
      constraints.obstacles = {{"ball", BallObstacle{center, share * least}}};
      ConstraintKinds obstacles;
      obstacles[index_of(ConstraintKind::obstacles)] = true;
      const SegmentCertifier certifier(test::with(robot, constraints)->with_constraints(obstacles));
      const TrajectoryCheck check = check_trajectory(certifier, timed.waypoints, start, options);
      EXPECT_EQ(check.answer == TrajectoryAnswer::safe, share < 1.0)
          << "ball " << i << " about " << center.transpose() << ", radius " << share * least << ": "
          << check.reason;
    }
  }
  EXPECT_GT(balls, test::is_sanitized ? 1 : 10);
}

TEST(TimePath, KeepsAParallelMarginThroughAGate) {
  const Robot robot = with_speeds(test::five_bar())->with_margins({0.01, 0.0, 0.0});
  const PlannedPath path = through_gate(robot);
  ASSERT_EQ(path.crossings.size(), 1U) << path.message;
  const TimedPath timed =
      time_path(SegmentCertifier(robot), path, between_poses(TaskSpace::SE3), accelerations_of(*robot));
  EXPECT_TRUE(timed) << timed.message;
  for (const LinksAt& each : links_along(*robot, timed.waypoints, path.points.front().pose.position)) {
    const Eigen::Vector3d one = (each.platform - each.tip[0]).normalized(),
                          other = (each.platform - each.tip[1]).normalized();
    ASSERT_GE(std::abs(one.x() * other.y() - one.y() * other.x()), 0.01);
  }
}

TEST(TimePath, SaysThatASerialMarginShutsOutGates) {
  const Robot robot = with_speeds(test::five_bar())->with_margins({0.0, 0.01, 0.0});
  const PlannedPath path = through_gate(with_speeds(test::five_bar()));
  const TimedPath timed =
      time_path(SegmentCertifier(robot), path, between_poses(TaskSpace::SE3), accelerations_of(*robot));
  EXPECT_FALSE(timed);
  EXPECT_NE(timed.message.find("serial margin"), std::string::npos) << timed.message;
}

}  // namespace
}  // namespace parallel_aspects
