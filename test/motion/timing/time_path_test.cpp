// SPDX-License-Identifier: BSD-3-Clause
#include "motion/timing/timed_robots.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/motion/plan_path.h"

#include <gtest/gtest.h>

#include "support/path_samples.h"
#include "support/robots/robots.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::accelerations_of;
using test::between;
using test::JointWaypoints;
using test::Motion;
using test::Robot;
using test::speeds_of;
using test::with_speeds;

void expect_within_limits(const Manipulator& robot, const JointWaypoints& waypoints) {
  const JointVector speeds = speeds_of(robot), accelerations = accelerations_of(robot);
  double fastest = 0.0, sharpest = 0.0;
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
    ASSERT_LT(waypoints[i].time, waypoints[i + 1].time);
    for (int k = 0; k <= 20; ++k) {
      const Motion motion = between(waypoints[i], waypoints[i + 1], k / 20.0);
      fastest = std::max(fastest, motion.velocity.cwiseAbs().cwiseQuotient(speeds).maxCoeff());
      sharpest = std::max(sharpest, motion.acceleration.cwiseAbs().cwiseQuotient(accelerations).maxCoeff());
    }
  }
  EXPECT_LE(fastest, 1.0);
  EXPECT_LE(sharpest, 1.0);
}

/// The least time in which the curve of the joints between two stops is passed, found anew: over the length
/// of the arc, by bisection at each of many points.
class LeastTime {
 public:
  LeastTime(const Manipulator& robot, const JointWaypoints& waypoints, std::size_t first, std::size_t last)
      : speeds_(speeds_of(robot)), accelerations_(accelerations_of(robot)) {
    const int parts = std::max(4, static_cast<int>(8000 / (last - first)));
    double length = 0.0;
    JointVector at = waypoints[first].q;
    for (std::size_t i = first; i < last; ++i)
      for (int k = 0; k < parts; ++k) {
        const Motion motion = between(waypoints[i], waypoints[i + 1], (k + 0.5) / parts);
        const double speed = motion.velocity.norm();
        length += (motion.q - at).norm();
        at = motion.q;
        const JointVector tangent = motion.velocity / speed;
        points_.push_back(
            {length, tangent,
             (motion.acceleration - tangent * tangent.dot(motion.acceleration)) / (speed * speed)});
      }
  }

  double seconds() const {
    std::vector<double> most(points_.size(), 0.0), taken(points_.size(), 0.0);
    for (std::size_t i = points_.size() - 1; i-- > 0;) most[i] = highest(i, most[i + 1]);
    double time = 0.0;
    taken[0] = std::min(most[0], 2.0 * points_[0].length * range(0, 0.0).second);
    time += 2.0 * points_[0].length / std::sqrt(taken[0]);
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      taken[i + 1] = std::min(most[i + 1], taken[i] + 2.0 * step(i) * range(i, taken[i]).second);
      if (i + 2 == points_.size()) taken[i + 1] = 0.0;
      time += 2.0 * step(i) / (std::sqrt(taken[i]) + std::sqrt(taken[i + 1]));
    }
    return time;
  }

 private:
  struct Point {
    double length;
    JointVector tangent, curvature;
  };

  double step(std::size_t i) const { return points_[i + 1].length - points_[i].length; }

  std::pair<double, double> range(std::size_t i, double x) const {
    double least = -std::numeric_limits<double>::infinity(), most = -least;
    for (Eigen::Index j = 0; j < speeds_.size(); ++j) {
      const double bent = points_[i].curvature[j] * x, factor = points_[i].tangent[j];
      const double one = (-accelerations_[j] - bent) / factor, other = (accelerations_[j] - bent) / factor;
      if (factor == 0.0) continue;
      least = std::max(least, std::min(one, other));
      most = std::min(most, std::max(one, other));
    }
    return {least, most};
  }

  double highest(std::size_t i, double next) const {
    double low = 0.0, high = std::numeric_limits<double>::infinity();
    for (Eigen::Index j = 0; j < speeds_.size(); ++j)
      high = std::min(high, std::pow(speeds_[j] / std::abs(points_[i].tangent[j]), 2.0));
    for (int k = 0; k < 60; ++k) {
      const double x = k == 0 ? high : 0.5 * (low + high);
      const auto [least, most] = range(i, x);
      (least <= most && x + 2.0 * step(i) * least <= next ? low : high) = x;
      if (low == high) break;
    }
    return low;
  }

  JointVector speeds_, accelerations_;
  std::vector<Point> points_;
};

