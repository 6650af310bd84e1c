// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/ompl/aspect_space_information.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
#include "support/sign_at.h"
#include <algorithm>
#include <cmath>
#include <memory>
#include <ompl/base/ScopedState.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/RandomNumbers.h>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using State = ob::ScopedState<>;

// Before any random number of OMPL's.
const bool is_seeded = (ompl::RNG::setSeed(1), true);

/// A shipped robot in a random working mode, with pairs of states that are valid there.
class Ground {
 public:
  explicit Ground(const std::string& name)
      : robot(test::shipped(name)->manipulator()), pairs_(robot, 7), side_(some_side()) {
    information = make_aspect_space_information(robot, side_);
  }

  Pose pose_of_side() {
    while (true)
      if (const auto pose = pairs_.reached(side_.mode); pose && is_valid(*pose)) return *pose;
  }

  Pose pose_near(const Pose& from) {
    while (true)
      if (const auto pose = pairs_.nearby(from, side_.mode); pose && is_valid(*pose)) return *pose;
  }

  State state(const Pose& pose) const {
    State result(information);
    set_pose(robot->task_space(), pose, *result);
    return result;
  }

  Pose pose(const State& state) const { return pose_of(robot->task_space(), *state); }

  bool is_valid(const Pose& pose) const {
    return test::sign_in_doubles(*robot, pose, side_.mode) == side_.determinant_sign;
  }

  /// t of the first of so many poses along a motion that is not valid in plain double precision; 2 if none.
  double first_violation(const Pose& from, const Pose& to, int looks) const {
    for (int i = 0; i <= looks; ++i)
      if (!is_valid(pose_between(from, to, i / double(looks)))) return i / double(looks);
    return 2.0;
  }

  const ModeAndSign& side() const { return side_; }

  std::shared_ptr<const Manipulator> robot;
  ob::SpaceInformationPtr information;

 private:
  ModeAndSign some_side() {
    const WorkingMode mode = pairs_.mode();
    return {mode, test::sign_in_doubles(*robot, *pairs_.reached(mode), mode)};
  }

  test::PosePairs pairs_;
  ModeAndSign side_;
};

const std::vector<std::string> one_of_each_space{"bipod", "five_bar",       "three_rpr",
                                                 "delta", "spherical_3rrr", "stewart"};

// Random states, and poses between two valid ones.
TEST(AspectValidityChecker, AgreesWithPlainArithmetic) {
  for (const std::string& name : one_of_each_space) {
    Ground ground(name);
    int valid = 0, compared = 0;
    State state(ground.information);
    for (int i = 0; i < 1000; ++i) {
      if (i % 2 == 0)
        state.random();
      else
        state = ground.state(pose_between(ground.pose_of_side(), ground.pose_of_side(), 1e-3 * i));
      const auto sign = test::sign_at(*ground.robot, ground.pose(state), ground.side().mode);
      if (!sign) continue;
      ++compared;
      const bool expected = *sign == ground.side().determinant_sign;
      valid += expected ? 1 : 0;
      ASSERT_EQ(ground.information->isValid(state.get()), expected)
          << name << ' ' << to_string(ground.robot->task_space(), ground.pose(state));
    }
    EXPECT_GT(compared, 800) << name;
    EXPECT_GT(valid, 100) << name;
    EXPECT_LT(valid, compared) << name;
  }
}

TEST(CertifiedMotionValidator, AgreesWithDensePoses) {
  constexpr int count = 200;
  for (const std::string& name : one_of_each_space) {
    Ground ground(name);
    int free = 0, blocked = 0, undecided = 0;
    for (int i = 0; i < count; ++i) {
      const Pose from = ground.pose_of_side(), to = ground.pose_of_side();
      const bool proved = ground.information->checkMotion(ground.state(from).get(), ground.state(to).get());
      const double violation = ground.first_violation(from, to, 1000);
      ASSERT_FALSE(proved && violation <= 1.0)
          << name << " from " << to_string(ground.robot->task_space(), from) << " to "
          << to_string(ground.robot->task_space(), to) << " at " << violation;
      ++(proved ? free : violation <= 1.0 ? blocked : undecided);
    }
    EXPECT_GT(free, 0) << name;
    EXPECT_LE(undecided, count / 10) << name << ": " << free << " free, " << blocked << " blocked";
  }
}

