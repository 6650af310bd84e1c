// SPDX-License-Identifier: BSD-3-Clause
#include "motion/choose/plan_around_cusp.h"

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/tracking/tracker.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::Robot;

/// The 3-RPR of Innocenti and Parenti-Castelli without limits, its first strut held.
class AroundCusp : public testing::Test {
 protected:
  static constexpr double held = 14.98;

  AroundCusp() {
    MapOptions options;
    options.slice = test::slice_of(robot_, {{robot_->leg(0).actuated_joint, held}});
    map_ = compute_aspect_map(robot_, options).map;
    const CuspList list = find_cusps(*robot_, *options.slice->joint);
    EXPECT_TRUE(list.complete);
    cusps_ = list.cusps;
  }

  /// All of them, of the region with six.
  std::vector<AssemblyMode> starts() const { return direct(*robot_, q_).solutions; }

  static TrackerOptions with_noise(double noise) {
    TrackerOptions options;
    options.samples.encoder_noise = noise;
    return options;
  }

  /// What encoders that are off by so much say, by chance.
  std::vector<JointVector> noisy(std::vector<JointVector> values, double noise) {
    std::uniform_real_distribution<double> off(-noise * robot_->size(), noise * robot_->size());
    for (JointVector& q : values)
      for (Eigen::Index j = 0; j < q.size(); ++j) q[j] += off(random_);
    return values;
  }

  /// What the tracker tells on the way that is given by the actuated values alone; up to where it is lost.
  static std::vector<Transition> played(Tracker& tracker, const std::vector<JointVector>& values) {
    std::vector<Transition> told;
    double time = 0.0;
    for (const JointVector& q : values) {
      tracker.update(time += 1e-3, q);
      for (const Transition& each : tracker.transitions()) told.push_back(each);
      if (!told.empty() && told.back().kind == TransitionKind::lost) break;
    }
    return told;
  }

  std::vector<JointVector> values_along(const CuspPlanner& planner, const PlannedPath& path) const {
    constexpr int steps = 2000;
    std::vector<JointVector> values;
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
      for (int k = 1; k <= steps; ++k) {
        const Pose pose = planner.between(path.points[i].pose, path.points[i + 1].pose, k / double(steps));
        values.push_back(inverse(*robot_, pose, path.points[i].mode).q);
      }
    return values;
  }

  /// Whether the tracker tells, from the actuated values alone and no more than once, that the platform is at
  /// the end of the path.
  bool is_told(const CuspPlanner& planner, const PlannedPath& path, double noise) {
    Tracker tracker(robot_, with_noise(noise));
    const Pose& from = path.points.front().pose;
    if (!tracker.start_near(0.0, q_, from, 1e-6 * robot_->size())) return false;
    const std::vector<Transition> told = played(tracker, noisy(values_along(planner, path), noise));
    if (told.size() != 1 || told.front().kind != TransitionKind::assembly_mode) return false;
    EXPECT_TRUE(told.front().inside_aspect);
    EXPECT_LT((tracker.state().pose.position - path.points.back().pose.position).norm(), 0.5);
    return true;
  }

  const Robot robot_ = test::three_rpr()->with_constraints({});
  const JointVector q_ = Eigen::Vector3d(held, 15.38, 12.0);
  std::shared_ptr<const AspectMap> map_;
  std::vector<Cusp> cusps_;
  std::mt19937 random_{1};
};

// With the noise that each is said to be followed with, and no more than that of the tracker.
TEST_F(AroundCusp, ChangesTheAssemblyModeAndIsReported) {
  ASSERT_EQ(cusps_.size(), 6U);
  const double usual = SampleOptions().encoder_noise;
  const CuspPlanner planner(map_, cusps_);
  std::set<std::size_t> changed;
  int paths = 0;
  for (std::size_t cusp = 0; cusp < cusps_.size(); ++cusp)
    for (const AssemblyMode& start : starts()) {
      const Pose from = circle_of_anchor(*robot_, *map_->slice()->joint).nearest(start.pose);
      const PlannedPath path = planner.plan({from, {}}, cusp);
      if (!path) continue;
      const double noise = planner.followed_noise(path);
      SCOPED_TRACE("cusp " + std::to_string(cusp + 1) + ", noise " + std::to_string(noise));
      ++paths;
      EXPECT_NE(planner.turns_around_cusps(path)[cusp], 0);
      EXPECT_GT(noise, 0.0);
      EXPECT_LT((path.points.back().q - q_).norm(), 1e-5);
      EXPECT_GT((path.points.back().pose.position - from.position).norm(), 1.0);
      EXPECT_TRUE(is_told(planner, path, std::min(noise, usual)));
      if (noise >= usual) changed.insert(cusp);
    }
  EXPECT_GE(paths, 34);
  EXPECT_EQ(changed, (std::set<std::size_t>{1, 2, 3, 4, 5}));
}

