// SPDX-License-Identifier: BSD-3-Clause
// In the coordinates of a neighbourhood the metric of the anchors is Euclidean.
#include "distance/anchor_metric.h"

#include "distance/local_chart.h"
#include "parallel_aspects/distance/boundary_distances.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include <cmath>
#include <random>

namespace parallel_aspects {
namespace {

template <TaskSpace space>
void expect_euclidean(const std::shared_ptr<const Manipulator>& robot, const Pose& pose) {
  using Hood = LocalChart<space>;
  Hood chart(*robot);
  {
    const RoundingUpward rounding;
    chart.move_to(pose);
  }
  std::mt19937_64 engine(20261121);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    Coordinates<Hood::size> y;
    for (double& each : y) each = 0.8 * robot->characteristic_length() * uniform(engine);
    const RoundingUpward rounding;
    if (chart.is_about_half_turn(y)) continue;
    ++compared;
    const double length = std::sqrt(dot<Hood::size>(y, y));
    EXPECT_NEAR(anchor_distance(*robot, pose, chart.pose_at(y)), length, 1e-12 * (1.0 + length))
        << robot->name();
  }
  EXPECT_GT(compared, 50);
  EXPECT_LT(chart.metric().error, 1e-12);
}

Pose turned_pose(const Eigen::Vector3d& position, double angle, const Eigen::Vector3d& axis) {
  Pose pose;
  pose.position = position;
  pose.orientation = Eigen::AngleAxisd(angle, axis.normalized());
  return pose;
}

TEST(AnchorMetric, IsTheLengthOfTheCoordinates) {
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ(), any(1.0, -2.0, 0.7);
  expect_euclidean<TaskSpace::T2>(test::five_bar(), turned_pose({4.5, 8.0, 0.0}, 0.0, z));
  expect_euclidean<TaskSpace::SE2>(test::three_rpr(), turned_pose({-8.7, 12.2, 0.0}, -0.99, z));
  expect_euclidean<TaskSpace::SE2>(test::three_rrr(), turned_pose({-3.0, -3.0, 0.0}, 2.9, z));
  expect_euclidean<TaskSpace::T3>(test::delta(), turned_pose({0.1, 0.1, -0.7}, 0.0, z));
  expect_euclidean<TaskSpace::SO3>(test::spherical_three_rrr(), turned_pose({0.0, 0.0, 0.0}, 1.1, any));
  expect_euclidean<TaskSpace::SE3>(test::stewart(), turned_pose({0.1, -0.1, 0.6}, 0.4, any));
  expect_euclidean<TaskSpace::SE3>(test::dietmaier(), turned_pose({0.3, 0.2, 0.6}, 2.4, any));
}

TEST(AnchorMetric, AnchorsInALineSeeNoTurnAboutIt) {
  const test::Points line{{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.2, 0.0, 0.0},
                          {0.3, 0.0, 0.0}, {0.4, 0.0, 0.0}, {0.5, 0.0, 0.0}};
  const auto robot =
      test::manipulator("line", TaskSpace::SE3,
                        test::struts(test::on_circle(0.5, {0.0, 60.0, 120.0, 180.0, 240.0, 300.0}), line));
  EXPECT_FALSE(AnchorMetric(*robot).usable);
  BoundaryDistanceMeter meter(robot);
  EXPECT_EQ(
      meter.measure(turned_pose({0.0, 0.0, 0.6}, 0.0, Eigen::Vector3d::UnitZ()), working_modes(*robot)[0])
          .status,
      ConfigurationStatus::invalid);
}

}  // namespace
}  // namespace parallel_aspects