/// Between all waypoints at rest.
double least_time(const Manipulator& robot, const JointWaypoints& waypoints) {
  double seconds = 0.0;
  for (std::size_t first = 0, i = 1; i < waypoints.size(); ++i) {
    if (!waypoints[i].velocity.isZero(0.0)) continue;
    seconds += LeastTime(robot, waypoints, first, i).seconds();
    first = i;
  }
  return seconds;
}

void expect_good(const Manipulator& robot, const PlannedPath& path, const TimedPath& timed) {
  ASSERT_TRUE(timed) << timed.message;
  EXPECT_EQ(timed.check.answer, TrajectoryAnswer::safe) << timed.check.reason;
  EXPECT_EQ(timed.check.crossings.size(), path.crossings.size());
  const JointWaypoints& waypoints = timed.waypoints;
  EXPECT_LT((waypoints.front().q - path.points.front().q).norm(), 1e-12);
  EXPECT_LT((waypoints.back().q - path.points.back().q).norm(), 1e-9);
  EXPECT_TRUE(waypoints.front().velocity.isZero(0.0) && waypoints.back().velocity.isZero(0.0));
  EXPECT_EQ(timed.seconds, waypoints.back().time);
  expect_within_limits(robot, waypoints);
  if (waypoints.size() < 3) return;
  const double least = least_time(robot, waypoints);
  EXPECT_LE(timed.seconds, 1.02 * least);
  EXPECT_GE(timed.seconds, 0.98 * least);
}

struct Case {
  const char* name;
  Robot robot;
  std::optional<double> resolution;
  int pairs;
};

class TimePathOf : public testing::TestWithParam<Case> {};

TEST_P(TimePathOf, KeepsLimitsInNearlyTheLeastTime) {
  if (test::is_sanitized && GetParam().resolution == 1.0) GTEST_SKIP() << "its map takes long";
  const Robot robot = with_speeds(GetParam().robot);
  MapOptions options;
  options.resolution = GetParam().resolution;
  const auto map = test::map_of(robot, options);
  PathPlanner planner(map);
  const SegmentCertifier certifier(robot);
  const auto pose_on = [&planner](const Pose& a, const Pose& b, double t) {
    return planner.between(a, b, t);
  };
  int found = 0;
  for (int i = 0; i < test::thinned(GetParam().pairs); ++i) {
    std::mt19937_64 random(static_cast<unsigned>(i));
    const PathEnd from = test::random_path_end(*map, test::random_aspect(*map, random), random),
                  to = test::random_path_end(*map, test::random_aspect(*map, random), random);
    const PlannedPath path = planner.plan(from, to, PathPolicy::serial);
    if (!path) continue;
    SCOPED_TRACE("pair " + std::to_string(i));
    const TimedPath timed = time_path(certifier, path, pose_on, accelerations_of(*robot));
    expect_good(*robot, path, timed);
    ++found;
  }
  EXPECT_GT(found, test::is_sanitized ? -1 : 0);
}

INSTANTIATE_TEST_SUITE_P(Robots, TimePathOf,
                         testing::Values(Case{"five_bar", test::five_bar(), std::nullopt, 60},
                                         Case{"bipod", test::bipod(), std::nullopt, 20},
                                         Case{"three_rpr", test::three_rpr(), 1.5, 20},
                                         Case{"three_rrr", test::three_rrr(), 1.0, 10},
                                         Case{"delta", test::delta(), 0.3, 10}),
                         [](const auto& each) { return std::string(each.param.name); });

