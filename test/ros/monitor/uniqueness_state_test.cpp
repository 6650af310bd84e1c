// SPDX-License-Identifier: BSD-3-Clause
//
// What states and transitions say of uniqueness domains, of the shipped 3-RPR on the way around a cusp.
#include "parallel_aspects/aspects/uniqueness.h"
#include "ros/monitor/cusp_motion.h"
#include "ros/monitor/five_bar_setup.h"
#include "ros/monitor/robot_monitor.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

/// With few cells, so that it is known in seconds.
const KnownDomains& known() {
  static const KnownDomains known = [] {
    UniquenessParameters parameters;
    parameters.enabled = true;
    parameters.most_cells = 24000;
    const auto robot = test::shipped("three_rpr")->mapped_manipulator();
    DomainFinder finder(*robot, parameters);
    EXPECT_EQ(finder.known().known, UniquenessState::WAITING);
    const std::atomic<bool> cancelled{false};
    finder.find(compute_aspect_map(robot, {}).map, cancelled);
    return finder.known();
  }();
  return known;
}

/// Around its second cusp from where the robot starts, and back to the actuated values.
std::vector<JointVector> around_cusp(const Manipulator& robot, const MapSlice& slice) {
  MapOptions options;
  options.slice = slice;
  const auto map = compute_aspect_map(test::shipped("three_rpr")->mapped_manipulator(), options).map;
  CuspPlanner planner(map, find_cusps(robot, *slice.joint).cusps);
  const PlannedPath path = planner.plan({test::pose_with_six_solutions(robot, *map, 4), {}}, 1);
  EXPECT_TRUE(path) << path.message;
  return test::values_along(robot, planner, path, 200);
}

class UniquenessStateTest : public testing::Test {
 protected:
  static NodeOptions options() {
    NodeOptions options;
    options.tracking.samples.check_velocity = false;
    options.tracking.samples.interval_ratio = 1e9;
    options.uniqueness.hold = 0.1;
    options.thresholds.parallel_stop = smallest_stop;
    return options;
  }

  ros::Time now() const { return ros::Time(100.0 + 0.001 * step_); }

  /// The next sample, examined as well.
  AspectState play(const JointVector& q) {
    ++step_;
    const MonitorUpdate update = monitor_.update(test::joint_states_of(*robot_, q, now()), now());
    told_.insert(told_.end(), update.transitions.begin(), update.transitions.end());
    monitor_.work();
    return *update.state;
  }

  AspectState play(const std::vector<JointVector>& values) {
    for (const JointVector& q : values) play(q);
    return rest();
  }

  /// Longer than the warning takes.
  AspectState rest() {
    const JointVector q = monitor_.current(now()).solved.q;
    AspectState state;
    for (int i = 0; i < 200; ++i) state = play(q);
    return state;
  }

  void start_at_six_solutions() {
    play(test::values_with_six_solutions());
    ASSERT_EQ(monitor_.start_near(start_, now()).code, Status::OK);
  }

  std::vector<AspectTransition> told(std::uint8_t kind) const {
    std::vector<AspectTransition> found;
    std::copy_if(told_.begin(), told_.end(), std::back_inserter(found),
                 [&](const AspectTransition& each) { return each.kind == kind; });
    return found;
  }

  static constexpr double smallest_stop = 1e-6;  // without a threshold there is no level [m]
  const std::shared_ptr<const Mechanism> mechanism_ = test::shipped("three_rpr");
  const std::shared_ptr<const Manipulator> robot_ = mechanism_->mapped_manipulator();
  const MapSlice slice_ = test::slice_of(robot_, {{robot_->leg(0).actuated_joint, 14.98}});
  const Pose start_ = Pose::planar(-8.72659533, 12.17566975, -0.98697424);
  RobotMonitor monitor_{mechanism_, options()};
  int step_ = 0;
  std::vector<AspectTransition> told_;
};

TEST_F(UniquenessStateTest, WarnsAroundACuspAndNotBackAtTheStart) {
  ASSERT_EQ(known().known, UniquenessState::REGIONS) << known().message;
  monitor_.set_domains(known());
  start_at_six_solutions();
  const AspectState first = rest();
  const std::uint32_t reference = first.uniqueness.reference_region;
  EXPECT_EQ(reference, *known().uniqueness->locate(start_) + 1);
  EXPECT_EQ(first.uniqueness.basic_region, reference);
  EXPECT_EQ(first.uniqueness.sharing, UniquenessState::SHARED);
  EXPECT_EQ(first.uniqueness.domains.size(), known().uniqueness->domains_of(reference - 1).size());
  EXPECT_GE(first.uniqueness.stamp, first.header.stamp - ros::Duration(0.0015));
  EXPECT_EQ(first.level, AspectState::CLEAR);

  std::vector<JointVector> way = around_cusp(*robot_, slice_);
  const AspectState there = play(way);
  ASSERT_EQ(there.status.code, Status::OK) << there.status.message;
  EXPECT_EQ(told(AspectTransition::ASSEMBLY_MODE).size(), 1U);
  EXPECT_TRUE(there.uniqueness.warns);
  EXPECT_EQ(there.uniqueness.sharing, UniquenessState::APART);
  EXPECT_EQ(there.uniqueness.reference_region, reference);
  EXPECT_NE(there.uniqueness.basic_region, reference);
  EXPECT_EQ(there.level, AspectState::WARN);
  EXPECT_NE(there.reason.find("uniqueness domain"), std::string::npos) << there.reason;
  monitor_.set_thresholds({});
  const AspectState unset = rest();
  EXPECT_EQ(unset.level, AspectState::NO_THRESHOLD) << "no warning makes that a level to go on at";
  for (const char* words : {"no threshold is set", "uniqueness domain"})
    EXPECT_NE(unset.reason.find(words), std::string::npos) << unset.reason;
  monitor_.set_thresholds(thresholds_of(options().thresholds, {}));
  const auto begun = told(AspectTransition::UNIQUENESS);
  ASSERT_EQ(begun.size(), 1U);
  EXPECT_FALSE(begun[0].domain_shared);
  EXPECT_EQ(begun[0].reference_region, reference);
  EXPECT_NE(begun[0].basic_region_before, begun[0].basic_region_after);
  EXPECT_LE(begun[0].header.stamp, now() - ros::Duration(0.1));
  EXPECT_GT(begun[0].header.stamp, ros::Time(100.0));
  EXPECT_TRUE(monitor_.uniqueness().warns);

  std::reverse(way.begin(), way.end());
  const AspectState back = play(way);
  EXPECT_FALSE(back.uniqueness.warns);
  EXPECT_EQ(back.uniqueness.basic_region, reference);
  EXPECT_EQ(back.level, AspectState::CLEAR);
  const auto both = told(AspectTransition::UNIQUENESS);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_TRUE(both[1].domain_shared);
}

