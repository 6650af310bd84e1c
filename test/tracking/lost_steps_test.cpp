// SPDX-License-Identifier: BSD-3-Clause
//
// Steps that are lost, and what the tracker makes of them by itself: the assembly mode is found again where
// all that the actuated joints can have done keeps to it, and never another one.
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/tracking/tracker.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/tracking_campaign.h"
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::FineFollower;
using test::pose_distance;

bool was_found(const Tracker& tracker) {
  for (const Transition& each : tracker.transitions())
    if (each.kind == TransitionKind::found) return true;
  return false;
}

std::shared_ptr<const Manipulator> five_bar(double velocity) {
  std::vector<Leg> legs = test::five_bar()->legs();
  for (Leg& leg : legs) leg.limits.velocity = velocity;
  return test::manipulator("five_bar", TaskSpace::T2, std::move(legs));
}

/// The five-bar at rest at (4.5, 8), lost by a silence of a second.
class LostAtRest : public testing::Test {
 protected:
  Tracker lost(double velocity, const TrackerOptions& options = {}) const {
    const auto robot = five_bar(velocity);
    const JointVector q = inverse(*robot, Pose::planar(4.5, 8.0), *WorkingMode::from_signs({-1, -1})).q;
    Tracker tracker(robot, options);
    EXPECT_TRUE(tracker.start_near(0.0, q, Pose::planar(4.5, 8.0), 1e-6));
    tracker.update(0.01, q);
    EXPECT_EQ(tracker.update(1.01, q).ambiguity, Ambiguity::silence);
    tracker.take_transitions();
    return tracker;
  }
};

TEST_F(LostAtRest, IsFoundWhereItsVelocityLimitsKeepItInItsAssemblyMode) {
  Tracker tracker = lost(0.2);
  const double y = 8.0 - 1e-4;
  JointVector q = tracker.state().q + 1e-4 * JointVector::Ones(2);
  EXPECT_EQ(tracker.update(1.02, q).status, TrackStatus::ambiguous) << "until somebody looks";
  EXPECT_TRUE(tracker.find_candidates());
  EXPECT_EQ(tracker.state().status, TrackStatus::tracking);
  EXPECT_NEAR(tracker.state().pose.position.y(), y, 0.01);
  EXPECT_EQ(tracker.state().determinant_sign, 1);
  ASSERT_EQ(tracker.transitions().count, 1U);
  const Transition& found = *tracker.transitions().begin();
  EXPECT_EQ(found.kind, TransitionKind::found);
  EXPECT_EQ(found.ambiguity, Ambiguity::silence) << "why it was lost";
  EXPECT_EQ(found.determinant_sign_before, 0);
  EXPECT_EQ(found.determinant_sign_after, 1);
  q[0] += 1e-4;
  EXPECT_EQ(tracker.update(1.03, q).status, TrackStatus::tracking);
}

// So that the last transition is the one that says why the state is known again.
TEST_F(LostAtRest, IsFoundInItsAspectByOneTransition) {
  Tracker tracker = lost(0.2);
  const auto map = compute_aspect_map(five_bar(0.2)).map;
  tracker.set_map(map);
  ASSERT_TRUE(tracker.find_candidates());
  ASSERT_EQ(tracker.transitions().count, 1U);
  const Transition& found = *tracker.transitions().begin();
  EXPECT_EQ(found.kind, TransitionKind::found);
  EXPECT_EQ(found.aspect_before, 0);
  EXPECT_EQ(found.aspect_after, map->locate(Pose::planar(4.5, 8.0), tracker.state().mode).aspect);
  EXPECT_NE(found.aspect_after, 0);
  EXPECT_EQ(tracker.state().aspect, found.aspect_after);
  tracker.update(1.02, tracker.state().q);
  EXPECT_EQ(tracker.transitions().count, 0U) << "which is not said again";
}

TEST_F(LostAtRest, IsNotFoundWhereItCanHaveChangedItsAssemblyMode) {
  Tracker tracker = lost(3.0);
  EXPECT_FALSE(tracker.find_candidates());
  EXPECT_EQ(tracker.candidates().size(), 2U);
  EXPECT_FALSE(was_found(tracker));
}

