// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/motion/choose_working_mode.h"

#include <gtest/gtest.h>

#include "support/path_samples.h"
#include "support/pose_pairs.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::side;
using At = test::ConfigurationAt<long double>;

std::string text(const Manipulator& robot, const Box& region) {
  std::string result = robot.name() + " --region \"";
  for (std::size_t i = 0; i < region.dimension; ++i) {
    char range[80];
    std::snprintf(range, sizeof range, "%.17g:%.17g", region.lower[i], region.upper[i]);
    result += coordinate_names(robot.task_space())[i] + "=" + range + " ";
  }
  return result + "\"";
}

Pose pose_at(const Manipulator& robot, const MapPoint& point) {
  PoseCoordinates coordinates(static_cast<Eigen::Index>(robot.leg_count()));
  for (std::size_t i = 0; i < robot.leg_count(); ++i) coordinates[static_cast<Eigen::Index>(i)] = point[i];
  return *pose_from_coordinates(robot.motions(), coordinates);
}

// A fine grid over a region, as one working mode sees it.
class Grid {
 public:
  Grid(const Manipulator& robot, const Box& region, const WorkingMode& mode, std::size_t edge)
      : edge_(edge), dimension_(region.dimension) {
    std::size_t count = 1;
    for (std::size_t i = 0; i < dimension_; ++i) count *= edge_;
    for (std::size_t n = 0; n < count; ++n) {
      MapPoint point{};
      std::size_t rest = n;
      for (std::size_t i = 0; i < dimension_; ++i, rest /= edge_) {
        const double share = static_cast<double>(rest % edge_) / static_cast<double>(edge_ - 1);
        point[i] = (1.0 - share) * region.lower[i] + share * region.upper[i];
      }
      sides_.push_back(side(robot, pose_at(robot, point), mode));
    }
  }

  // Whether a flood from the first point, through points of one sign, gets everywhere.
  bool flood_fills_it() const {
    if (sides_.front() == 0) return false;
    std::vector<bool> wet(sides_.size(), false);
    std::vector<std::size_t> open{0};
    wet[0] = true;
    std::size_t reached = 0;
    while (!open.empty()) {
      const std::size_t n = open.back();
      open.pop_back();
      ++reached;
      std::size_t stride = 1;
      for (std::size_t i = 0; i < dimension_; ++i, stride *= edge_) {
        const std::size_t at = n / stride % edge_;
        if (at > 0) spread(n - stride, wet, open);
        if (at + 1 < edge_) spread(n + stride, wet, open);
      }
    }
    return reached == sides_.size();
  }

 private:
  void spread(std::size_t to, std::vector<bool>& wet, std::vector<std::size_t>& open) const {
    if (wet[to] || sides_[to] != sides_.front()) return;
    wet[to] = true;
    open.push_back(to);
  }

  std::size_t edge_, dimension_;
  std::vector<int> sides_;
};

bool lies_in(const Manipulator& robot, const Box& region, const Pose& pose) {
  const PoseCoordinates coordinates = pose_coordinates(robot.task_space(), pose);
  for (std::size_t i = 0; i < region.dimension; ++i) {
    const double value = coordinates[static_cast<Eigen::Index>(i)];
    if (value < region.lower[i] - 1e-12 || value > region.upper[i] + 1e-12) return false;
  }
  return true;
}

class RandomRegions : public testing::TestWithParam<const char*> {
 protected:
  // Around a pose that is reached, from small ones to large ones.
  std::optional<Box> draw() {
    const auto center = pairs.reached(pairs.mode());
    if (!center) return std::nullopt;
    const PoseCoordinates at = pose_coordinates(robot->task_space(), *center);
    Box region{robot->leg_count(), {}, {}};
    for (std::size_t i = 0; i < region.dimension; ++i) {
      const bool angle = coordinate_names(robot->task_space())[i] == "phi";
      const double half = std::pow(10.0, pairs.uniform(-2.5, -0.6)) * (angle ? 1.0 : robot->size());
      region.lower[i] = at[static_cast<Eigen::Index>(i)] - half;
      region.upper[i] = at[static_cast<Eigen::Index>(i)] + half;
      if (angle) {
        region.lower[i] = std::max(region.lower[i], -static_cast<double>(EIGEN_PI));
        region.upper[i] = std::min(region.upper[i], static_cast<double>(EIGEN_PI));
      }
    }
    return region;
  }

  void expect_refuted(const ModeInRegion& mode, const Box& region) {
    ASSERT_FALSE(mode.witnesses.empty());
    for (const Pose& witness : mode.witnesses) EXPECT_TRUE(lies_in(*robot, region, witness));
    const int first = side(*robot, mode.witnesses.front(), mode.mode);
    if (mode.witnesses.size() == 1) {
      EXPECT_EQ(first, 0);
    } else {
      EXPECT_EQ(first * side(*robot, mode.witnesses.back(), mode.mode), -1);
    }
  }

