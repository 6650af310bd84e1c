// SPDX-License-Identifier: BSD-3-Clause
#include "motion/choose/plan_around_cusp.h"

#include "parallel_aspects/aspects/held_joint.h"
#include "parallel_aspects/kinematics/direct.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/tracking/tracker.h"

#include <gtest/gtest.h>

#include "support/robots.h"
#include "support/slices.h"
#include <cmath>
#include <cstddef>
#include <memory>
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
    const CuspList list = find_cusps(*robot_, *options.slice);
    EXPECT_TRUE(list.complete);
    cusps_ = list.cusps;
  }

  /// All of them, of the region with six.
  std::vector<AssemblyMode> starts() const { return direct(*robot_, q_).solutions; }

  static TrackerOptions exact() {
    TrackerOptions options;
    options.samples.encoder_noise = 0.0;  // ways around a cusp are narrow
    return options;
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

  const Robot robot_ = test::three_rpr()->with_constraints({});
  const JointVector q_ = Eigen::Vector3d(held, 15.38, 12.0);
  std::shared_ptr<const AspectMap> map_;
  std::vector<Cusp> cusps_;
};

// Told by the tracker from the actuated values alone; or, nearest to a cusp, it says that it is lost.
TEST_F(AroundCusp, ChangesTheAssemblyModeAndIsTold) {
  ASSERT_EQ(cusps_.size(), 6U);
  CuspPlanner planner(map_, cusps_);
  std::set<std::size_t> changed;
  for (std::size_t cusp = 0; cusp < cusps_.size(); ++cusp)
    for (const AssemblyMode& start : starts()) {
      const Pose from = circle_of_anchor(*robot_, *map_->slice()->joint).nearest(start.pose);
      const PlannedPath path = planner.plan({from, {}}, cusp);
      if (!path) continue;
      SCOPED_TRACE("cusp " + std::to_string(cusp + 1) + ", least index " + std::to_string(path.least_index));
      EXPECT_NE(planner.turns_around_cusps(path)[cusp], 0);
      const std::vector<JointVector> values = values_along(planner, path);
      EXPECT_LT((values.back() - q_).norm(), 1e-6);
      EXPECT_GT((path.points.back().pose.position - from.position).norm(), 1.0);
      Tracker tracker(robot_, exact());
      ASSERT_TRUE(tracker.start_near(0.0, q_, from, 1e-6 * robot_->size()));
      const std::vector<Transition> told = played(tracker, values);
      ASSERT_EQ(told.size(), 1U);
      if (told.front().kind == TransitionKind::lost) continue;
      EXPECT_EQ(told.front().kind, TransitionKind::assembly_mode);
      EXPECT_TRUE(told.front().inside_aspect);
      EXPECT_LT((tracker.state().pose.position - path.points.back().pose.position).norm(), 1e-5);
      changed.insert(cusp);
      break;
    }
  EXPECT_GE(changed.size(), 4U);
}

// A circle in the plane of the actuated values, played for each of the six.
TEST_F(AroundCusp, ComesBackToTheSamePoseAroundNone) {
  std::vector<JointVector> values;
  for (int i = 0; i <= 2000; ++i) {
    const double angle = 2.0 * EIGEN_PI * i / 2000.0;
    values.push_back(q_ + 0.3 * Eigen::Vector3d(0.0, std::cos(angle) - 1.0, std::sin(angle)));
  }
  for (const AssemblyMode& start : starts()) {
    Tracker tracker(robot_, exact());
    ASSERT_TRUE(tracker.start_near(0.0, q_, start.pose, 1e-6 * robot_->size()));
    EXPECT_TRUE(played(tracker, values).empty());
    EXPECT_LT((tracker.state().pose.position - start.pose.position).norm(), 1e-6);
    EXPECT_EQ(tracker.compare_with_reference(), AssemblyComparison::same);
  }
}

TEST_F(AroundCusp, IsNotPlannedWhereTheStartIsInNoAspect) {
  CuspPlanner planner(map_, cusps_);
  const PlannedPath path = planner.plan({Pose::planar(1e3, 0.0, 0.0), {}}, 0);
  EXPECT_FALSE(path);
  EXPECT_FALSE(path.message.empty());
}

}  // namespace
}  // namespace parallel_aspects