TEST_F(LostAtRest, IsNotFoundWithoutABound) {
  Tracker unlimited = lost(std::numeric_limits<double>::infinity());
  EXPECT_FALSE(unlimited.find_candidates());
  TrackerOptions options;
  options.samples.check_velocity = false;
  Tracker not_relied_on = lost(0.2, options);
  EXPECT_FALSE(not_relied_on.find_candidates());
  Tracker gap = lost(0.2);
  gap.update(1.02, gap.state().q + 0.1 * JointVector::Ones(2));
  EXPECT_FALSE(gap.find_candidates()) << "it was faster than its limits in the meantime";
  Tracker contradicted = lost(0.2);
  ASSERT_TRUE(contradicted.find_candidates());
  contradicted.report_residual(3.0, true);
  contradicted.update(2.02, contradicted.state().q);
  EXPECT_FALSE(contradicted.find_candidates()) << "its pose was one that measured joints contradict";
}

struct LossCounts {
  int lost = 0, moved = 0, found = 0,
      wrong = 0;  // of those lost, moved to another one of the same joint values
  std::string first_wrong;
};

/// Random motions of a shipped robot with steps that are lost: in silences, in which it goes as fast as its
/// limits allow, through det A = 0 too, and best to another assembly mode of the joint values that it left;
/// and in long steps that are not proved.
class LostSteps {
 public:
  LostSteps(const Mechanism& mechanism, unsigned seed) : robot_(mechanism.manipulator()), random_(seed) {
    middle_ = mechanism.assembled().pose;
  }

  LossCounts run(int losses) {
    for (int i = 0; counts_.lost < losses && i < 40 * losses; ++i)
      i % 3 == 2 ? long_step() : silence(i % 3 == 0);
    return counts_;
  }

 private:
  struct Motion {
    Pose end;
    JointVector q;
    double seconds = 0.0;  // at the velocity limits
    bool to_another = false;
  };