TEST_F(UniquenessStateTest, SaysNothingAroundNoCusp) {
  monitor_.set_domains(known());
  start_at_six_solutions();
  rest();
  told_.clear();
  const AspectState state = play(test::values_on_circle(500));
  EXPECT_EQ(state.status.code, Status::OK);
  EXPECT_EQ(state.uniqueness.basic_region, state.uniqueness.reference_region);
  EXPECT_FALSE(state.uniqueness.warns);
  EXPECT_TRUE(told_.empty());
}

// As where tracking began before they were computed.
TEST_F(UniquenessStateTest, KnowsWhereTrackingBeganThoughDomainsComeLater) {
  start_at_six_solutions();
  EXPECT_EQ(play(around_cusp(*robot_, slice_)).uniqueness.known, UniquenessState::OFF);
  monitor_.set_domains(known());
  const AspectState state = rest();
  EXPECT_EQ(state.uniqueness.reference_region, *known().uniqueness->locate(start_) + 1);
  EXPECT_TRUE(state.uniqueness.warns);
}

TEST_F(UniquenessStateTest, BeginsAnewWhereTheAssemblyModeIsStated) {
  monitor_.set_domains(known());
  start_at_six_solutions();
  EXPECT_TRUE(play(around_cusp(*robot_, slice_)).uniqueness.warns);
  ASSERT_EQ(monitor_.start_near(monitor_.current(now()).solved.pose, now()).code, Status::OK);
  const AspectState next = play(test::values_with_six_solutions());
  EXPECT_FALSE(next.uniqueness.warns);
  EXPECT_EQ(next.uniqueness.known, UniquenessState::REGIONS);
  const AspectState state = rest();
  EXPECT_FALSE(state.uniqueness.warns);
  EXPECT_EQ(state.uniqueness.reference_region, state.uniqueness.basic_region);
  EXPECT_NE(state.uniqueness.reference_region, *known().uniqueness->locate(start_) + 1);
}

TEST_F(UniquenessStateTest, KnowsNothingWhereTheRobotIsNotTracked) {
  monitor_.set_domains(known());
  start_at_six_solutions();
  EXPECT_NE(rest().uniqueness.basic_region, 0U);
  const auto stale = monitor_.expire(now() + ros::Duration(2.0), ros::SteadyTime(1.0));
  ASSERT_TRUE(stale);
  EXPECT_EQ(stale->uniqueness.known, UniquenessState::REGIONS);
  EXPECT_EQ(stale->uniqueness.basic_region, 0U);
  EXPECT_TRUE(stale->uniqueness.domains.empty());
  EXPECT_TRUE(stale->uniqueness.stamp.isZero());
}

TEST(DomainFinderTest, SaysWhatItCanKnow) {
  UniquenessParameters on;
  on.enabled = true;
  const auto said = [](const std::string& robot, const UniquenessParameters& parameters) {
    return DomainFinder(*test::shipped(robot)->mapped_manipulator(), parameters).known();
  };
  EXPECT_EQ(said("five_bar", {}).known, UniquenessState::ASPECTS);
  EXPECT_EQ(said("delta", {}).known, UniquenessState::ASPECTS);
  EXPECT_EQ(said("three_rpr", {}).known, UniquenessState::OFF);
  EXPECT_NE(said("three_rpr", {}).message.find("uniqueness/enabled"), std::string::npos);
  EXPECT_EQ(said("three_rpr", on).known, UniquenessState::WAITING);
  for (const char* robot : {"spherical_3rrr", "stewart"}) {
    EXPECT_EQ(said(robot, on).known, UniquenessState::NONE);
    EXPECT_FALSE(said(robot, on).message.empty());
  }
}

TEST(DomainFinderTest, CanBeCancelled) {
  UniquenessParameters on;
  on.enabled = true;
  const auto robot = test::shipped("three_rpr")->mapped_manipulator();
  DomainFinder finder(*robot, on);
  const std::atomic<bool> cancelled{true};
  finder.find(compute_aspect_map(robot, {}).map, cancelled);
  EXPECT_EQ(finder.known().known, UniquenessState::NONE);
  EXPECT_NE(finder.known().message.find("cancelled"), std::string::npos);
}

}  // namespace
}  // namespace parallel_aspects
