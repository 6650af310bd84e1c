// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/constraints/margin_tests.h"

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/singularity/indices.h"

#include <gtest/gtest.h>

#include "support/constrained_boxes.h"
#include "support/index_at.h"
#include "support/robots/constrained_robots.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/slices.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace parallel_aspects {
namespace {

using test::Robot;
using test::with;

/// Every margin at once, each so large that it shuts out something.
class MarginTestsTest : public test::ConstrainedBoxes {
 protected:
  Constraints choose(const Manipulator& plain, const Start& start) override {
    std::vector<double> indices, determinants;
    for (int i = 0; i < 100000 && indices.size() < 100; ++i) {
      const Pose pose = space->pose(test::random_position(*space, random));
      if (test::sign_at(plain, pose, start.mode).value_or(0) == 0) continue;
      const JointVector q = inverse(plain, pose, start.mode).q;
      indices.push_back(parallel_index(plain, pose, q));
      determinants.push_back(std::abs(direct_determinant(plain, pose, q)));
    }
    Constraints constraints;
    constraints.margins = {share_of(indices, 0.4), 0.15, 0.9 * share_of(determinants, 0.3)};
    return constraints;
  }

  /// Below which this share of the values lies.
  static double share_of(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size())));
  }

  double clearance(const Pose& pose) const override {
    const Margins& margins = robot->constraints().margins;
    const JointVector q = inverse(*robot, pose, mode).q;
    const test::IndexAt at(*robot, pose, q);
    return static_cast<double>(std::min({at.parallel() - margins.parallel, at.serial() - margins.serial,
                                         at.determinant() / margins.det_a - 1.0L}));
  }
};

TEST_P(MarginTestsTest, NoPoseContradictsItsBox) { expect_no_contradiction(); }

TEST_P(MarginTestsTest, SmallBoxesAreDecidedOnEitherSide) { expect_small_boxes_decided(); }

TEST_P(MarginTestsTest, SlopesAreThoseOfFiniteDifferences) {
  expect_slopes_of_finite_differences(robot->leg_count() + 3);
}

TEST_P(MarginTestsTest, FreeSegmentsKeepTheMargins) { expect_free_segments_stay(ConstraintKind::margins); }

// The indices themselves, in double precision.
TEST_P(MarginTestsTest, IndicesAreThoseOfOtherFormulas) {
  int compared = 0;
  for (int i = 0; i < 20000 && compared < 100; ++i) {
    const Pose pose = space->pose(test::random_position(*space, random));
    if (test::sign_at(*robot, pose, mode).value_or(0) == 0) continue;
    const JointVector q = inverse(*robot, pose, mode).q;
    const test::IndexAt at(*robot, pose, q);
    const auto expected = static_cast<double>(at.parallel());
    // The root of a sum that cancels is less exact where it is small.
    ASSERT_NEAR(parallel_index(*robot, pose, q), expected, 1e-12 + 1e-15 / (expected + 1e-9));
    ASSERT_NEAR(serial_indices(*robot, pose, q).minCoeff(), static_cast<double>(at.serial()), 1e-9);
    ++compared;
  }
  EXPECT_GE(compared, 100);
}

INSTANTIATE_TEST_SUITE_P(Robots, MarginTestsTest, testing::ValuesIn(test::mapped_robots()), test::name_of);

Robot five_bar_with_margin(double parallel) {
  return test::manipulator("five_bar", TaskSpace::T2,
                           {test::planar_revolute_leg(0, {0.0, 0.0}, 1.14, 0.9),
                            test::planar_revolute_leg(1, {0.6472, 0.0}, 1.14, 0.9)})
      ->with_margins({parallel, 0.0, 0.0});
}

std::vector<double> measures(const AspectMap& map) {
  std::vector<double> result;
  for (const Aspect& aspect : map.aspects()) result.push_back(aspect.measure);
  std::sort(result.rbegin(), result.rend());
  return result;
}

// Areas by brute force on grids.
TEST(Margins, ShrinkTheLargestAspectsOfAFiveBar) {
  const MapResult plain = compute_aspect_map(five_bar_with_margin(0.0));
  ASSERT_TRUE(plain.map) << plain.message;
  EXPECT_EQ(plain.map->aspects().size(), 10U);
  EXPECT_EQ(plain.map->count_at_most(), 10U);
  const MapResult kept = compute_aspect_map(five_bar_with_margin(1.0 / 15.0));
  ASSERT_TRUE(kept.map) << kept.message;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(measures(*plain.map)[i], 8.881, 0.01);
    EXPECT_NEAR(measures(*kept.map)[i], 8.77, 0.01);
  }
}

TEST(Margins, OfZeroChangeNothing) {
  const Robot plain = test::five_bar();
  EXPECT_FALSE(plain->with_margins({})->constraint_kinds()[index_of(ConstraintKind::margins)]);
  EXPECT_TRUE(five_bar_with_margin(0.1)->constraint_kinds()[index_of(ConstraintKind::margins)]);
  const ConstraintKinds none;
  EXPECT_FALSE(five_bar_with_margin(0.1)->with_constraints(none)->constraints().margins.any());
}

