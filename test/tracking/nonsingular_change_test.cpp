// SPDX-License-Identifier: BSD-3-Clause
// Assembly modes that change without a singularity: what the tracker says of them, while and after.
#include "motion/roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/tracking/tracker.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include <algorithm>
#include <random>
#include <vector>

namespace parallel_aspects {
namespace {

// The 3-RPR of Innocenti and Parenti-Castelli changes its assembly mode without a singularity: of its six
// direct solutions three have det A > 0, all in one aspect.
class NonsingularAssemblyModeChange : public testing::Test {
 protected:
  // The path leads past a cusp, nearer than noise of the encoders would let anybody tell.
  static TrackerOptions exact() {
    TrackerOptions options;
    options.samples.encoder_noise = 0.0;
    return options;
  }

  // Actuated joints along a path from one direct solution to another of the same sign, found at random.
  std::vector<JointVector> find_path() {
    const DirectResult result = direct(*robot_, q_);
    Roadmap roads(*robot_, 2000);  // followed in many samples
    for (const AssemblyMode& mode : result.solutions)
      if (mode.determinant > 0.0) ends_.push_back(roads.add({mode.pose, q_}));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> position(-30.0, 30.0), angle(-EIGEN_PI, EIGEN_PI);
    for (int i = 0; i < 4000; ++i)
      add_place(Pose::planar(position(random), position(random), angle(random)), roads);
    std::vector<JointVector> path;
    for (const std::size_t place : roads.path(ends_[0], ends_[1])) path.push_back(roads.place(place).q);
    from_ = roads.place(ends_[0]).pose;
    to_ = roads.place(ends_[1]).pose;
    return path;
  }

  void add_place(const Pose& pose, Roadmap& roads) const {
    const InverseSolution solution = inverse(*robot_, pose, *WorkingMode::from_signs({1, 1, 1}));
    if (solution.status != InverseStatus::solved) return;
    if (direct_determinant(*robot_, pose, solution.q) > 0.0) roads.add({pose, solution.q});
  }

  // The changes of assembly mode that are detected on the path.
  int follow(const std::vector<JointVector>& path, Tracker& tracker) {
    int told = 0;
    for (std::size_t k = 1; k < path.size(); ++k)
      for (int i = 1; i <= samples_; ++i) {
        tracker.update(time_ += 1e-3, path[k - 1] + (path[k] - path[k - 1]) * i / samples_);
        for (const Transition& each : tracker.transitions()) {
          EXPECT_EQ(each.kind, TransitionKind::assembly_mode);
          EXPECT_TRUE(each.inside_aspect);
          EXPECT_EQ(each.determinant_sign_before, each.determinant_sign_after);
          first_again_ = each.first_again;
          ++told;
        }
      }
    return told;
  }

  const std::shared_ptr<const Manipulator> robot_ = test::three_rpr();
  const JointVector q_ = Eigen::Vector3d(14.98, 15.38, 12.0);
  const int samples_ = 200;
  std::vector<std::size_t> ends_;
  Pose from_, to_;
  double time_ = 0.0;
  bool first_again_ = false;  // of the last change
};

TEST_F(NonsingularAssemblyModeChange, IsReportedWhenTheDrivesAreBack) {
  std::vector<JointVector> path = find_path();
  ASSERT_GE(path.size(), 3U);
  Tracker tracker(robot_, exact());
  ASSERT_TRUE(tracker.start_near(0.0, q_, from_, 1e-6));
  EXPECT_EQ(tracker.compare_with_reference(), AssemblyComparison::same);
  EXPECT_EQ(follow(path, tracker) % 2, 1);
  ASSERT_EQ(tracker.state().status, TrackStatus::tracking);
  EXPECT_LT((tracker.state().pose.position - to_.position).norm(), 1e-6);
  EXPECT_EQ(tracker.compare_with_reference(), AssemblyComparison::same) << "the reference went along";
  EXPECT_FALSE(first_again_);
  std::reverse(path.begin(), path.end());
  EXPECT_EQ(follow(path, tracker) % 2, 1);
  EXPECT_LT((tracker.state().pose.position - from_.position).norm(), 1e-6);
  EXPECT_TRUE(first_again_);
}

TEST_F(NonsingularAssemblyModeChange, IsAnsweredOnDemand) {
  const std::vector<JointVector> path = find_path();
  ASSERT_GE(path.size(), 3U);
  Tracker tracker(robot_, exact());
  ASSERT_TRUE(tracker.start_near(0.0, q_, from_, 1e-6));
  bool told = false, answered = false;
  for (std::size_t k = 1; k < path.size() && !told; ++k)
    for (int i = 1; i <= samples_ && !told; ++i) {
      tracker.update(time_ += 1e-3, path[k - 1] + (path[k] - path[k - 1]) * i / samples_);
      told = !tracker.transitions().empty();
      if (!told) answered = tracker.compare_with_reference() == AssemblyComparison::other;
    }
  EXPECT_TRUE(told);
  EXPECT_TRUE(answered) << "just before the actuated joints were back";
}

}  // namespace
}  // namespace parallel_aspects