  void expect_apart(const std::pair<Pose, Pose>& apart, const Box& region) {
    EXPECT_TRUE(lies_in(*robot, region, apart.first) && lies_in(*robot, region, apart.second));
    for (const WorkingMode& mode : working_modes(*robot))
      EXPECT_NE(side(*robot, apart.first, mode) * side(*robot, apart.second, mode), 1);
  }

  std::shared_ptr<const Manipulator> robot =
      test::shipped(GetParam())->manipulator()->with_constraints(ConstraintKinds{});
  test::PosePairs pairs{robot, 20261123};
};

TEST_P(RandomRegions, AreTConnectedWhereAFloodOfAFineGridFillsThem) {
  int safe = 0, unsafe = 0, unknown = 0, apart = 0;
  const std::size_t edge = robot->leg_count() == 2 ? 60 : 14;
  for (int i = 0; i < test::thinned(60); ++i) {
    const auto region = draw();
    if (!region) continue;
    SCOPED_TRACE(text(*robot, *region));
    ASSERT_TRUE(problems_of(*robot, RegionQuestion{*region, {}}).empty());
    const RegionChoice choice = choose_working_mode(robot, RegionQuestion{*region, {}});
    bool any = false;
    for (const ModeInRegion& mode : choice.modes) {
      switch (mode.answer) {
        case TrajectoryAnswer::safe:
          any = true;
          ++safe;
          EXPECT_TRUE(Grid(*robot, *region, mode.mode, edge).flood_fills_it()) << to_string(mode.mode);
          break;
        case TrajectoryAnswer::unsafe:
          ++unsafe;
          expect_refuted(mode, *region);
          break;
        case TrajectoryAnswer::unknown:
          ++unknown;
          EXPECT_GT(mode.undecided, 0.0);
          break;
      }
    }
    EXPECT_EQ(choice.answer == TrajectoryAnswer::safe, any);
    if (!choice.apart) continue;
    ++apart;
    expect_apart(*choice.apart, *region);
  }
  std::cout << GetParam() << ": in one aspect " << safe << ", not " << unsafe << ", unknown " << unknown
            << ", pairs apart " << apart << '\n';
  EXPECT_GT(safe, 0);
  EXPECT_GT(unsafe, 0);
  EXPECT_GT(apart, 0);
  EXPECT_LE(20 * unknown, safe + unsafe);
}