// The change of the assembly mode whose first strut is held: it stands still but for rounding.
TEST(TimePath, StaysInASlice) {
  const Robot robot = with_speeds(test::three_rpr());
  MapOptions options;
  options.slice = test::slice_of(robot, {{robot->leg(0).actuated_joint, 14.98}});
  const auto map = test::map_of(robot, options);
  const auto on_slice = [&map, &robot](double x, double y, double phi) {
    return PathEnd{circle_of_anchor(*robot, *map->slice()->joint).nearest(Pose::planar(x, y, phi)), {}};
  };
  PathPlanner planner(map);
  const PlannedPath path = planner.plan(on_slice(14.67394366, -3.01260312, 2.13290437),
                                        on_slice(-5.49566082, -13.93549828, -0.04733137), PathPolicy::stay);
  ASSERT_TRUE(path) << path.message;
  const TimedPath timed = time_path(
      SegmentCertifier(robot), path,
      [&planner](const Pose& a, const Pose& b, double t) { return planner.between(a, b, t); },
      accelerations_of(*robot));
  expect_good(*robot, path, timed);
  for (const JointWaypoint& waypoint : timed.waypoints) EXPECT_NEAR(waypoint.q[0], 14.98, 1e-9);
}

TEST(TimePath, TimesPathsOverARoadmap) {
  const Robot robot = with_speeds(test::hexa());
  const auto mode = working_modes(*robot).front();
  RoadmapOptions options;
  options.samples = 200;
  options.modes = {mode};
  const auto roadmap = compute_pose_roadmap(robot, options).roadmap;
  ASSERT_TRUE(roadmap);
  std::mt19937_64 random(1);
  int found = 0;
  for (int i = 0; i < test::thinned(20); ++i) {
    const auto& poses = roadmap->poses();
    const PathEnd from{poses[random() % poses.size()], mode}, to{poses[random() % poses.size()], mode};
    const PlannedPath path = plan_in_roadmap(*roadmap, from, to);
    if (!path) continue;
    SCOPED_TRACE("pair " + std::to_string(i));
    expect_good(
        *robot, path,
        time_path(SegmentCertifier(robot), path, between_poses(TaskSpace::SE3), accelerations_of(*robot)));
    ++found;
  }
  EXPECT_GT(found, test::is_sanitized ? -1 : 0);
}

/// A path of the five-bar between two poses in its first working mode.
PlannedPath path_of(const Robot& robot, const std::vector<Pose>& poses) {
  PlannedPath path;
  path.answer = SameAspect::yes;
  for (const Pose& pose : poses) {
    const WorkingMode mode = working_modes(*robot).front();
    path.points.push_back({pose, mode, inverse(*robot, pose, mode).q});
  }
  return path;
}

// With one joint moving, the time is known in closed form: at the acceleration limit up to the speed limit,
// and down again.
TEST(TimePath, IsTheTrapezoidOfASingleJoint) {
  ManipulatorDescription description = test::bipod()->description();
  for (Leg& leg : description.legs) leg.limits.velocity = 1e3;
  description.legs[0].limits.velocity = 2.0;
  const Robot robot = std::make_shared<const Manipulator>(description);
  const Pose from = Pose::planar(1.0, 4.0), to = Pose::planar(1.2, 5.2);
  const double distance = to.position.norm() - from.position.norm();  // the first strut begins at the origin
  JointVector accelerations(2);
  accelerations << 5.0, 1e6;
  const TimedPath timed = time_path(SegmentCertifier(robot), path_of(robot, {from, to}),
                                    between_poses(TaskSpace::SE3), accelerations);
  ASSERT_TRUE(timed) << timed.message;
  const double least =
      distance > 2.0 * 2.0 / 5.0 ? distance / 2.0 + 2.0 / 5.0 : 2.0 * std::sqrt(distance / 5.0);
  EXPECT_GE(timed.seconds, least * (1.0 - 1e-9));
  EXPECT_LE(timed.seconds, 1.01 * least);
}

/// The five-bar whose joints have just the room that a trajectory needs, and this much more [rad].
Robot with_room(const Robot& robot, const JointWaypoints& waypoints, double more) {
  ManipulatorDescription description = robot->description();
  for (std::size_t j = 0; j < robot->leg_count(); ++j) {
    JointLimits& limits = description.legs[j].limits;
    limits.lower = std::numeric_limits<double>::infinity();
    limits.upper = -limits.lower;
    for (std::size_t i = 0; i + 1 < waypoints.size(); ++i)
      for (int k = 0; k <= 100; ++k) {
        const double q = between(waypoints[i], waypoints[i + 1], k / 100.0).q[static_cast<Eigen::Index>(j)];
        limits.lower = std::min(limits.lower, q - more);
        limits.upper = std::max(limits.upper, q + more);
      }
  }
  return std::make_shared<const Manipulator>(description);
}