TEST(CertifiedMotionValidator, ReportsTheLastValidState) {
  for (const std::string& name : one_of_each_space) {
    Ground ground(name);
    int looked_at = 0, close = 0;
    for (int i = 0; i < 400 && looked_at < 30; ++i) {
      const Pose start = ground.pose_of_side(), end = ground.pose_of_side();
      const State from = ground.state(start), to = ground.state(end);
      State last(ground.information);
      std::pair<ob::State*, double> last_valid{last.get(), -1.0};
      if (ground.information->checkMotion(from.get(), to.get(), last_valid)) {
        ASSERT_EQ(last_valid.second, -1.0);  // left alone
        continue;
      }
      ++looked_at;
      const double violation = ground.first_violation(start, end, 2000);
      ASSERT_GE(last_valid.second, 0.0);
      ASSERT_LT(last_valid.second, std::min(1.0, violation)) << name;
      close += last_valid.second > 0.8 * std::min(1.0, violation) - 1e-3 ? 1 : 0;
      ASSERT_TRUE(ground.information->isValid(last.get())) << name;
      ASSERT_TRUE(ground.information->checkMotion(from.get(), last.get())) << name;
      const Pose expected = pose_between(ground.pose(from), ground.pose(to), last_valid.second);
      EXPECT_LT((ground.pose(last).position - expected.position).norm(), 1e-9 * ground.robot->size());

      std::pair<ob::State*, double> no_state{nullptr, -1.0};
      EXPECT_FALSE(ground.information->checkMotion(from.get(), to.get(), no_state));
      EXPECT_EQ(no_state.second, last_valid.second);
      State into = ground.state(end);  // the place of the end may be that of the answer
      std::pair<ob::State*, double> aliased{into.get(), -1.0};
      EXPECT_FALSE(ground.information->checkMotion(from.get(), into.get(), aliased));
      EXPECT_EQ(into, last);
    }
    EXPECT_GT(looked_at, 0) << name;
    EXPECT_GE(close * 10, looked_at * 8) << name << ": " << close << " of " << looked_at;
  }
}

TEST(CertifiedMotionValidator, GivesTheStartWhereNothingIsProved) {
  const Ground ground("five_bar");
  const State outside = ground.state(Pose::planar(100.0, 0.0));
  State last(ground.information);
  std::pair<ob::State*, double> last_valid{last.get(), -1.0};
  EXPECT_FALSE(ground.information->checkMotion(outside.get(), outside.get(), last_valid));
  EXPECT_EQ(last_valid.second, 0.0);
  EXPECT_EQ(last, outside);
}

TEST(CertifiedMotionValidator, AnswersManyThreads) {
  Ground ground("three_rpr");
  std::vector<std::pair<State, State>> motions;
  for (int i = 0; i < 40; ++i)
    motions.emplace_back(ground.state(ground.pose_of_side()), ground.state(ground.pose_of_side()));
  std::vector<int> expected;
  for (const auto& [from, to] : motions)
    expected.push_back(ground.information->checkMotion(from.get(), to.get()) ? 1 : 0);
  ground.information->getMotionValidator()->resetMotionCounter();
  std::vector<std::vector<int>> answers(4);
  std::vector<std::thread> threads;
  for (std::vector<int>& mine : answers)
    threads.emplace_back([&] {
      for (const auto& [from, to] : motions)
        mine.push_back(ground.information->checkMotion(from.get(), to.get()) ? 1 : 0);
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<int>& mine : answers) EXPECT_EQ(mine, expected);
  EXPECT_EQ(ground.information->getMotionValidator()->getCheckedMotionCount(), 4 * motions.size());
}

// With OMPL's own simplification, which cuts motions in parts.
TEST(AspectSpaceInformation, PathsStayInTheirMode) {
  for (const std::string& name : one_of_each_space) {
    Ground ground(name);
    int solved = 0;
    for (int i = 0; i < 10; ++i) {
      og::SimpleSetup setup(ground.information);
      setup.setPlanner(std::make_shared<og::RRTConnect>(ground.information));
      const Pose start = ground.pose_of_side();
      const Pose goal = i % 2 == 0 ? ground.pose_near(start) : ground.pose_of_side();
      setup.setStartAndGoalStates(ground.state(start), ground.state(goal));
      if (setup.solve(0.3) != ob::PlannerStatus::EXACT_SOLUTION) continue;
      setup.simplifySolution(0.1);
      og::PathGeometric& path = setup.getSolutionPath();
      if (!path.check()) continue;
      ++solved;
      for (std::size_t k = 0; k + 1 < path.getStateCount(); ++k) {
        const Pose from = pose_of(ground.robot->task_space(), *path.getState(static_cast<unsigned>(k)));
        const Pose to = pose_of(ground.robot->task_space(), *path.getState(static_cast<unsigned>(k + 1)));
        ASSERT_GT(ground.first_violation(from, to, 500), 1.0) << name;
      }
    }
    EXPECT_GT(solved, 0) << name;
  }
}

TEST(AspectSpaceInformation, RefusesWhatDoesNotFit) {
  const auto robot = test::shipped("five_bar")->manipulator();
  const auto refusal = [&](const ModeAndSign& side) -> std::string {
    try {
      make_aspect_space_information(robot, side);
    } catch (const InvalidDescription& invalid) {
      return invalid.what();
    }
    return "";
  };
  EXPECT_EQ(refusal({WorkingMode(2), 1}), "");
  EXPECT_EQ(refusal({WorkingMode(2), 0}), "The sign of det A is 0; give 1 or -1.");
  EXPECT_EQ(refusal({WorkingMode(3), 1}), "'five_bar' has no working mode (+,+,+); its first is (+,+).");
}

}  // namespace
}  // namespace parallel_aspects