TEST_P(RandomRegions, HaveNoIndexBelowTheBound) {
  for (int i = 0; i < test::thinned(30); ++i) {
    const auto region = draw();
    if (!region) continue;
    SCOPED_TRACE(text(*robot, *region));
    for (const ModeInRegion& mode : choose_working_mode(robot, RegionQuestion{*region, {}}).modes) {
      if (mode.answer != TrajectoryAnswer::safe) continue;
      EXPECT_LE(mode.least_index.lower, mode.least_index.upper);
      for (int k = 0; k < 100; ++k) {
        MapPoint point{};
        for (std::size_t c = 0; c < region->dimension; ++c)
          point[c] = pairs.uniform(region->lower[c], region->upper[c]);
        const long double index = At(*robot, pose_at(*robot, point), mode.mode).parallel();
        EXPECT_GE(std::abs(index), mode.least_index.lower - 1e-12);
        EXPECT_EQ(index > 0 ? 1 : -1, mode.determinant_sign);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, RandomRegions, testing::Values("five_bar", "three_rrr", "delta"),
                         [](const auto& each) { return std::string(each.param); });

RegionQuestion with_slice(const Manipulator& robot, const std::vector<HeldCoordinate>& held, Box region) {
  Problems problems;
  return {region, make_slice(robot, held, problems)};
}

TEST(RegionOfASlice, IsThatOfTheHeldOrientation) {
  const auto robot = test::shipped("hexa")->manipulator()->with_constraints(ConstraintKinds{});
  test::PosePairs pairs(robot, 5);
  for (int found = 0, i = 0; found < 3 && i < 50; ++i) {
    const WorkingMode mode = pairs.mode();
    const auto home = pairs.reached(mode);
    ASSERT_TRUE(home);
    const Eigen::Vector3d rpy = home->orientation.toRotationMatrix().eulerAngles(2, 1, 0);
    Box region{3, {}, {}};
    for (std::size_t c = 0; c < 3; ++c) {
      region.lower[c] = home->position[static_cast<Eigen::Index>(c)] - 0.01 * robot->size();
      region.upper[c] = home->position[static_cast<Eigen::Index>(c)] + 0.01 * robot->size();
    }
    const RegionQuestion question =
        with_slice(*robot, {{"roll", rpy[2]}, {"pitch", rpy[1]}, {"yaw", rpy[0]}}, region);
    ASSERT_TRUE(problems_of(*robot, question).empty());
    for (const ModeInRegion& each : choose_working_mode(robot, question, {2000, {}}).modes) {
      if (each.answer != TrajectoryAnswer::safe) continue;
      ++found;
      for (int k = 0; k < 20; ++k) {
        Pose pose = question.slice->held;
        for (Eigen::Index c = 0; c < 3; ++c)
          pose.position[c] = pairs.uniform(region.lower[static_cast<std::size_t>(c)],
                                           region.upper[static_cast<std::size_t>(c)]);
        EXPECT_EQ(side(*robot, pose, each.mode), each.determinant_sign);
      }
    }
    if (i == 49) ADD_FAILURE() << "no region of a slice was proved";
  }
}

// Half a turn is an angle as any other: with the base turned, a region that is turned, too, has the same
// answers.
TEST(RegionOfAngles, GoesOnBeyondHalfATurn) {
  test::PosePairs pairs(test::ankle(), 7);
  int safe = 0;
  for (int i = 0; i < 40; ++i) {
    const double angle = pairs.uniform(-3.1, 3.1), first = pairs.uniform(-0.5, 0.3),
                 second = pairs.uniform(-0.3, 0.2);
    const Box region{2, {first, second}, {first + 0.2, second + 0.2}},
        moved{2, {first + angle, second}, {first + angle + 0.2, second + 0.2}};
    const auto robot = test::turned_about_first_hinge(*test::ankle(), angle);
    const RegionQuestion question{moved, {}};
    ASSERT_TRUE(problems_of(*robot, question).empty());
    const RegionChoice expected = choose_working_mode(test::ankle(), RegionQuestion{region, {}}),
                       found = choose_working_mode(robot, question);
    for (const ModeInRegion& each : found.modes)
      for (const ModeInRegion& other : expected.modes) {
        if (each.mode != other.mode) continue;
        EXPECT_EQ(each.answer, other.answer) << text(*robot, moved);
        EXPECT_EQ(each.determinant_sign, other.determinant_sign) << text(*robot, moved);
        safe += each.answer == TrajectoryAnswer::safe ? 1 : 0;
      }
  }
  EXPECT_GT(safe, 20);
}

TEST(RegionProblems, AreSaidInOneSentenceEach) {
  const auto five_bar = test::shipped("five_bar")->manipulator(),
             three_rrr = test::shipped("three_rrr")->manipulator(),
             hexa = test::shipped("hexa")->manipulator(), eye = test::shipped("agile_eye")->manipulator();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto count = [](const auto& robot, const Box& region) {
    return problems_of(*robot, RegionQuestion{region, {}}).size();
  };
  EXPECT_EQ(count(five_bar, {2, {0.0, 0.0}, {1.0, 1.0}}), 0U);
  EXPECT_EQ(count(five_bar, {2, {0.0, 0.0}, {0.0, 1.0}}), 1U);
  EXPECT_EQ(count(five_bar, {2, {1.0, 1.0}, {0.0, 0.0}}), 2U);
  EXPECT_EQ(count(five_bar, {2, {nan, 0.0}, {1.0, 1.0}}), 1U);
  EXPECT_EQ(count(five_bar, {2, {0.0, 0.0}, {1e10, 1.0}}), 1U);
  EXPECT_EQ(count(five_bar, {3, {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}), 1U);
  EXPECT_EQ(count(three_rrr, {3, {0.0, 0.0, -7.0}, {1.0, 1.0, -6.0}}), 1U);
  EXPECT_EQ(count(three_rrr, {3, {0.0, 0.0, -4.0}, {1.0, 1.0, 4.0}}), 1U);
  EXPECT_EQ(count(three_rrr, {3, {0.0, 0.0, -4.0}, {1.0, 1.0, 1.0}}), 0U);
  EXPECT_EQ(count(three_rrr, {3, {0.0, 0.0, -3.14159}, {1.0, 1.0, 3.14159}}), 0U);
  EXPECT_EQ(count(hexa, {3, {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}), 1U);
  EXPECT_EQ(count(eye, {3, {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}), 1U);
}

TEST(CancelledRegion, IsNotProved) {
  const auto robot = test::shipped("five_bar")->manipulator()->with_constraints(ConstraintKinds{});
  const std::atomic<bool> cancelled{true};
  RegionChoiceOptions options;
  options.control.cancelled = &cancelled;
  const RegionChoice choice =
      choose_working_mode(robot, RegionQuestion{{2, {3.0, 5.0}, {6.0, 8.0}}, {}}, options);
  EXPECT_EQ(choice.answer, TrajectoryAnswer::unknown);
  for (const ModeInRegion& mode : choice.modes) EXPECT_EQ(mode.undecided, 1.0);
}

TEST(RegionWithFewBoxes, SaysHowMuchIsNotProved) {
  const auto robot = test::shipped("five_bar")->manipulator()->with_constraints(ConstraintKinds{});
  const RegionChoice choice =
      choose_working_mode(robot, RegionQuestion{{2, {2.0, 4.0}, {7.0, 9.0}}, {}}, RegionChoiceOptions{1, {}});
  EXPECT_EQ(choice.answer, TrajectoryAnswer::unknown);
  for (const ModeInRegion& mode : choice.modes)
    if (mode.answer == TrajectoryAnswer::unknown) {
      EXPECT_EQ(mode.undecided, 1.0);
    }
}

}  // namespace
}  // namespace parallel_aspects