// Where one leg passes B_jj = 0 the joint of the other turns back: if it passes its limit, then there.
TEST(TimePath, KeepsJointLimitsWhereALegPassesAGate) {
  const Robot robot = with_speeds(test::five_bar());
  PathPlanner planner(test::map_of(robot, {}));
  const PathEnd from{Pose::planar(4.5, 8.0), WorkingMode::from_signs({1, 1})},
      to{Pose::planar(4.5, -8.0), WorkingMode::from_signs({-1, 1})};
  const PlannedPath path = planner.plan(from, to, PathPolicy::serial);
  const TimedPath timed =
      time_path(SegmentCertifier(robot), path, between_poses(TaskSpace::SE3), accelerations_of(*robot));
  expect_good(*robot, path, timed);
  TrajectoryStart start;
  start.pose = from.pose;
  TrajectoryCheckOptions options;
  EXPECT_EQ(check_trajectory(SegmentCertifier(robot), timed.waypoints, start, options).answer,
            TrajectoryAnswer::unsafe);
  options.pass_serial = true;
  for (const double more : {1e-4, -1e-4, -1e-7}) {
    const SegmentCertifier certifier(with_room(robot, timed.waypoints, more));
    EXPECT_EQ(check_trajectory(certifier, timed.waypoints, start, options).answer == TrajectoryAnswer::safe,
              more > 0.0)
        << more;
  }
}

TEST(TimePath, IsOneWaypointWhereNothingMoves) {
  const Robot robot = with_speeds(test::five_bar());
  const TimedPath timed = time_path(SegmentCertifier(robot), path_of(robot, {Pose::planar(4.5, 8.0)}),
                                    between_poses(TaskSpace::SE3), accelerations_of(*robot));
  ASSERT_EQ(timed.waypoints.size(), 1U);
  EXPECT_EQ(timed.seconds, 0.0);
}

TEST(TimePath, EndsWhereItIsCancelled) {
  const Robot robot = with_speeds(test::five_bar());
  const std::atomic<bool> cancelled(true);
  MapControl control;
  control.cancelled = &cancelled;
  const TimedPath timed =
      time_path(SegmentCertifier(robot), path_of(robot, {Pose::planar(4.5, 8.0), Pose::planar(4.0, 7.5)}),
                between_poses(TaskSpace::SE3), accelerations_of(*robot), control);
  EXPECT_FALSE(timed);
  EXPECT_EQ(timed.message, "Cancelled.");
}

// What is not proved is not returned: a segment that a caller made up, through det A = 0.
TEST(TimePath, RefusesAPathThatIsNotFree) {
  const Robot robot = with_speeds(test::five_bar());
  const TimedPath timed =
      time_path(SegmentCertifier(robot), path_of(robot, {Pose::planar(4.5, 8.0), Pose::planar(4.5, -8.0)}),
                between_poses(TaskSpace::SE3), accelerations_of(*robot));
  EXPECT_FALSE(timed);
  EXPECT_NE(timed.message.find("No trajectory"), std::string::npos) << timed.message;
}

TEST(TimePath, SaysWhatLimitsAreMissing) {
  const Robot robot = test::five_bar();
  const JointVector good = JointVector::Constant(2, 1.0);
  ASSERT_EQ(problems_of(*robot, good).size(), 2U);
  EXPECT_NE(problems_of(*robot, good).front().find("'leg_1_joint' has no velocity limit"), std::string::npos);
  const Robot fast = with_speeds(robot);
  EXPECT_TRUE(problems_of(*fast, good).empty());
  const double bad[] = {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()};
  for (const double value : bad)
    EXPECT_EQ(problems_of(*fast, JointVector::Constant(2, value)).size(), 1U) << value;
  EXPECT_EQ(problems_of(*fast, JointVector()).size(), 1U);
  EXPECT_EQ(problems_of(*fast, JointVector::Constant(3, 1.0)).size(), 1U);
}

}  // namespace
}  // namespace parallel_aspects