// Moving the tool changes no margin.
TEST(Margins, DoNotDependOnTheOperationalPoint) {
  const Robot robot = test::three_rrr();
  ManipulatorDescription description = robot->description();
  const Eigen::Vector3d shift(0.7, -0.4, 0.0);
  for (Leg& leg : description.legs) leg.anchor -= shift;
  const Manipulator moved(description);
  int compared = 0;
  for (double x = -3.0; x < 3.0; x += 0.37)
    for (double phi = -2.5; phi < 2.5; phi += 0.61) {
      const Pose pose = Pose::planar(x, 0.3 * x - 0.2, phi);
      const InverseSolution solution = inverse(*robot, pose, WorkingMode(3));
      if (solution.status != InverseStatus::solved) continue;
      const Pose same{pose.position + pose.orientation * shift, pose.orientation};
      EXPECT_NEAR(parallel_index(*robot, pose, solution.q), parallel_index(moved, same, solution.q), 1e-12);
      ++compared;
    }
  EXPECT_GT(compared, 10);
}

/// The same rods seen in the plane, but their ends are not in one plane.
Robot with_slanted_rods(const Manipulator& robot) {
  ManipulatorDescription description = robot.description();
  for (Leg& leg : description.legs) {
    leg.anchor.z() += 0.5 * leg.rod_length;
    leg.rod_length *= std::sqrt(1.25);
  }
  return std::make_shared<const Manipulator>(description);
}

// A T2 index is of the rods as they are seen in the plane, whatever chart a box is in.
TEST(Margins, OfSlicesMeasureSlantedRodsInThePlane) {
  const Robot flat = five_bar_with_margin(0.5), slanted = with_slanted_rods(*flat);
  for (const double y : {0.3, 0.9}) {
    const auto options = [y](const Robot& robot) {
      return test::options_of(test::slice_of(robot, {{"y", y}}), 0.01);
    };
    const auto of_flat = test::map_of(flat, options(flat)),
               of_slanted = test::map_of(slanted, options(slanted));
    ASSERT_EQ(of_flat->aspects().size(), of_slanted->aspects().size());
    EXPECT_GT(of_flat->aspects().size(), 2U);
    for (std::size_t i = 0; i < of_flat->aspects().size(); ++i)
      EXPECT_NEAR(measures(*of_flat)[i], measures(*of_slanted)[i], 0.01) << "y = " << y;
  }
}

TEST(Margins, OutOfTheirRangeAreRefused) {
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  for (const Margins& margins : {Margins{1.0, 0.0, 0.0},
                                 {-0.1, 0.0, 0.0},
                                 {nan, 0.0, 0.0},
                                 {0.0, 1.0, 0.0},
                                 {0.0, nan, 0.0},
                                 {0.0, 0.0, -1.0},
                                 {0.0, 0.0, nan},
                                 {0.0, 0.0, infinite}})
    EXPECT_THROW(test::five_bar()->with_margins(margins), InvalidDescription);
}

TEST(Margins, AreTextWithTheirValues) {
  EXPECT_EQ(to_string(Margins{}), "");
  EXPECT_EQ(to_string(Margins{0.05, 0.0, 20000.0}), "parallel 0.05, det_a 20000");
  const Robot robot = test::five_bar()->with_margins({0.5, 0.999, 1e9});
  const Pose pose = Pose::planar(4.5, 8.0);
  const InverseSolution found = inverse(*robot, pose, WorkingMode(2));
  ASSERT_EQ(found.status, InverseStatus::solved);
  const std::string text = missed_margins(*robot, pose, found.q);
  EXPECT_NE(text.find("the serial index of leg 'leg_1' is 0."), std::string::npos) << text;
  EXPECT_NE(text.find("; |det A| is "), std::string::npos) << text;
  EXPECT_NE(text.find(", below the margin 1e+09"), std::string::npos) << text;
  EXPECT_EQ(missed_margins(*test::five_bar(), pose, found.q), "");
}

TEST(Margins, AreNamedWhereTheyFail) {
  const Robot robot = five_bar_with_margin(0.3);
  const SegmentCertifier certifier(robot);
  const WorkingMode mode(2);
  std::optional<PoseInMode> deep, shallow;
  for (double x = -1.0; x < 1.5; x += 0.1)
    for (double y = 0.1; y < 2.0; y += 0.1) {
      const PoseInMode at{Pose::planar(x, y), mode};
      const InverseSolution found = inverse(*robot, at.pose, mode);
      if (found.status != InverseStatus::solved || direct_determinant(*robot, at.pose, found.q) < 0.0)
        continue;
      const double index = parallel_index(*robot, at.pose, found.q);
      if (index > 0.4) deep = at;
      if (index < 0.25) shallow = at;
    }
  ASSERT_TRUE(deep && shallow);
  const std::string message = same_aspect(certifier, *deep, *shallow).message;
  const double index = parallel_index(*robot, shallow->pose, inverse(*robot, shallow->pose, mode).q);
  const std::string start = "The second configuration lies in no aspect: the parallel index is ",
                    end = ", below the margin 0.3 (constraint margins).";
  ASSERT_EQ(message.substr(0, start.size()), start);
  EXPECT_NEAR(std::stod(message.substr(start.size())), index, 1e-6);
  EXPECT_EQ(message.substr(message.size() - end.size()), end);
}

}  // namespace
}  // namespace parallel_aspects