  Pose displaced_by(const Pose& pose, double size) {
    const auto turns = static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot_->task_space()));
    TaskVector step(static_cast<Eigen::Index>(robot_->leg_count()));
    for (Eigen::Index k = 0; k < step.size(); ++k)
      step[k] = size * random_.uniform(-1.0, 1.0) * (k < turns ? 1.0 : robot_->size());
    return displaced(robot_->motions(), pose, step);
  }

  bool start() {
    const auto modes = working_modes(*robot_);
    const auto pick = static_cast<std::size_t>(random_.uniform(0.0, static_cast<double>(modes.size())));
    mode_ = modes[std::min(pick, modes.size() - 1)];
    pose_ = displaced_by(middle_, random_.uniform(0.0, 0.3));
    const InverseSolution solution = inverse(*robot_, pose_, mode_);
    q_ = solution.q;
    return solution.status == InverseStatus::solved &&
           smallest_singular_value_bound(*robot_, pose_, q_) > 1e-3;
  }

  // A straight path of poses in the working mode; nothing where it leaves the reach or the limits.
  std::optional<Motion> straight_to(const Pose& end) const {
    Motion motion{end, q_};
    for (int i = 1; i <= 40; ++i) {
      Pose pose = pose_;
      pose.position += (end.position - pose_.position) * (i / 40.0);
      pose.orientation = pose_.orientation.slerp(i / 40.0, end.orientation);
      const InverseSolution solution = inverse(*robot_, pose, mode_);
      if (solution.status != InverseStatus::solved) return std::nullopt;
      double longest = 0.0;
      for (std::size_t j = 0; j < robot_->leg_count(); ++j) {
        const auto k = static_cast<Eigen::Index>(j);
        const bool wraps = robot_->leg(j).actuated_by_angle() && !robot_->leg(j).limits.limited();
        const double step = solution.q[k] - motion.q[k];
        const double change = wraps ? std::remainder(step, 2.0 * EIGEN_PI) : step;
        motion.q[k] += change;
        longest = std::max(longest, std::abs(change) / robot_->leg(j).limits.velocity);
      }
      motion.seconds += longest;
    }
    return motion;
  }

  // Another assembly mode of the same joint values in the same working mode, or anywhere.
  std::optional<Motion> motion_in_silence(bool to_another) {
    if (to_another)
      for (const AssemblyMode& other : direct(*robot_, q_).solutions) {
        if (pose_distance(*robot_, other.pose, pose_) < 1e-3) continue;
        auto motion = straight_to(other.pose);
        if (!motion || (motion->q - q_).cwiseAbs().maxCoeff() > 1e-6) continue;
        motion->to_another = true;
        return motion;
      }
    return straight_to(displaced_by(pose_, std::pow(10.0, random_.uniform(-3.0, -0.3))));
  }

  void silence(bool to_another) {
    if (!start()) return;
    const auto motion = motion_in_silence(to_another);
    if (!motion || motion->seconds < 2e-4) return;
    TrackerOptions options;
    options.samples.longest_interval = 1e-4;
    Tracker tracker(robot_, options);
    if (!tracker.start_near(0.0, q_, pose_, 1e-6 * robot_->size())) return;
    for (int i = 1; i <= 3; ++i) tracker.update(1e-5 * i, q_);
    const double rest = motion->seconds * random_.uniform(0.0, 0.5);
    if (tracker.update(3e-5 + motion->seconds + rest, motion->q).status != TrackStatus::ambiguous) return;
    counts_.moved += motion->to_another;
    judge(tracker, motion->end);
  }

  void long_step() {
    if (!start()) return;
    TrackerOptions options;
    options.samples.longest_interval = std::numeric_limits<double>::infinity();
    options.samples.check_velocity = false;
    options.samples.unwrap = false;
    options.max_steps = 4;
    Tracker tracker(robot_, options);
    if (!tracker.start_near(0.0, q_, pose_, 1e-6 * robot_->size())) return;
    const double size = std::pow(10.0, random_.uniform(-3.0, 0.0));
    JointVector end = q_;
    for (Eigen::Index j = 0; j < end.size(); ++j) {
      const bool angle = robot_->leg(static_cast<std::size_t>(j)).actuated_by_angle();
      end[j] += size * random_.uniform(-1.0, 1.0) * (angle ? 1.0 : robot_->size());
    }
    FineFollower truth(*robot_, pose_, q_);
    long crossings = 0;
    if (tracker.update(0.001, end).status == TrackStatus::ambiguous && truth.go(end, 1e-3, crossings))
      judge(tracker, truth.pose());
  }

  void judge(Tracker& tracker, const Pose& truth) {
    ++counts_.lost;
    tracker.take_transitions();
    tracker.find_candidates();
    if (!was_found(tracker)) return;
    ++counts_.found;
    if (pose_distance(*robot_, tracker.state().pose, truth) <= 1e-6) return;
    if (counts_.wrong++ == 0) counts_.first_wrong = test::describe(*robot_, pose_, q_);
  }

  std::shared_ptr<const Manipulator> robot_;
  test::RandomRobots random_;
  Pose middle_, pose_;  // of the robot as it was assembled; where a trial begins
  JointVector q_;
  WorkingMode mode_;
  LossCounts counts_;
};

class EveryRobot : public testing::TestWithParam<const char*> {};

TEST_P(EveryRobot, IsFoundAgainAndNeverInAWrongAssemblyMode) {
  const auto mechanism = test::shipped(GetParam());
  const bool slow = mechanism->manipulator()->task_space() == TaskSpace::SE3;  // to list direct solutions
  const LossCounts counts = LostSteps(*mechanism, 20261128).run(slow ? 30 : 60);
  EXPECT_EQ(counts.wrong, 0) << counts.first_wrong;
  EXPECT_GT(counts.found, 0);
  EXPECT_LE(counts.found, counts.lost - counts.moved) << "what was moved to another one is not";
  RecordProperty("lost", counts.lost);
  RecordProperty("found", counts.found);
  RecordProperty("moved", counts.moved);
}

INSTANTIATE_TEST_SUITE_P(LostSteps, EveryRobot, testing::ValuesIn(test::campaign_robots),
                         [](const testing::TestParamInfo<const char*>& tested) {
                           return std::string(tested.param);
                         });

}  // namespace
}  // namespace parallel_aspects