// What a path has and what it lacks: with ten times the noise that it is said to be followed with, it is not.
TEST_F(AroundCusp, IsLostWithFarMoreNoiseThanItIsSaidToBeFollowedWith) {
  const CuspPlanner planner(map_, cusps_);
  for (const AssemblyMode& start : starts()) {
    const Pose from = circle_of_anchor(*robot_, *map_->slice()->joint).nearest(start.pose);
    const PlannedPath path = planner.plan({from, {}}, 0);
    if (!path) continue;
    EXPECT_FALSE(is_told(planner, path, 10.0 * planner.followed_noise(path)));
  }
}

// A circle in the plane of the actuated values, played for each of the six.
TEST_F(AroundCusp, ComesBackToTheSamePoseAroundNone) {
  std::vector<JointVector> values;
  for (int i = 0; i <= 2000; ++i) {
    const double angle = 2.0 * EIGEN_PI * i / 2000.0;
    values.push_back(q_ + 0.3 * Eigen::Vector3d(0.0, std::cos(angle) - 1.0, std::sin(angle)));
  }
  for (const AssemblyMode& start : starts()) {
    Tracker tracker(robot_, with_noise(0.0));
    ASSERT_TRUE(tracker.start_near(0.0, q_, start.pose, 1e-6 * robot_->size()));
    EXPECT_TRUE(played(tracker, values).empty());
    EXPECT_LT((tracker.state().pose.position - start.pose.position).norm(), 1e-6);
    EXPECT_EQ(tracker.compare_with_reference(), AssemblyComparison::same);
  }
}

// In the component that the list of cusps names, too.
TEST_F(AroundCusp, HasAStartInTheComponentOfEachCusp) {
  const CuspPlanner planner(map_, cusps_);
  const auto listed = compute_uniqueness(map_).uniqueness->cusps;
  ASSERT_EQ(listed.size(), cusps_.size());
  for (std::size_t cusp = 0; cusp < cusps_.size(); ++cusp) {
    const CuspStart start = planner.find_start(cusp);
    ASSERT_TRUE(start.point) << cusp;
    EXPECT_EQ(start.aspect, listed[cusp].aspect);
    EXPECT_EQ(map_->locate(start.point->pose, start.point->mode).aspect, start.aspect);
    const PlannedPath path = planner.plan({start.point->pose, start.point->mode}, cusp);
    ASSERT_TRUE(path) << path.message;
    EXPECT_NE(planner.turns_around_cusps(path)[cusp], 0);
  }
}

// Where the platform is says nothing of the posture of the legs.
TEST(AroundCuspOfCranks, IsNotPlannedFromAnotherWorkingMode) {
  const Robot robot = test::three_rrr()->with_constraints({});
  MapOptions options;
  options.slice = test::slice_of(robot, {{robot->leg(0).actuated_joint, 0.3}});
  const auto map = compute_aspect_map(robot, options).map;
  const CuspPlanner planner(map, find_cusps(*robot, *options.slice->joint).cusps);
  const CuspStart start = planner.find_start(0);
  ASSERT_TRUE(start.point);
  const WorkingMode mode = start.point->mode;
  EXPECT_TRUE(planner.plan({start.point->pose, {}}, 0));
  EXPECT_TRUE(planner.plan({start.point->pose, mode}, 0));
  WorkingMode other = mode;
  other.set_sign(1, -mode.sign(1));
  const PlannedPath path = planner.plan({start.point->pose, other}, 0);
  EXPECT_FALSE(path);
  EXPECT_NE(path.message.find("the start is in " + to_string(other)), std::string::npos) << path.message;
}

TEST_F(AroundCusp, IsNotPlannedWhereTheStartIsInNoAspect) {
  CuspPlanner planner(map_, cusps_);
  const PlannedPath path = planner.plan({Pose::planar(1e3, 0.0, 0.0), {}}, 0);
  EXPECT_FALSE(path);
  EXPECT_FALSE(path.message.empty());
}

}  // namespace
}  // namespace parallel_aspects
