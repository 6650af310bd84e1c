// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/uniqueness.h"

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/slices.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <vector>

namespace parallel_aspects {
namespace {

using test::Robot;
using test::uniform;

Robot unlimited_three_rpr() { return test::three_rpr()->with_constraints({}); }

/// Of it with the first strut held at 14.98, for the tests that look at it.
const std::shared_ptr<const Uniqueness>& uniqueness_of_three_rpr() {
  static const auto found = test::uniqueness_of_slice(unlimited_three_rpr(), 0, 14.98);
  return found;
}

/// The slice on a grid, filled over neighbours with the same number of direct solutions and sign of det A.
class FilledSlice {
 public:
  static constexpr int cells = 240;

  explicit FilledSlice(const Uniqueness& uniqueness)
      : robot_(*uniqueness.map->manipulator()),
        circle_(circle_of_anchor(robot_, *uniqueness.map->slice()->joint)) {
    for (int i = 0; i < cells * cells; ++i) kinds_.push_back(kind(i));
    parts_.assign(kinds_.size(), -1);
    for (int i = 0; i < cells * cells; ++i)
      if (parts_[static_cast<std::size_t>(i)] < 0) fill(i);
  }

  /// Of the cell nearest to a pose.
  int part(const Pose& pose) const {
    const Eigen::Vector2d rod = circle_.rod(pose);
    const double phi = 2.0 * std::atan2(pose.orientation.z(), pose.orientation.w());
    return parts_[static_cast<std::size_t>(index(at(std::atan2(rod.y(), rod.x())), at(phi)))];
  }

 private:
  static int at(double angle) {
    return static_cast<int>(std::floor(angle / (2.0 * EIGEN_PI) * cells + cells)) % cells;
  }
  static int index(int x, int y) { return (x + cells) % cells * cells + (y + cells) % cells; }

  int kind(int cell) const {
    const double width = 2.0 * EIGEN_PI / cells;
    const Pose pose = circle_.pose((cell / cells + 0.5) * width, (cell % cells + 0.5) * width);
    const JointVector q = inverse(robot_, pose, working_modes(robot_).front()).q;
    const auto count = static_cast<int>(direct(robot_, q).solutions.size());
    return direct_determinant(robot_, pose, q) > 0.0 ? count : -count;
  }

  void fill(int start) {
    std::vector<int> open{start};
    parts_[static_cast<std::size_t>(start)] = start;
    while (!open.empty()) {
      const int x = open.back() / cells, y = open.back() % cells, from = open.back();
      open.pop_back();
      for (const int to : {index(x + 1, y), index(x - 1, y), index(x, y + 1), index(x, y - 1)}) {
        int& part = parts_[static_cast<std::size_t>(to)];
        if (part >= 0 || kinds_[static_cast<std::size_t>(to)] != kinds_[static_cast<std::size_t>(from)])
          continue;
        part = start;
        open.push_back(to);
      }
    }
  }

