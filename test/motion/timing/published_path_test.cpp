// SPDX-License-Identifier: BSD-3-Clause
//
// A published example of another planner: the 3-RPR of Innocenti and Parenti-Castelli with its first strut
// held at 14.98 changes its assembly mode and keeps |det A| at 20,000 or more.
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/motion/plan_path.h"
#include "parallel_aspects/tracking/tracker.h"

#include <gtest/gtest.h>

#include "support/campaign_figures.h"
#include "support/index_at.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double held = 14.98, least_det_a = 20000.0;

/// The shipped robot, whose struts go up to 40 in place of 32.
test::Robot robot_with_long_struts() {
  std::string urdf = test::source_file("urdf/three_rpr.urdf");
  const std::string shipped = "upper=\"32\"", wanted = "upper=\"40\"";
  for (std::size_t at = urdf.find(shipped); at != std::string::npos; at = urdf.find(shipped, at))
    urdf.replace(at, shipped.size(), wanted);
  return load_mechanism(urdf, "three_rpr.urdf", test::source_file("config/robots/three_rpr.yaml"),
                        "three_rpr.yaml")
      ->mapped_manipulator()
      ->with_margins({0.0, 0.0, least_det_a});
}

/// What joint_trajectory_controller commands: cubics, and the last point behind the end.
JointVector joints_at(const std::vector<JointWaypoint>& waypoints, double time) {
  std::size_t i = 1;
  while (i + 1 < waypoints.size() && waypoints[i].time < time) ++i;
  const JointWaypoint &from = waypoints[i - 1], &to = waypoints[i];
  const double h = to.time - from.time, s = std::min(1.0, (time - from.time) / h);
  const JointVector rise = to.q - from.q, begin = h * from.velocity, end = h * to.velocity;
  return from.q + s * (begin + s * (3.0 * rise - 2.0 * begin - end + s * (begin + end - 2.0 * rise)));
}

class PublishedPath : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    robot_ = robot_with_long_struts();
    MapOptions options;
    options.slice = test::slice_of(robot_, {{"strut_1_joint", held}});
    map_ = test::map_of(robot_, options);
  }
  static void TearDownTestSuite() {
    map_.reset();
    robot_.reset();
  }

  static PathEnd end(double x, double y, double phi) {
    return {circle_of_anchor(*robot_, *map_->slice()->joint).nearest(Pose::planar(x, y, phi)), {}};
  }
  static PathEnd from() { return end(14.67394366, -3.01260312, 2.13290437); }
  static PathEnd to() { return end(-5.49566082, -13.93549828, -0.04733137); }

  static TimedPath timed(const PathPlanner& planner, const PlannedPath& path) {
    return time_path(
        SegmentCertifier(robot_), path,
        [&planner](const Pose& a, const Pose& b, double t) { return planner.between(a, b, t); },
        JointVector::Constant(3, 250.0));
  }

  static test::Robot robot_;
  static std::shared_ptr<const AspectMap> map_;
};

test::Robot PublishedPath::robot_;
std::shared_ptr<const AspectMap> PublishedPath::map_;

// With the map at hand, in a new planner, so that nothing is known from other questions.
TEST_F(PublishedPath, IsFoundInLessThan50Milliseconds) {
  double least = 1e9;
  for (int i = 0; i < 3; ++i) {
    PathPlanner planner(map_);
    const test::Stopwatch stopwatch;
    const PlannedPath path = planner.plan(from(), to(), PathPolicy::stay);
    least = std::min(least, stopwatch.seconds());
    ASSERT_TRUE(path) << path.message;
  }
  EXPECT_LT(least, test::is_sanitized ? 5.0 : 0.05);
}

TEST_F(PublishedPath, KeepsTheDeterminantByFormulasOfTheTest) {
  for (const PathPreference prefer : {PathPreference::shortest, PathPreference::clear}) {
    PathPlanner planner(map_);
    const PlannedPath path = planner.plan(from(), to(), {PathPolicy::stay, prefer, {}});
    ASSERT_TRUE(path) << path.message;
    EXPECT_LT((path.points.front().q - path.points.back().q).norm(), 1e-4);
    const int samples = test::thinned(100000) / static_cast<int>(path.points.size());
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
      for (int k = 0; k <= samples; ++k) {
        const Pose pose =
            planner.between(path.points[i].pose, path.points[i + 1].pose, k / static_cast<double>(samples));
        const test::ConfigurationAt<double> at(*robot_, pose, path.points[i].mode);
        ASSERT_TRUE(at.reaches() && at.within_limits() >= 0.0) << "segment " << i << ", sample " << k;
        JointVector q(3);
        for (Eigen::Index j = 0; j < 3; ++j) {
          const Leg& leg = robot_->leg(static_cast<std::size_t>(j));
          q[j] = (pose.transform(leg.anchor) - leg.base_point()).norm();
        }
        ASSERT_NEAR(q[0], held, 1e-9);
        ASSERT_GE(static_cast<double>(test::IndexAt(*robot_, pose, q).determinant()),
                  least_det_a * (1.0 - 1e-12))
            << "segment " << i << ", sample " << k;
      }
  }
}

TEST_F(PublishedPath, IsTimedAndSeenByTheTracker) {
  PathPlanner planner(map_);
  const PlannedPath path = planner.plan(from(), to(), PathPolicy::stay);
  ASSERT_TRUE(path) << path.message;
  const TimedPath motion = timed(planner, path);
  ASSERT_TRUE(motion) << motion.message;
  EXPECT_EQ(motion.check.answer, TrajectoryAnswer::safe);
  EXPECT_LE(test::limits_taken(*robot_, motion.waypoints, JointVector::Constant(3, 250.0)), 1.0);
  for (const JointWaypoint& waypoint : motion.waypoints) EXPECT_NEAR(waypoint.q[0], held, 1e-9);

  TrackerOptions options;
  options.samples.encoder_noise = 1e-5;  // with 1e-4 of this robot's size no step at its narrowest is proved
  Tracker tracker(robot_, options);
  const Pose start = path.points.front().pose;
  ASSERT_TRUE(tracker.start_near(0.0, motion.waypoints.front().q, start, 1e-6 * robot_->size()));
  int changes = 0;
  bool is_followed = true;
  constexpr double period = 0.001;
  for (double time = period; time < motion.seconds + period; time += period) {
    is_followed = tracker.update(time, joints_at(motion.waypoints, time)).followed() && is_followed;
    for (const Transition& each : tracker.transitions())
      changes += each.kind == TransitionKind::assembly_mode ? 1 : 0;
  }
  EXPECT_TRUE(is_followed);
  EXPECT_EQ(changes, 1) << "the actuated joints are back, the platform is elsewhere";
  EXPECT_LT((tracker.state().pose.position - path.points.back().pose.position).norm(), 1e-6);
}

}  // namespace
}  // namespace parallel_aspects
