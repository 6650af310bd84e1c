// SPDX-License-Identifier: BSD-3-Clause
//
// What is proved to be clear holds no pose of the hazard: random poses are tried, by the kinematics alone.
#include "motion/guard/clear_region.h"

#include "interval/interval.h"
#include "parallel_aspects/model/manipulator.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <cmath>
#include <string>

namespace parallel_aspects {
namespace {

class ClearRegions : public testing::TestWithParam<std::string> {
 protected:
  const std::shared_ptr<const Manipulator> robot_ = test::shipped(GetParam())->manipulator();
  const std::unique_ptr<ClearRegion> region_ = make_clear_region(robot_);
  test::PosePairs random_{robot_, 7};
  const Eigen::Index size_ = static_cast<Eigen::Index>(robot_->leg_count());

  TaskVector random_twist() {
    TaskVector twist(size_);
    for (Eigen::Index i = 0; i < size_; ++i) twist[i] = random_.uniform(-1.0, 1.0);
    return twist;
  }

  MetricSpeed speed_of(const TaskVector& twist) const {
    const RoundingUpward upward;
    return region_->speed_of(twist);
  }
  void move_to(const Pose& pose, const WorkingMode& mode) const {
    const RoundingUpward upward;
    region_->move_to(pose, mode);
  }
};

// The metric by anchors, and a twist in small steps.
TEST_P(ClearRegions, RatesAreThoseOfTheMetric) {
  const WorkingMode mode = random_.mode();
  for (int i = 0; i < 20; ++i) {
    const Pose pose = *random_.reached(mode);
    move_to(pose, mode);
    const TaskVector twist = random_twist();
    const MetricSpeed speed = speed_of(twist);
    const double h = 1e-5;
    const Pose after = displaced(robot_->motions(), pose, h * twist);
    EXPECT_NEAR(anchor_distance(*robot_, pose, after) / h, speed.rate.norm(), 1e-3 * speed.rate.norm());
    EXPECT_GE(speed.path, speed.rate.norm() * (1.0 - 1e-9));
    Pose moved = pose;
    double path = 0.0;
    for (int k = 0; k < 100; ++k) {
      const Pose next = displaced(robot_->motions(), moved, 0.01 * twist);
      path += anchor_distance(*robot_, moved, next);
      moved = next;
    }
    EXPECT_LE(path, speed.path * (1.0 + 1e-9));
  }
}

// Behind the half space of det A there may be anything; before it det A keeps its sign, as far as legs reach.
TEST_P(ClearRegions, NoSignChangesInAClearHalfSpace) {
  const WorkingMode mode = random_.mode();
  int tried = 0, bounded = 0;
  for (int i = 0; i < test::thinned(200); ++i) {
    const Pose pose = *random_.reached(mode);
    const int sign = test::sign_in_doubles(*robot_, pose, mode);
    const double radius = std::pow(10.0, random_.uniform(-3.0, -0.7)) * robot_->size();
    ClearHalfSpaces clear;
    {
      const RoundingUpward upward;
      region_->move_to(pose, mode);
      clear = region_->find(Hazard::parallel_singularity, radius);
    }
    ASSERT_EQ(clear.count, 1U);
    const ClearHalfSpace& half_space = clear.list[0];
    bounded += half_space.clearance > 0.0;
    for (int k = 0; k < 30; ++k) {
      const TaskVector twist = random_twist();
      const double reach = random_.uniform(0.0, 0.9) * radius / speed_of(twist).path;
      const Pose other = displaced(robot_->motions(), pose, reach * twist);
      const int there = test::sign_in_doubles(*robot_, other, mode);
      // Coordinates of the pose to first order; the bend bounds what that is off by.
      const double turned = reach * speed_of(twist).turn;
      const double value = half_space.clearance + reach * half_space.normal.dot(speed_of(twist).rate);
      if (there == 0 || !(value > region_->bend(turned))) continue;
      ++tried;
      EXPECT_EQ(there, sign) << to_string(robot_->task_space(), pose) << " to "
                             << to_string(robot_->task_space(), other) << " in " << to_string(mode);
    }
  }
  EXPECT_GT(tried, 50);
  EXPECT_GT(bounded, 5);
}

TEST_P(ClearRegions, NoSignChangesInAClearHalfBall) {
  const WorkingMode mode = random_.mode();
  int clear = 0;
  for (int i = 0; i < test::thinned(500); ++i) {
    const Pose pose = *random_.reached(mode);
    const int sign = test::sign_in_doubles(*robot_, pose, mode);
    const double radius = std::pow(10.0, random_.uniform(-3.0, -0.7)) * robot_->size();
    move_to(pose, mode);
    const TaskVector ahead = speed_of(random_twist()).rate.normalized();
    {
      const RoundingUpward upward;
      if (!region_->is_ahead_clear(Hazard::parallel_singularity, ahead, radius)) continue;
    }
    ++clear;
    for (int k = 0; k < 30; ++k) {
      const TaskVector twist = random_twist();
      const MetricSpeed speed = speed_of(twist);
      const double reach = random_.uniform(0.0, 0.9) * radius / speed.path;
      if (!(reach * speed.rate.dot(ahead) > region_->bend(reach * speed.turn))) continue;
      const Pose other = displaced(robot_->motions(), pose, reach * twist);
      const int there = test::sign_in_doubles(*robot_, other, mode);
      EXPECT_TRUE(there == 0 || there == sign)
          << to_string(robot_->task_space(), pose) << " to " << to_string(robot_->task_space(), other);
    }
  }
  EXPECT_TRUE(clear > 5 || robot_->leg_count() == 6) << clear;
}

TEST_P(ClearRegions, DistancesAreAtMostDistorted) {
  const WorkingMode mode = random_.mode();
  for (int i = 0; i < 300; ++i) {
    const Pose pose = *random_.reached(mode);
    move_to(pose, mode);
    const double radius = std::pow(10.0, random_.uniform(-3.0, -0.5)) * robot_->size();
    const TaskVector a = random_twist(), b = random_twist();
    const MetricSpeed one = speed_of(a), other = speed_of(b);
    const double s = random_.uniform(0.0, 1.0) * radius / one.path,
                 t = random_.uniform(0.0, 1.0) * radius / other.path;
    const double off = region_->bend(s * one.turn) + region_->bend(t * other.turn);
    const double straight = (s * one.rate - t * other.rate).norm();
    const double distance = anchor_distance(*robot_, displaced(robot_->motions(), pose, s * a),
                                            displaced(robot_->motions(), pose, t * b));
    EXPECT_GE(distance, (1.0 - region_->distortion(radius)) * (straight - off) - 1e-9 * radius);
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, ClearRegions,
                         testing::Values("five_bar", "three_rpr", "three_rrr", "delta", "linear_delta",
                                         "spherical_3rrr", "stewart", "hexa"),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace parallel_aspects