  const Manipulator& robot_;
  AnchorCircle circle_;
  std::vector<int> kinds_, parts_;  // of cells
};

// Against filling the slice by the direct solver: basic regions over one set lie in parts of their own.
TEST(Uniqueness, HasTheBasicRegionsOfTheSlice) {
  const auto& found = uniqueness_of_three_rpr();
  const FilledSlice filled(*found);
  std::vector<const BasicRegion*> large;
  for (const BasicRegion& region : found->basic_regions)
    if (region.measure_lower > 10.0) large.push_back(&region);
  EXPECT_EQ(large.size(), 18U);  // two over each of two sets, four over two more, and six
  for (const BasicRegion* a : large)
    for (const BasicRegion* b : large) {
      const bool one_set = (a->actuated - b->actuated).norm() < 1e-6;
      EXPECT_TRUE(a == b || !one_set || filled.part(a->pose) != filled.part(b->pose))
          << a->actuated.transpose() << ", phi " << a->pose.orientation.z() << ' ' << b->pose.orientation.z();
    }
}

TEST(Uniqueness, HasDomainsOfOneRegionASet) {
  const auto& found = uniqueness_of_three_rpr();
  const auto same_set = [&](std::size_t a, std::size_t b) {
    return (found->basic_regions[a].actuated - found->basic_regions[b].actuated).norm() < 1e-6;
  };
  EXPECT_TRUE(found->domains_complete);
  EXPECT_GE(found->domains.size(), 6U);
  for (const UniquenessDomain& domain : found->domains) {
    for (const std::size_t a : domain.basic_regions) {
      EXPECT_EQ(found->basic_regions[a].aspect, domain.aspect);
      for (const std::size_t b : domain.basic_regions) EXPECT_TRUE(a == b || !same_set(a, b));
    }
    for (const UniquenessDomain& other : found->domains) {
      const auto &small = domain.basic_regions, &large = other.basic_regions;
      EXPECT_TRUE(&domain == &other ||
                  !std::includes(large.begin(), large.end(), small.begin(), small.end()));
    }
  }
}

// The six solutions of the region in the middle, three in each component.
TEST(Uniqueness, HasThreeOfSixSolutionsInEachComponent) {
  const auto& found = uniqueness_of_three_rpr();
  ASSERT_EQ(found->regions.size(), 3U);
  EXPECT_EQ(found->regions[2].solutions, 6U);
  for (const BasicComponent& component : found->basic_components) {
    if (component.measure_lower < 0.01) continue;
    const auto& aspects = component.aspects;
    EXPECT_EQ(std::count(aspects.begin(), aspects.end(), 1), std::count(aspects.begin(), aspects.end(), 2));
    EXPECT_EQ(std::count(aspects.begin(), aspects.end(), 0), 0);
  }
}

TEST(Uniqueness, IsTheWholeAspectWhereSolutionsAreMirrored) {
  for (const Robot& robot : {test::five_bar(), test::bipod()}) {
    const auto found = test::uniqueness_of(robot);
    EXPECT_TRUE(found->at_most_one_a_sign);
    EXPECT_TRUE(found->cusps_complete && found->cusps.empty());
    ASSERT_EQ(found->domains.size(), found->map->aspects().size());
    for (const UniquenessDomain& domain : found->domains) EXPECT_TRUE(domain.whole_aspect);
  }
}

// The theorem, by the direct solver: at random actuated values no two solutions have one sign of det A.
TEST(Uniqueness, HasOneSolutionASignInTranslations) {
  std::mt19937_64 random(11);
  for (const Robot& robot : {test::five_bar(), test::bipod(), test::delta(), test::linear_delta()})
    for (int i = 0; i < 2000; ++i) {
      JointVector q(static_cast<Eigen::Index>(robot->leg_count()));
      for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = uniform(random, -3.0, 3.0);
      const DirectResult found = direct(*robot, q);
      int signs = 0;
      for (const AssemblyMode& mode : found.solutions) signs += mode.determinant > 0.0 ? 1 : -1;
      EXPECT_LE(found.solutions.size(), 2U);
      EXPECT_TRUE(signs == 0 || found.solutions.size() < 2) << robot->name() << ' ' << q.transpose();
    }
}

TEST(Uniqueness, RefusesWhatItHasNoAnswerFor) {
  const auto problem = [](const Robot& robot, const UniquenessOptions& options) {
    return compute_uniqueness(robot, options).message;
  };
  EXPECT_NE(problem(unlimited_three_rpr(), {}).find("nothing limits how far 'leg_"), std::string::npos);
  UniquenessOptions options;
  options.slice = test::slice_of(test::three_rpr(), {{"phi", 0.0}});
  EXPECT_NE(problem(test::three_rpr(), options).find("holds an actuated joint"), std::string::npos);
  const Robot elbows = test::three_rrr_actuated_elbow();
  EXPECT_NE(problem(elbows, {}).find("has none that can be held"), std::string::npos) << problem(elbows, {});
  const Robot unlimited_slides = test::shipped("three_prr")->manipulator()->with_constraints({});
  EXPECT_NE(problem(unlimited_slides, {}).find("nothing limits how far 'slider_1_joint'"), std::string::npos)
      << problem(unlimited_slides, {});
  EXPECT_NE(problem(test::stewart(), {}).find("moves in SE3"), std::string::npos);
}

}  // namespace
}  // namespace parallel_aspects
